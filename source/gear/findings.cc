// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/gear/findings.h>

#include <algorithm>

namespace vfife
{
  void Findings::add_missing(const std::string &section, const std::string &name)
  {
    const std::string entry = section + "/" + name;
    missing_.push_back(entry);
    causes_.push_back({entry,
                       name + " is missing in section \"" + section + "\": it has no default",
                       Action::stop,
                       {}});
  }

  void Findings::add(const Action                    action,
                     const std::string              &entry,
                     const std::vector<std::string> &involved,
                     const std::string              &message)
  {
    // An entry that is missing says nothing: what involves it is dropped.
    std::vector<std::string> all = involved;
    all.insert(all.begin(), entry);
    for (const std::string &one : all)
      if (std::find(missing_.begin(), missing_.end(), one) != missing_.end())
        return;
    for (const std::string &one : all)
      // an entry found wrong before explains this finding too
      for (const Filed &filed : wrong_)
        if (filed.entry == one)
          {
            causes_[filed.cause].hence.push_back(message);
            return;
          }
    // A cause of its own: later findings that involve its entry follow from it.
    wrong_.push_back({entry, causes_.size()});
    causes_.push_back({entry, message, action, {}});
  }

  const std::vector<Findings::Cause> &Findings::causes() const
  {
    return causes_;
  }

  void Findings::raise() const
  {
    std::vector<InputError> errors;
    for (const Cause &cause : causes_)
      if (cause.action == Action::stop)
        {
          std::string message = cause.message;
          for (const std::string &one : cause.hence)
            message += "\n    hence: " + one;
          errors.emplace_back(cause.entry, message);
        }
    if (errors.size() == 1)
      throw errors.front();
    if (!errors.empty())
      throw InputErrors(errors);
  }

  std::vector<std::string> Findings::warnings() const
  {
    std::vector<std::string> messages;
    for (const Cause &cause : causes_)
      if (cause.action == Action::warn)
        messages.push_back(cause.entry + ": " + cause.message);
    return messages;
  }
} // namespace vfife
