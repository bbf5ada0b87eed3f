// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_study_compare_compare_study_h
#define vfife_study_compare_compare_study_h

#include <vfife/study/study_kind.h>

#include <memory>

namespace vfife
{
  class CaseRunner;

  /**
   * Study kind `compare`: does explicit, conventional and lumped cases of the same thing, or reads
   * what they have left, and writes their numbers beside each other: comparison.json,
   * comparison.csv.
   *
   * Each case has a folder of its name in that of the study. A case that is finished there with the
   * same parameters is read; one with a checkpoint goes on.
   */
  std::unique_ptr<StudyKind> make_compare_study(const CaseRunner &runner);
} // namespace vfife

#endif
