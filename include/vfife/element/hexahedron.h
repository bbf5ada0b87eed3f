// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_element_hexahedron_h
#define vfife_element_hexahedron_h

#include <vfife/base/types.h>

namespace vfife
{
  /**
   * One column a node [mm], in deal.II's lexicographic order: node a = i + 2 j + 4 k sits at
   * (xi, eta, zeta) = (2 i - 1, 2 j - 1, 2 k - 1) of the reference cube [-1, 1]^3.
   *
   *        6-------7
   *       /|      /|
   *      4-------5 |     zeta
   *      | 2-----|-3      |  eta
   *      |/      |/       | /
   *      0-------1        |/___ xi
   */
  using HexahedronNodes = Eigen::Matrix<double, 3, 8>;

  /** Row 3 * node + component. */
  using Vector24 = Eigen::Matrix<double, 24, 1>;
  using Matrix24 = Eigen::Matrix<double, 24, 24>;

  /** Corner @p node of the reference cube, entries -1 or 1. */
  Vector3 reference_corner(unsigned int node);

  /** Point @p q (lexicographic) of the 2x2x2 Gauss rule, entries -+1/sqrt(3); each weight is 1. */
  Vector3 gauss_point(unsigned int q);

  /** Trilinear shape functions N_a at @p xi. */
  Eigen::Matrix<double, 8, 1> shape_functions(const Vector3 &xi);

  /** dN_a/dxi_j at @p xi, one column a node. */
  HexahedronNodes reference_gradients(const Vector3 &xi);

  /** Sign h_k of hourglass pattern k = 0..3 at @p node: the functions eta zeta, xi zeta, xi eta and
   * xi eta zeta at its corner, all +-1. */
  double hourglass_sign(unsigned int k, unsigned int node);

  /** J_ij = dX_i/dxi_j at @p xi [mm]. */
  Matrix3 compute_jacobian(const HexahedronNodes &nodes, const Vector3 &xi);

  /** Volume [mm^3], exact for the trilinear map. */
  double compute_volume(const HexahedronNodes &nodes);

  /** Volume-averaged gradients of the shape functions, (1/V) int dN_a/dX_j dV [1/mm] (exact). */
  HexahedronNodes compute_mean_gradients(const HexahedronNodes &nodes);

  /**
   * Row sums of the consistent mass matrix, rho int N_a dV by 2x2x2 points (exact) [t]. Positive
   * for every element whose Jacobian is positive at the Gauss points.
   */
  Eigen::Matrix<double, 8, 1> compute_lumped_mass(const HexahedronNodes &nodes, double density);

  /** Least det(dX/dxi) over the 8 corners and the 8 Gauss points [mm^3]; <= 0: folded element. */
  double compute_least_jacobian(const HexahedronNodes &nodes);

  /** The same over the Gauss points alone: <= 0: masses and stiffness make no sense. */
  double compute_least_gauss_jacobian(const HexahedronNodes &nodes);

  /** Centroid of the volume, (1/V) int X dV [mm]. */
  Vector3 compute_centroid(const HexahedronNodes &nodes);

  /** Nodes of an element, in columns, that has expanded by a @p strain [-] around their mean. */
  template <typename Nodes>
  Nodes expand_nodes(const Nodes &nodes, const double strain)
  {
    const Vector3 middle = nodes.rowwise().mean();
    return nodes + strain * (nodes.colwise() - middle);
  }
} // namespace vfife

#endif
