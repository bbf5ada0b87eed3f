// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_fem_system_rigid_motions_h
#define vfife_fem_system_rigid_motions_h

#include <vfife/fem/system/fem_space.h>

#include <vector>

namespace vfife
{
  /**
   * Rigid motions of body @p part that the model's constraints leave free, as displacements of all
   * points (one vector per motion, zero on other bodies).
   */
  std::vector<std::vector<double>> find_free_motions(const FemSpace       &space,
                                                     const FemSpace::Part &part);

  /** Coefficients of these, a column each, in make_rigid_motions() about @p centre. */
  Eigen::MatrixXd
  find_free_coefficients(const FemSpace &space, const FemSpace::Part &part, const Vector3 &centre);

  /** The six rigid motions of @p part, three translations and three rotations about @p centre. */
  std::vector<std::vector<double>>
  make_rigid_motions(const FemSpace &space, const FemSpace::Part &part, const Vector3 &centre);
} // namespace vfife

#endif
