// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_fem_statics_standing_motion_h
#define vfife_fem_statics_standing_motion_h

#include <vfife/fem/system/system_matrices.h>

#include <vector>

namespace vfife
{
  /**
   * What the stiffness K(u_s) - Omega^2 S of a spinning body lacks for rigid motions that stand in
   * space (doc/theory/fem.md, Pair in bearings). A shaft that is shifted or tilted spins on about
   * its displaced axis, at no force; in turning axes that do not see the motion turn back, such
   * motions r have the forces w = (K(u_s) - Omega^2 S) r, bearings left out. With rows Phi of a
   * mean motion, Phi r = 1, the springs
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

  /**
   * Of bodies that turn, hang in bearings and have no constraints: shifts and tilts across the
   * axis.
   * @p stiffness: K(u_s) - Omega^2 S with that of the bearings. Collective.
   */
  std::vector<StandingMotion> find_standing_motions(const SystemMatrices       &matrices,
                                                    const FemMatrix            &stiffness,
                                                    const SystemMatrices::Rate &rate);
} // namespace vfife

#endif
