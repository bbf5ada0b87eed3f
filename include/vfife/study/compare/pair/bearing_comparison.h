// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_study_compare_pair_bearing_comparison_h
#define vfife_study_compare_pair_bearing_comparison_h

#include <vfife/study/compare/pair/pair_run.h>

namespace vfife
{
  /**
   * Rows of a gear pair on shafts: what its bearings carry, how its members are misaligned and what
   * bearings and shafts make of the transmission error, in the run and in the loaded tooth contact
   * analysis (doc/reference/sweep-and-compare.md). None where either has no bearings.
   */
  void add_supports(const PairRun &run, const ComparedCase &loaded, ComparisonRows &rows);
} // namespace vfife

#endif
