// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_reduced_real_body_h
#define vfife_reduced_real_body_h

#include <vfife/base/text/table.h>
#include <vfife/reduced/reduced_body.h>

namespace vfife
{
  struct Model;

  /**
   * A reduced body as other programs take it, in real coordinates x and axes that turn with it
   * (doc/reference/kinds.md, reduced):
   *   M x'' + 2 Omega G x' + (K + (Omega^2 - Omega_0^2) D) x = f
   * Of each mode with 0 < h < N/2 the real and the imaginary part are a coordinate, and the turn of
   * a body that turns freely is the last one.
   */
  struct RealBody
  {
    Eigen::MatrixXd mass, stiffness;          ///< M, and K at the body's rate Omega_0
    Eigen::MatrixXd coriolis, spin_stiffness; ///< G, antisymmetric, and D
    Eigen::MatrixXd shapes;                   ///< what the rows read of x
    /** What the first rows, those of flank nodes, are at once under unit forces there [mm/N]. */
    Eigen::MatrixXd residual;
    Eigen::MatrixXd torque; ///< f of a unit torque about the axis, one column [1/(N mm)]
    /** Springs of a body in bearings that the stiffness contains: of the seats of its bearings, six
     * rows each in the order of the rows; other bearings take their place by what they differ. */
    Eigen::MatrixXd seats;
    Table coordinates; ///< number, nodal diameters, part, frequency without Coriolis forces
    /** Number, name, unit, value in the state of spin and at once under a unit torque. */
    Table rows;
  };

  /** Rows: flank nodes of sector 0 along the axes of the body frame, the mean rotations of bore and
   * rim that the body has, its probes in the sectors where they are, their axes those of the body
   * frame turned back into sector 0, and the rings of a body in bearings, body frame. */
  RealBody make_real_body(const ReducedBody &body, const Model &model, unsigned int number);
} // namespace vfife

#endif
