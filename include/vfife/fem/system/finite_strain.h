// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_fem_system_finite_strain_h
#define vfife_fem_system_finite_strain_h

#include <vfife/fem/system/element_integrals.h>

namespace vfife
{
  /**
   * Which strain Hooke's law takes where displacements are not infinitesimal, as in the state of
   * spin; F = R U the deformation gradient. biot: U - 1, the linear strain in turned axes, as in
   * explicit dynamics. green: (F^T F - 1)/2, as other programs do (St. Venant and Kirchhoff). Both
   * differ by the square of the strain, their stiffness by the order of the strain.
   */
  enum class StrainMeasure
  {
    biot,
    green
  };

  /** "biot", "green". */
  const Choices<StrainMeasure> &strain_measure_choices();

  using Matrix9 = Eigen::Matrix<double, 9, 9>;

  /** A material point: the energy and its derivatives to the displacement gradient. */
  struct StrainState
  {
    double          energy = 0; ///< per volume [mJ/mm^3]
    Eigen::Matrix3d stress;     ///< first Piola-Kirchhoff, d energy / d H [MPa]
    /** d stress / d H [MPa], row and column 3 * derivative + component. */
    Matrix9 tangent;
  };

  /** @p H: the displacement gradient F - 1. Exact to round-off also for the smallest strains. */
  StrainState
  compute_strain_state(const Eigen::Matrix3d &H, const Material &material, StrainMeasure measure);

  /** An element of @p X displaced by u: energy, forces and tangent stiffness, bubbles condensed. */
  struct ElementState
  {
    double          energy = 0; ///< [mJ]
    Eigen::VectorXd forces;     ///< d energy / d u [N]
    Eigen::MatrixXd tangent;    ///< d forces / d u [N/mm], symmetric; empty unless asked for
  };

  /**
   * At the points of compute_element_points(). The gradients of incompatible modes are added to the
   * displacement gradient; their amplitudes are those without force. At u = 0 the tangent is
   * compute_fem_stiffness(). Throws NumericalError where the amplitudes are not found.
   */
  ElementState compute_element_state(const ElementNodes    &X,
                                     const Material        &material,
                                     FemElement             element,
                                     StrainMeasure          measure,
                                     const Eigen::VectorXd &u,
                                     bool                   with_tangent);
} // namespace vfife

#endif
