// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_study_compare_model_comparison_h
#define vfife_study_compare_model_comparison_h

#include <vfife/study/compare/compared_case.h>
#include <vfife/study/compare/comparison.h>

namespace vfife
{
  /**
   * Rows of general models: the probes at rest or in steady spin, and their lines in a `run`
   * against the frequencies of `modal`, as far as these are among the cases
   * (doc/reference/sweep-and-compare.md). Throws InputError where results cannot be read.
   */
  ComparisonRows compare_models(const ComparedCases &cases, const ComparisonTolerances &tolerances);
} // namespace vfife

#endif
