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

    /** Values of the functions of degree n - 1 along a side, at s of [0, 1]. */
    std::array<double, 3> functions_along(const unsigned int n, const double s)
    {
      if (n == 2)
        return {{1. - s, s, 0.}};
      return {{(1. - s) * (1. - 2. * s), 4. * s * (1. - s), s * (2. * s - 1.)}};
    }

    /** Calls add(function, weight times value of the function, bilinear weights of the corners) at
     * Gauss points that are exact for polynomials of degree 5 in each direction. */
    template <typename Add>
    void integrate_face(const unsigned int n, const Add &add)
    {
      static const auto rule = facet_quadrature(ContactDiscretization::surface_points, 3);
      for (const FacetQuadraturePoint &point : rule)
        {
          const auto along = functions_along(n, point.xi), across = functions_along(n, point.eta);
          for (unsigned int j = 0; j < n; ++j)
            for (unsigned int i = 0; i < n; ++i)
              add(i + n * j, point.weight * along[i] * across[j], point.shape);
        }
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

  std::vector<Vector3> integrate_normals(const std::array<Vector3, 4> &corners,
                                         const unsigned int            n)
  {
    const std::array<Vector3, 4> normals = corner_normals(corners);
    std::vector<Vector3>         integrals(n * n, Vector3::Zero());
    integrate_face(n, [&](const unsigned int function, const double weight, const auto &bilinear) {
      for (unsigned int k = 0; k < 4; ++k)
        integrals[function] += weight * bilinear[k] * normals[k];
    });
    return integrals;
  }

  std::vector<double> integrate_areas(const std::array<Vector3, 4> &corners, const unsigned int n)
  {
    const std::array<Vector3, 4> normals = corner_normals(corners);
    std::vector<double>          integrals(n * n, 0.);
    integrate_face(n, [&](const unsigned int function, const double weight, const auto &bilinear) {
      Vector3 normal = Vector3::Zero();
      for (unsigned int k = 0; k < 4; ++k)
        normal += bilinear[k] * normals[k];
      integrals[function] += weight * normal.norm();
    });
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
