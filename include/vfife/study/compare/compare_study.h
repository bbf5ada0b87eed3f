// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_study_compare_compare_study_h
#define vfife_study_compare_compare_study_h

#include <vfife/study/compare/compared_case.h>
#include <vfife/study/compare/comparison.h>
#include <vfife/study/study_kind.h>

#include <string>
#include <vector>

namespace vfife
{
  class CaseRunner;
  struct CommandLine;

  /**
   * Study kind `compare`: does explicit, conventional and lumped cases of the same thing, or reads
   * what they have left, and writes their numbers beside each other: comparison.json,
   * comparison.csv.
   *
   * Each case has a folder of its name in that of the study. A case that is finished there with the
   * same parameters is read; one with a checkpoint goes on.
   */
  class CompareStudy : public StudyKind
  {
  public:
    explicit CompareStudy(const CaseRunner &runner);

    void declare(dealii::ParameterHandler &prm, const ParameterFile &file) override;
    /** Reads every case that is to be done. */
    void        check() const override;
    void        inspect(Communicator &communicator, Log &log) override;
    std::size_t resume(const std::string  &folder,
                       const EntryValues  &now,
                       const Communicator &communicator,
                       Log                &log) override;
    void        run(OutputFolder &folder, Log &log) override;
    std::string last_file() const override;

  private:
    struct Case
    {
      std::string name, base, entries, results;
    };

    void        declare_own(dealii::ParameterHandler &prm);
    void        check_case(const Case &one) const;
    CommandLine command_line(const Case &one, const std::string &folder) const;
    /** Entries "A/B/name = value; ...", {NAME} replaced by the folder of that case. */
    std::vector<std::string> list_entries(const std::string &text, const std::string &folder) const;
    std::string              folder_of(const Case &one, const std::string &folder) const;
    ComparedCase             do_one(const Case &one, OutputFolder &folder, Log &log) const;

    const CaseRunner        &runner_;
    std::string              title_, entries_;
    std::vector<std::string> names_;
    std::vector<Case>        cases_;
    ComparisonTolerances     tolerances_;
    bool                     pictures_ = true;
  };
} // namespace vfife

#endif
