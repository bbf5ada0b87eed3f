// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_fem_system_load_forces_h
#define vfife_fem_system_load_forces_h

#include <vfife/fem/system/fem_space.h>

#include <utility>
#include <vector>

namespace vfife
{
  struct BoundaryFace;

  /** The points of the elements' faces on a face of the body, and their places [mm]. */
  std::vector<std::pair<std::vector<unsigned int>, ElementNodes>>
  points_of_face(const FemSpace &space, const FemSpace::Part &part, const BoundaryFace &face);

  /**
   * Adds a load of the model times @p factor to forces at all points (3 a point) [N]: the nodal
   * forces of explicit dynamics in the undeformed places; of degree 2 and 3 and of divided
   * elements, integrals of tractions and body forces with the shape functions. Springs add nothing.
   * Throws InputError for a load that its nodes cannot carry.
   */
  void add_load_forces(const Load           &load,
                       const FemSpace       &space,
                       const FemSpace::Part &part,
                       double                factor,
                       std::vector<double>  &forces);

  /** Adds @p value [N mm] of a torque as tangential forces of constant traction, F_i = T A_i t_i /
   * sum A_j r_j, to forces at all points (3 a point) of the space; of a sector what its
   * own points take of the torque. A_i: nodal areas with 8 points, else integrals of the shape
   * functions over the faces. */
  void add_torque_forces(const Torque         &torque,
                         const FemSpace       &space,
                         const FemSpace::Part &part,
                         double                value,
                         std::vector<double>  &forces);

  /** Shares of one by area, as compute_area_shares(), with the points of quadratic elements between
   * the nodes. */
  PointWeights point_area_shares(const Body                      &body,
                                 const std::vector<unsigned int> &nodes,
                                 const SelectedFaces             &selected,
                                 const FemSpace                  &space,
                                 const FemSpace::Part            &part);

  /** Stiffnesses [N/mm] of a spring to the ground, by point. Throws InputError on one sector of a
   * body. */
  std::vector<std::pair<unsigned int, Matrix3>> find_springs(const Load     &load,
                                                             const FemSpace &space);

  /** Stiffnesses [N/mm] of the model's springs to the ground, by point. Throws InputError for
   * springs on one sector of a body. */
  std::vector<std::pair<unsigned int, Matrix3>> find_springs(const FemSpace &space);
} // namespace vfife

#endif
