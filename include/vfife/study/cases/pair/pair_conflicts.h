// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_study_cases_pair_pair_conflicts_h
#define vfife_study_cases_pair_pair_conflicts_h

#include <vfife/study/cases/torque_pressure.h>

#include <optional>
#include <string>

namespace vfife
{
  /** What a kind of gears knows of its pair before a study computes: what PairCase::report_checks()
   * looks at (doc/reference/kinds.md lists the checks). */
  struct PairFacts
  {
    double ring_strain; ///< of a free ring at the pitch circles at the largest speed
    bool   has_web;     ///< whether the gear's rim is carried by an elastic web
    std::optional<TorquePressure> pressure; ///< of one tooth pair under all the torque
    std::string fault_of_path; ///< of the unloaded path of contact; empty: none, or not looked at
  };
} // namespace vfife

#endif
