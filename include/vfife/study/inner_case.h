// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_study_inner_case_h
#define vfife_study_inner_case_h

#include <string>
#include <vector>

namespace vfife
{
  struct CommandLine;
  class Communicator;

  /** What has become of a case that a study does with others. */
  enum class Outcome
  {
    waits,
    finished,
    failed,
    interrupted
  };

  /** "waits", "finished"... */
  std::string word_for(Outcome outcome);

  /** How a case has ended. */
  struct CaseReport
  {
    Outcome     outcome = Outcome::waits;
    std::string message;

    /** "finished", "failed: why". */
    std::string describe() const;
  };

  /**
   * What cases have otherwise than their files, "Section/name = value; ...", as the overrides of a
   * command line. @throws InputError, of @p entry, for what has no "=".
   */
  std::vector<std::string> split_entries(const std::string &text, const std::string &entry);

  /**
   * Whether the output folder of @p line has the results of that case, with the same parameters: a
   * summary that says "finished", or the last file of studies that write none. Collective.
   */
  bool is_finished(const CommandLine &line, const Communicator &communicator);

  /**
   * Does a case, with a log of its own in its output folder. With @p goes_on a finished case is
   * kept, and one with a checkpoint goes on. Bad input and failing numbers are reported, not
   * thrown. Collective.
   */
  CaseReport do_case(CommandLine line, bool goes_on, Communicator &communicator);
} // namespace vfife

#endif
