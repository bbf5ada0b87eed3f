// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/stress/surface_stress.h>

#include <Eigen/LU>

#include <algorithm>
#include <cmath>

namespace vfife
{
  namespace
  {
    /** Derivatives of bilinear values along xi, eta in [0, 1], at the centre. */
    Eigen::Matrix<double, 3, 2> central_derivatives(const FacetCorners &v)
    {
      Eigen::Matrix<double, 3, 2> derivatives;
      derivatives.col(0) = .5 * (v.col(1) + v.col(2) - v.col(0) - v.col(3));
      derivatives.col(1) = .5 * (v.col(2) + v.col(3) - v.col(0) - v.col(1));
      return derivatives;
    }
  } // namespace

  FacetStrain::FacetStrain(const FacetCorners &X)
  {
    const Eigen::Matrix<double, 3, 2> tangents = central_derivatives(X);
    const Vector3                     normal   = tangents.col(0).cross(tangents.col(1));
    axes_.col(0)                               = tangents.col(0).normalized();
    axes_.col(1)                               = normal.cross(tangents.col(0)).normalized();
    to_axes_                                   = (axes_.transpose() * tangents).inverse();
  }

  Eigen::Matrix<double, 3, 2> FacetStrain::gradient(const FacetCorners &values) const
  {
    return central_derivatives(values) * to_axes_;
  }

  SurfaceTensor FacetStrain::of_displacements(const FacetCorners &u) const
  {
    const Eigen::Matrix2d H = axes_.transpose() * gradient(u);
    return {H(0, 0), H(1, 1), .5 * (H(0, 1) + H(1, 0))};
  }

  SurfaceTensor FacetStrain::of_places(const FacetCorners &x) const
  {
    // C = F^T F of the facet's 3 x 2 gradient F knows nothing of rotations. The root of a 2 x 2
    // matrix: U = (C + sqrt(det C) 1)/sqrt(tr C + 2 sqrt(det C)).
    const Eigen::Matrix<double, 3, 2> F    = gradient(x);
    const Eigen::Matrix2d             C    = F.transpose() * F;
    const double                      area = std::sqrt(C.determinant());
    const Eigen::Matrix2d             U =
      (C + area * Eigen::Matrix2d::Identity()) / std::sqrt(C.trace() + 2. * area);
    return {U(0, 0) - 1., U(1, 1) - 1., U(0, 1)};
  }

  SurfaceTensor compute_surface_stress(const SurfaceTensor &strain, const Material &material)
  {
    const double nu = material.poissons_ratio, E = material.youngs_modulus;
    const double plane = E / (1. - nu * nu);
    return {plane * (strain[0] + nu * strain[1]),
            plane * (strain[1] + nu * strain[0]),
            E / (1. + nu) * strain[2]};
  }

  PrincipalStresses compute_principal_stresses(const SurfaceTensor &stress)
  {
    const double mean = .5 * (stress[0] + stress[1]), half = .5 * (stress[0] - stress[1]);
    const double radius = std::hypot(half, stress[2]);
    // The angle is that of the larger one; the smaller one's is a right angle away.
    double angle = .5 * std::atan2(stress[2], half);
    if (mean < 0.)
      angle += angle > 0. ? -.5 * pi : .5 * pi;
    return {std::max(0., mean + radius), std::min(0., mean - radius), angle};
  }
} // namespace vfife
