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

  /** All kinds of studies by their words in `Study/kind`. */
  const Choices<MakeStudy> &study_kinds();

  /** Section Study. */
  struct StudyOptions
  {
    MakeStudy   kind          = study_kinds().front().second;
    std::string output_folder = "results";

    void declare(dealii::ParameterHandler &prm);
  };
} // namespace vfife

#endif
