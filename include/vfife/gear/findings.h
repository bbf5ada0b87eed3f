// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_gear_findings_h
#define vfife_gear_findings_h

#include <sstream>
#include <string>
#include <vector>

namespace vfife
{
  /** A message made of text and numbers. */
  template <typename... Parts>
  std::string text_of(const Parts &...parts)
  {
    std::ostringstream message;
    (message << ... << parts);
    return message.str();
  }

  /**
   * Contradictions in what a user gave, each filed once: a finding that involves an entry which is
   * already found wrong follows from that one and is no cause of its own; a finding that involves a
   * missing entry says nothing and is dropped. Hence the surest findings are added first.
   */
  class Findings
  {
  public:
    enum class Action
    {
      stop, ///< the program cannot go on
      warn  ///< the message says which value wins
    };

    struct Cause
    {
      std::string              entry; ///< full path of the entry that is wrong
      std::string              message;
      Action                   action = Action::stop;
      std::vector<std::string> hence; ///< what follows from it
    };

    /** The entry has no default and is not given. */
    void add_missing(const std::string &section, const std::string &name);

    /**
     * @p entry is wrong or contradicts the entries @p involved (full paths); the message names the
     * values.
     */
    void add(Action                          action,
             const std::string              &entry,
             const std::vector<std::string> &involved,
             const std::string              &message);

    const std::vector<Cause> &causes() const;

    /** Throws InputErrors with all causes that stop the program, if there are any. */
    void raise() const;

    /** The messages of the causes that do not. */
    std::vector<std::string> warnings() const;

  private:
    struct Filed
    {
      std::string entry;
      std::size_t cause;
    };

    std::vector<Cause>       causes_;
    std::vector<Filed>       wrong_;
    std::vector<std::string> missing_;
  };
} // namespace vfife

#endif
