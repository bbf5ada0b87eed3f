// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/process/log.h>
#include <vfife/study/cases/case.h>

namespace vfife
{
  void Case::check_bodies() const
  {
    check();
  }

  void Case::set_defaults(DynamicsOptions &, OutputOptions &) const
  {
  }

  void Case::declare_run(dealii::ParameterHandler &)
  {
  }

  bool Case::may_be_made_longer() const
  {
    return true;
  }

  double Case::ramp_time() const
  {
    return 0.;
  }

  bool Case::has_teeth() const
  {
    return false;
  }

  HertzContact Case::hertz_contact() const
  {
    return {};
  }

  std::optional<std::array<BlankOutline, 2>> Case::outlines() const
  {
    return {};
  }

  std::optional<Vector2> Case::arm_range() const
  {
    return {};
  }

  std::optional<EdgesUnderLoad> Case::edges_under_load() const
  {
    return {};
  }

  std::vector<std::string> Case::find_contradictions(const RunPlan &) const
  {
    return {};
  }

  void log_contradictions(const std::vector<std::string> &found, Log &log)
  {
    for (const std::string &sentence : found)
      log.line("check: ", sentence);
    if (found.empty())
      log.line("check: no contradictions");
  }
} // namespace vfife
