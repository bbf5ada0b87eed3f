// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_fem_statics_adaptive_refinement_h
#define vfife_fem_statics_adaptive_refinement_h

#include <vfife/fem/system/fem_space.h>

#include <vector>

namespace vfife
{
  /**
   * Error indicator of each element of the space [mm^1.5], from jumps of the displacements' normal
   * derivative between elements: dealii::KellyErrorEstimator (Kelly, Gago, Zienkiewicz, Babuska
   * 1983, eq. 22). Where two materials meet, the derivative of the true solution jumps too, so that
   * these elements count as inexact. @p displacements: of all points, 3 a point [mm].
   */
  std::vector<double> estimate_errors(const FemSpace            &space,
                                      const std::vector<double> &displacements);

  /**
   * The fewest elements that hold @p part of the sum of the squared @p indicators (Doerfler 1996):
   * a further step of FemSpaceOptions::divisions.
   */
  FemSpaceOptions::Division
  mark_elements(const FemSpace &space, const std::vector<double> &indicators, double part);
} // namespace vfife

#endif
