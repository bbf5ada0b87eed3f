// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
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

  std::vector<unsigned int> Case::list_lengths(const DynamicsOptions &) const
  {
    return {};
  }

  void Case::set_length(unsigned int)
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

  bool Case::leaves_penalty_open() const
  {
    return false;
  }

  std::optional<Model> Case::make_reference_model() const
  {
    return std::nullopt;
  }

  std::optional<Model> Case::make_submodel_mesh(unsigned int) const
  {
    return std::nullopt;
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

  std::vector<std::string> Case::report_checks(const RunPlan &, Log &) const
  {
    return {};
  }

  std::string Case::find_cause() const
  {
    return {};
  }
} // namespace vfife
