// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_dynamics_operator_mass_scaling_h
#define vfife_dynamics_operator_mass_scaling_h

namespace vfife
{
  class Log;
  struct DynamicsOptions;
  struct Model;

  /**
   * Selective mass scaling: elements whose stable step is below DynamicsOptions::mass_scaling_step
   * get their lumped masses times (that step / their own)^2, which makes it their step exactly.
   * Body::added_mass() has the sum. The operator must be told the same step (OperatorLayout). Does
   * nothing where the step is zero. Throws InputError where a body would gain more than
   * DynamicsOptions::largest_added_mass of its mass.
   */
  void scale_masses(const DynamicsOptions &options, Model &model, Log &log);
} // namespace vfife

#endif
