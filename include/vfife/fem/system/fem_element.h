// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_fem_system_fem_element_h
#define vfife_fem_system_fem_element_h

#include <vfife/base/parameters/parameters.h>
#include <vfife/element/material.h>

#include <Eigen/Core>

#include <vector>

namespace vfife
{
  /**
   * incompatible_modes and full: 8 nodes with the stiffness of element/stiffness.h; quadratic: 27
   * nodes (triquadratic displacements) on the same trilinear geometry, 3x3x3 points.
   */
  enum class FemElement
  {
    incompatible_modes,
    full,
    quadratic
  };

  /**
   * consistent: rho int N_a N_b dV; lumped: its row sums (8 nodes, the masses of explicit dynamics)
   * or its diagonal scaled to the element's mass (27 nodes, whose row sums are not positive;
   * Hinton, Rock & Zienkiewicz 1976).
   */
  enum class MassKind
  {
    consistent,
    lumped
  };

  /** "incompatible modes", "full", "quadratic". */
  const Choices<FemElement> &fem_element_choices();
  /** "consistent", "lumped". */
  const Choices<MassKind> &mass_choices();

  /** Node positions of an element [mm], a column a node, lexicographic (x fastest), 8 or 27. */
  using ElementNodes = Eigen::Matrix<double, 3, Eigen::Dynamic>;

  /** Shape functions, their gradients [1/mm] and det J times the weight [mm^3] at a point. */
  struct ElementPoint
  {
    Eigen::VectorXd N;
    ElementNodes    gradients;
    double          weight = 0;
  };

  /**
   * The points of an element: 2x2x2 for 8 nodes, 3x3x3 for 27 nodes. Throws NumericalError where
   * det J <= 0.
   */
  std::vector<ElementPoint> compute_element_points(const ElementNodes &X);

  /** Stiffness [N/mm], DoF 3 * node + component. */
  Eigen::MatrixXd
  compute_fem_stiffness(const ElementNodes &X, const Material &material, FemElement element);

  /** n x n mass coefficients m_ab [t]; the mass matrix is m_ab times the identity of components. */
  Eigen::MatrixXd compute_mass_coefficients(const ElementNodes &X, double density, MassKind kind);

  /**
   * Stress xx yy zz xy yz zx [MPa] at the points of compute_element_points() for the displacements
   * @p u (3n) [mm], one column a point; bubbles of incompatible modes are recovered.
   */
  Eigen::Matrix<double, 6, Eigen::Dynamic> compute_point_stresses(const ElementNodes    &X,
                                                                  const Material        &material,
                                                                  FemElement             element,
                                                                  const Eigen::VectorXd &u);

  /** The 3n x 3n matrix with the blocks @p coefficients(a, b) * @p block. */
  Eigen::MatrixXd expand_coefficients(const Eigen::MatrixXd &coefficients,
                                      const Eigen::Matrix3d &block);
} // namespace vfife

#endif
