// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_element_stiffness_h
#define vfife_element_stiffness_h

#include <vfife/base/parameters/parameters.h>
#include <vfife/element/hexahedron.h>
#include <vfife/element/material.h>

namespace vfife
{
  /**
   * incompatible_modes: QM6 (Taylor, Beresford & Wilson 1976): 2x2x2 points and three internal
   * bubbles 1 - xi_a^2, whose gradients use the Jacobian of the centre times det J0 / det J so
   * that the patch test is passed; condensed statically. Bends without locking.
   * full: plain 2x2x2 points; locks in bending, kept for comparison.
   * one_point: the stress of the mean gradients, and against hourglass patterns a physical
   * stabilization without a parameter (Belytschko & Bindeman 1993, Puso 2000): the patterns'
   * strains with the Jacobian of the centre, those that lock relaxed by the same bubbles,
   * integrated exactly. Equals incompatible_modes where the element is a parallelepiped.
   */
  enum class StiffnessKind
  {
    incompatible_modes,
    full,
    one_point
  };

  /** "incompatible modes", "full integration", "reduced integration". */
  const Choices<StiffnessKind> &stiffness_choices();

  /** Isotropic D for strains (xx yy zz xy yz zx) with engineering shears [MPa]. */
  Eigen::Matrix<double, 6, 6> compute_elasticity(const Material &material);

  /** 6 x 3n matrix of strains (xx yy zz xy yz zx) of n functions with gradients in columns. */
  Eigen::MatrixXd compute_strain_matrix(const Eigen::Matrix<double, 3, Eigen::Dynamic> &gradients);

  /**
   * An element before condensation, at its 2x2x2 points: what stress recovery and stiffness share.
   * @p bubbles is empty for StiffnessKind::full.
   */
  struct ElementStrains
  {
    Eigen::Matrix<double, 6, 24> displacement[8]; ///< strain of the nodal displacements [1/mm]
    Eigen::Matrix<double, 6, 9>  bubble[8];       ///< strain of the condensed bubbles [1/mm]
    double                       weight[8];       ///< det J; one_point: an eighth of V [mm^3]
    bool                         has_bubbles;
  };

  /** Throws NumericalError when det J <= 0 at a Gauss point, for every kind. */
  ElementStrains compute_element_strains(const HexahedronNodes &X, StiffnessKind kind);

  /** Bubble amplitudes (9) in terms of nodal displacements: alpha = A u, with no force on alpha. */
  Eigen::Matrix<double, 9, 24> compute_bubble_recovery(const ElementStrains &strains,
                                                       const Material       &material);

  /** The amplitudes alpha of displacements @p u, at a fraction of the cost of A. */
  Eigen::Matrix<double, 9, 1> compute_bubbles(const ElementStrains               &strains,
                                              const Material                     &material,
                                              const Eigen::Matrix<double, 24, 1> &u);

  /**
   * Stiffness [N/mm], symmetric, DoF 3 * node + component, in the axes of @p X [mm].
   * Throws NumericalError when det J <= 0 at a Gauss point.
   */
  Matrix24
  compute_stiffness(const HexahedronNodes &X, const Material &material, StiffnessKind kind);
} // namespace vfife

#endif
