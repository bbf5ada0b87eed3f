// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_fem_system_torque_forces_h
#define vfife_fem_system_torque_forces_h

#include <vfife/fem/system/fem_space.h>

#include <vector>

namespace vfife
{
  /** Adds @p value [N mm] of a torque as tangential forces of constant traction, F_i = T A_i t_i /
   * sum A_j r_j, to forces at all points (3 a point) of the space; of a sector what its
   * own points take of the torque. A_i: nodal areas with 8 points, else integrals of the shape
   * functions over the faces. */
  void add_torque_forces(const Torque         &torque,
                         const FemSpace       &space,
                         const FemSpace::Part &part,
                         double                value,
                         std::vector<double>  &forces);
} // namespace vfife

#endif
