// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/text/nearest_name.h>
#include <vfife/output/files/checkpoint.h>
#include <vfife/study/continuation.h>

#include <algorithm>
#include <map>

namespace vfife
{
  void refuse_changes(const EntryValues              &before,
                      const EntryValues              &now,
                      const std::vector<std::string> &changeable)
  {
    const std::map<std::string, std::string> old(before.begin(), before.end());
    const std::map<std::string, std::string> fresh(now.begin(), now.end());
    const auto text = [](const auto &values, const std::string &entry) {
      const auto found = values.find(entry);
      return found == values.end() ? "not there" : "\"" + found->second + "\"";
    };

    // Entries of both: one that either has alone has changed as well. All are named at once, as a
    // user would mend them at once.
    std::map<std::string, std::string> all = old;
    all.insert(fresh.begin(), fresh.end());
    std::vector<InputError> errors;
    for (const auto &entry : all)
      {
        const std::string &name = entry.first;
        const bool         may_change =
          std::find(changeable.begin(), changeable.end(), name) != changeable.end();
        if (!may_change && text(old, name) != text(fresh, name))
          errors.emplace_back(name,
                              "is " + text(fresh, name) + ", but the run was begun with " +
                                text(old, name) +
                                (changeable.empty() ? ""
                                                    : "; a run that goes on may change only " +
                                                        list_of(changeable, true)));
      }
    if (errors.size() == 1)
      throw InputError(errors.front());
    if (!errors.empty())
      throw InputErrors(errors);
  }

  Checkpoint find_checkpoint(const std::string              &folder,
                             const EntryValues              &now,
                             const std::vector<std::string> &changeable,
                             const Communicator             &communicator,
                             Log                            &log)
  {
    // The entries that the checkpoint holds are those the run was begun with, whatever file stands
    // in the folder now.
    Checkpoint checkpoint = read_checkpoint(folder, communicator, log);
    refuse_changes(checkpoint.parameters, now, changeable);
    return checkpoint;
  }
} // namespace vfife
