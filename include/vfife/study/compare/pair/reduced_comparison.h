// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_study_compare_pair_reduced_comparison_h
#define vfife_study_compare_pair_reduced_comparison_h

#include <vfife/study/compare/comparison.h>

namespace vfife
{
  class PairRun;

  /** Rows of an explicit run against the reduced pair of the same file
   * (doc/reference/sweep-and-compare.md): means, curves over the mesh cycle, orders of the mesh
   * frequency, swing. */
  void add_reduced(const PairRun &run, const PairRun &reduced, ComparisonRows &rows);
} // namespace vfife

#endif
