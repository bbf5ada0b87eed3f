// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_study_case_runner_h
#define vfife_study_case_runner_h

#include <string>
#include <utility>
#include <vector>

namespace vfife
{
  struct CommandLine;
  class Communicator;
  class Log;

  /** Entries by path ("A/B/name") with their values as texts. */
  using EntryValues = std::vector<std::pair<std::string, std::string>>;

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
    bool        is_input = false; ///< whether the input has made it fail

    /** "finished", "failed: why". */
    std::string describe() const;
  };

  /** A parameter file that has been read and checked. */
  struct CaseFile
  {
    EntryValues entries;   ///< in force
    EntryValues allowed;   ///< what their values may be, DeclaredSection::Entry::pattern
    std::string last_file; ///< KnownStudy::last_file

    /** Of an entry by its path; empty where there is none. */
    std::string value(const std::string &entry) const;

    /** Whether an entry is a whole number. */
    bool is_count(const std::string &entry) const;
  };

  /**
   * Reads and does other cases, for studies that are made of cases: these are handed one, since
   * they stand among the kinds that it knows.
   */
  class CaseRunner
  {
  public:
    virtual ~CaseRunner() = default;

    /** Throws InputError (complete message). */
    virtual CaseFile read(const CommandLine &line) const = 0;

    /** The same for a case that could begin now: its files have to be there, and its gears can be
     * made. Without meshes. */
    virtual CaseFile check(const CommandLine &line) const = 0;

    /** Throws InputError (complete message), NumericalError and Interrupted. Collective. */
    virtual void run(const CommandLine &line, Communicator &communicator, Log &log) const = 0;

    /**
     * Does a case, with a log of its own in its output folder. With @p resumes a case that is
     * finished with the same entries and the same content of the files that they name is kept, and
     * one with a checkpoint goes on; where the checkpoint is of another input the case is computed
     * again, and the report says why. Bad input and failing numbers are reported, not thrown.
     * Collective.
     */
    CaseReport do_case(CommandLine line, bool resumes, Communicator &communicator) const;

  private:
    /** What a folder has of an earlier case. */
    struct Earlier
    {
      std::string change; ///< in which its results are not those of the case; empty: in nothing
      bool        has_checkpoint = false, has_results = false;
    };

    Earlier     look_at_earlier(const CommandLine &line, const Communicator &communicator) const;
    std::string find_change(const CommandLine &line) const;
    void        put_away(const CommandLine &line, Communicator &communicator, Log &log) const;
    CaseReport  do_or_report(const CommandLine &line, Communicator &communicator, Log &log) const;
  };

  /**
   * What cases have otherwise than their files, "Section/name = value; ...", as the overrides of a
   * command line. @throws InputError, of @p entry, for what has no "=".
   */
  std::vector<std::string> split_entries(const std::string &text, const std::string &entry);
} // namespace vfife

#endif
