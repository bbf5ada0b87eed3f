// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_study_cases_pair_pair_conflicts_h
#define vfife_study_cases_pair_pair_conflicts_h

#include <vfife/study/cases/pair_case.h>
#include <vfife/study/cases/torque_pressure.h>

#include <optional>
#include <string>
#include <vector>

namespace vfife
{
  /** What a kind of gears knows of its pair before a study computes. */
  struct PairFacts
  {
    double ring_strain; ///< of a free ring at the pitch circles at the largest speed
    bool   has_web;     ///< whether the gear's rim is carried by an elastic web
    std::optional<TorquePressure> pressure; ///< of one tooth pair under all the torque
    std::string fault_of_path; ///< of the unloaded path of contact; empty: none, or not looked at
  };

  /** Finds what a user will not expect of a study (doc/reference/kinds.md lists the checks): a
   * sentence each, logged and returned. */
  std::vector<std::string> report_conflicts(const PairCase  &pair_case,
                                            const PairFacts &facts,
                                            const RunPlan   &plan,
                                            Log             &log);
} // namespace vfife

#endif
