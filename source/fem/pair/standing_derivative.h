// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_fem_standing_derivative_h
#define vfife_fem_standing_derivative_h

#include <vfife/fem/system/fem_space.h>

#include <vector>

namespace vfife
{
  /**
   * rate u': what material that turns at @p rate [rad/s] of each body about its axis sees of a
   * displacement field that stands still in space; u' is the derivative along the circumference,
   * vectors turning along, by central differences of fourth order over equal sectors. Zero on
   * bodies of fewer than five sectors.
   */
  std::vector<double> apply_standing_derivative(const FemSpace            &space,
                                                const std::vector<double> &u);
} // namespace vfife

#endif
