// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_study_cases_gear_gear_conflicts_h
#define vfife_study_cases_gear_gear_conflicts_h

#include <vfife/gear/spiral_bevel/gear_pair.h>
#include <vfife/study/cases/pair_case.h>

#include <string>
#include <vector>

namespace vfife
{
  /** What is known of a spiral bevel pair before its study computes. */
  struct GearFacts
  {
    const PairCase &pair_case;
    const GearPair &pair;
    MeshSide        side;        ///< whose flanks carry the load
    double          ring_strain; ///< of a free ring at the pitch circles at the largest speed
    bool            has_web;     ///< whether the gear's rim is carried by an elastic web
    std::string     excess_of_pressure; ///< what is wrong with Hertz's pressure; empty for nothing
  };

  /** Finds what a user will not expect of a study (doc/reference/kinds.md lists the checks): a
   * sentence each, logged and returned. */
  std::vector<std::string> report_conflicts(const GearFacts &gears, const RunPlan &plan, Log &log);
} // namespace vfife

#endif
