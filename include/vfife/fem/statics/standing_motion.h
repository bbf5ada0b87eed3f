// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_fem_statics_standing_motion_h
#define vfife_fem_statics_standing_motion_h

#include <vfife/fem/system/bearing_rings.h>

#include <functional>
#include <optional>
#include <vector>

namespace vfife
{
  /**
   * What the stiffness K(u_s) - Omega^2 S of a spinning body lacks for rigid motions that are
   * stationary in space (doc/theory/fem.md, Pair in bearings). A shaft that is shifted or tilted
   * spins on about its displaced axis, at no force; in turning axes that do not see the motion turn
   * back, such motions r have the forces w = (K(u_s) - Omega^2 S) r, bearings left out. With rows
   * Phi of a mean motion, Phi r = 1, the springs
   *
   *   C = Phi^T (r^T w) Phi - Phi^T w^T - w Phi
   *
   * take them back, C r = -w, and leave alone what deforms the body within itself.
   */
  struct StandingMotion : public PointMotion
  {
    unsigned int    body = 0;  ///< of the model
    Eigen::MatrixXd stiffness; ///< of these motions; indefinite [N/mm]
  };

  /** Whether bearings are all that holds a body. */
  bool hangs_in_bearings(const Model &model, unsigned int body);

  /** Forces at all points of a body (3 a point) under displacements of all of them. */
  using BodyOperator = std::function<std::vector<double>(const std::vector<double> &u)>;

  /**
   * Of a body that turns and hangs in bearings: shifts and tilts across the axis; nothing where
   * they have no forces. @p stiffness: K(u_s) - Omega^2 S without bearings and couplings.
   */
  std::optional<StandingMotion> find_standing_motion(const FemSpace       &space,
                                                     const FemSpace::Part &part,
                                                     const BodyOperator   &stiffness,
                                                     const BodyOperator   &mass);
} // namespace vfife

#endif
