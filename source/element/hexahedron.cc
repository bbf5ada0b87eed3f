// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/element/hexahedron.h>

#include <Eigen/LU>

#include <algorithm>
#include <cmath>

namespace vfife
{
  Vector3 reference_corner(const unsigned int node)
  {
    // The bits of the number are the places along xi, eta and zeta.
    return {node & 1u ? 1. : -1., node & 2u ? 1. : -1., node & 4u ? 1. : -1.};
  }

  Vector3 gauss_point(const unsigned int q)
  {
    return reference_corner(q) / std::sqrt(3.);
  }

  Eigen::Matrix<double, 8, 1> shape_functions(const Vector3 &xi)
  {
    Eigen::Matrix<double, 8, 1> N;
    for (unsigned int a = 0; a < 8; ++a)
      {
        const Vector3 corner = reference_corner(a);
        N[a] = (1. + corner[0] * xi[0]) * (1. + corner[1] * xi[1]) * (1. + corner[2] * xi[2]) / 8.;
      }
    return N;
  }

  HexahedronNodes reference_gradients(const Vector3 &xi)
  {
    HexahedronNodes gradients;
    for (unsigned int a = 0; a < 8; ++a)
      {
        const Vector3 corner = reference_corner(a);
        const Vector3 factor = Vector3::Ones() + corner.cwiseProduct(xi);
        gradients.col(a)     = Vector3(corner[0] * factor[1] * factor[2],
                                   corner[1] * factor[0] * factor[2],
                                   corner[2] * factor[0] * factor[1]) /
                           8.;
      }
    return gradients;
  }

  double hourglass_sign(const unsigned int k, const unsigned int node)
  {
    // The functions eta zeta, xi zeta, xi eta, xi eta zeta, which no linear field contains; with 1,
    // xi, eta, zeta they span all fields of eight nodes.
    const Vector3 corner = reference_corner(node);
    return k == 3 ? corner.prod() : corner[(k + 1) % 3] * corner[(k + 2) % 3];
  }

  Matrix3 compute_jacobian(const HexahedronNodes &nodes, const Vector3 &xi)
  {
    return nodes * reference_gradients(xi).transpose();
  }

  double compute_volume(const HexahedronNodes &nodes)
  {
    // det J has degree 2 in each of xi, eta, zeta, N_a det J degree 3: two points a
    // direction integrate both exactly.
    double volume = 0.;
    for (unsigned int q = 0; q < 8; ++q)
      volume += compute_jacobian(nodes, gauss_point(q)).determinant();
    return volume;
  }

  HexahedronNodes compute_mean_gradients(const HexahedronNodes &nodes)
  {
    HexahedronNodes integral = HexahedronNodes::Zero();
    double          volume   = 0.;
    for (unsigned int q = 0; q < 8; ++q)
      {
        const HexahedronNodes gradients   = reference_gradients(gauss_point(q));
        const Matrix3         jacobian    = nodes * gradients.transpose();
        const double          determinant = jacobian.determinant();
        // grad N_a = J^-T dN_a/dxi; times det J it is the cofactor matrix, a polynomial again.
        integral += determinant * jacobian.inverse().transpose() * gradients;
        volume += determinant;
      }
    return integral / volume;
  }

  Eigen::Matrix<double, 8, 1> compute_lumped_mass(const HexahedronNodes &nodes,
                                                  const double           density)
  {
    Eigen::Matrix<double, 8, 1> mass = Eigen::Matrix<double, 8, 1>::Zero();
    for (unsigned int q = 0; q < 8; ++q)
      {
        const Vector3 xi = gauss_point(q);
        mass += density * compute_jacobian(nodes, xi).determinant() * shape_functions(xi);
      }
    return mass;
  }

  double compute_least_jacobian(const HexahedronNodes &nodes)
  {
    // The corners show where a face folds first, the Gauss points what the stiffness would see.
    double least = compute_jacobian(nodes, reference_corner(0)).determinant();
    for (unsigned int a = 0; a < 8; ++a)
      least = std::min({least,
                        compute_jacobian(nodes, reference_corner(a)).determinant(),
                        compute_jacobian(nodes, gauss_point(a)).determinant()});
    return least;
  }

  double compute_least_gauss_jacobian(const HexahedronNodes &nodes)
  {
    double least = compute_jacobian(nodes, gauss_point(0)).determinant();
    for (unsigned int q = 1; q < 8; ++q)
      least = std::min(least, compute_jacobian(nodes, gauss_point(q)).determinant());
    return least;
  }

  Vector3 compute_centroid(const HexahedronNodes &nodes)
  {
    // X = sum_a N_a X_a, so int X dV = sum_a X_a int N_a dV: the lumped masses of density 1.
    return nodes * compute_lumped_mass(nodes, 1.) / compute_volume(nodes);
  }
} // namespace vfife
