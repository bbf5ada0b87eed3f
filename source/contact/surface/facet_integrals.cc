// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/contact/surface/facet_integrals.h>
#include <vfife/contact/surface/facet_quadrature.h>

#include <algorithm>

namespace vfife
{
  namespace
  {
    /** y_xi x y_eta at the corners of the bilinear face, between which it is bilinear. */
    std::array<Vector3, 4> corner_normals(const std::array<Vector3, 4> &x)
    {
      const Vector3 low = x[1] - x[0], high = x[2] - x[3], left = x[3] - x[0], right = x[2] - x[1];
      return {{low.cross(left), low.cross(right), high.cross(right), high.cross(left)}};
    }
  } // namespace

  std::array<Vector3, 4> integrate_normals(const std::array<Vector3, 4> &corners)
  {
    // The integral of N_i N_k over the unit square is 1/9, 1/18 with the next corner and 1/36 with
    // the opposite one.
    const std::array<Vector3, 4> normals = corner_normals(corners);
    std::array<Vector3, 4>       integrals;
    for (unsigned int i = 0; i < 4; ++i)
      integrals[i] = (4. * normals[i] + 2. * (normals[(i + 1) % 4] + normals[(i + 3) % 4]) +
                      normals[(i + 2) % 4]) /
                     36.;
    return integrals;
  }

  std::array<double, 4> integrate_areas(const std::array<Vector3, 4> &corners)
  {
    // Gauss points that are exact for polynomials of degree 5 in each direction.
    static const auto            rule = facet_quadrature(ContactDiscretization::surface_points, 3);
    const std::array<Vector3, 4> normals   = corner_normals(corners);
    std::array<double, 4>        integrals = {};
    for (const FacetQuadraturePoint &point : rule)
      {
        Vector3 normal = Vector3::Zero();
        for (unsigned int k = 0; k < 4; ++k)
          normal += point.shape[k] * normals[k];
        for (unsigned int j = 0; j < 2; ++j)
          for (unsigned int i = 0; i < 2; ++i)
            integrals[i + 2 * j] += point.weight * (i == 1 ? point.xi : 1. - point.xi) *
                                    (j == 1 ? point.eta : 1. - point.eta) * normal.norm();
      }
    return integrals;
  }

  double facet_width(const std::array<Vector3, 4> &corners)
  {
    const auto side = [&](const unsigned int i) {
      return (corners[(i + 1) % 4] - corners[i]).norm();
    };
    return 0.5 * std::min(side(0) + side(2), side(1) + side(3));
  }
} // namespace vfife
