// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_study_cases_pair_checks_h
#define vfife_study_cases_pair_checks_h

#include <string>
#include <vector>

namespace vfife
{
  class GearCase;
  struct RunPlan;

  /** Case::find_contradictions() of a gear pair; doc/study.md lists the checks. */
  std::vector<std::string> find_pair_contradictions(const GearCase &gear_case, const RunPlan &plan);
} // namespace vfife

#endif
