// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_study_study_kinds_h
#define vfife_study_study_kinds_h

#include <vfife/base/parameters/parameters.h>
#include <vfife/study/study_kind.h>

#include <memory>
#include <string>

namespace vfife
{
  class CaseRunner;

  /** Makes a study; one that is made of cases does them by the runner, which outlives it. */
  using MakeStudy = std::unique_ptr<StudyKind> (*)(const CaseRunner &);

  /** A kind of study as the table has it. */
  struct KnownStudy
  {
    MakeStudy make = nullptr;
    /** The file that a study writes last: where it is, all results are. A summary.json says so
     * itself, by its status. Empty for kinds of which no file tells. */
    std::string last_file;

    bool operator==(const KnownStudy &other) const
    {
      return make == other.make;
    }
  };

  /** All kinds of studies by their words in `Study/kind`. */
  const Choices<KnownStudy> &study_kinds();

  /** Section Study. */
  struct StudyOptions
  {
    KnownStudy  kind          = study_kinds().front().second;
    std::string output_folder = "results";

    void declare(dealii::ParameterHandler &prm);
  };
} // namespace vfife

#endif
