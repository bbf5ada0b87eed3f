// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/contact/surface/facet_quadrature.h>
#include <vfife/contact/surface/smooth_patch.h>

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace vfife
{
  namespace
  {
    /** Offsets are tabulated at this number of points per direction: a patch is of degree four. */
    constexpr unsigned int points_per_direction = 5;

    /** Second-order coefficient c of the edge x0 + (x1 - x0 - c) t + c t^2 that is normal to n0 at
     * t = 0 and to n1 at t = 1, of least length. */
    Vector3
    edge_curvature(const Vector3 &x0, const Vector3 &x1, const Vector3 &n0, const Vector3 &n1)
    {
      const Vector3 d     = x1 - x0;
      const double  cross = n0.cross(n1).squaredNorm(); // 1 - (n0.n1)^2 without cancellation
      if (cross < 1e-14)
        return Vector3::Zero();
      const double a = n0.dot(n1), d0 = n0.dot(d), d1 = -n1.dot(d);
      return ((d0 - a * d1) * n0 + (d1 - a * d0) * n1) / cross;
    }

    /** sum over i + j <= 3, i, j <= 2 of coefficient[i][j] xi^i eta^j. */
    class NagataPatch
    {
    public:
      NagataPatch(const std::array<Vector3, 4> &x, const std::array<Vector3, 4> &n)
      {
        // On its sides the patch is the edges' curves; c21 and c12 lead from one curve to that of
        // the opposite edge.
        const Vector3 bottom = edge_curvature(x[0], x[1], n[0], n[1]);
        const Vector3 right  = edge_curvature(x[1], x[2], n[1], n[2]);
        const Vector3 top    = edge_curvature(x[3], x[2], n[3], n[2]);
        const Vector3 left   = edge_curvature(x[0], x[3], n[0], n[3]);
        c00_                 = x[0];
        c10_                 = x[1] - x[0] - bottom;
        c01_                 = x[3] - x[0] - left;
        c11_                 = x[2] - x[3] - x[1] + x[0] + bottom - top - right + left;
        c20_                 = bottom;
        c02_                 = left;
        c21_                 = top - bottom;
        c12_                 = right - left;
      }

      Vector3 value(const double xi, const double eta) const
      {
        return c00_ + xi * (c10_ + xi * c20_) +
               eta * (c01_ + eta * c02_ + xi * (c11_ + xi * c21_ + eta * c12_));
      }
      Vector3 along_xi(const double xi, const double eta) const
      {
        return c10_ + 2. * xi * c20_ + eta * (c11_ + 2. * xi * c21_ + eta * c12_);
      }
      Vector3 along_eta(const double xi, const double eta) const
      {
        return c01_ + 2. * eta * c02_ + xi * (c11_ + xi * c21_ + 2. * eta * c12_);
      }

    private:
      Vector3 c00_, c10_, c01_, c11_, c20_, c02_, c21_, c12_;
    };

    /** Distance along @p normal from @p foot to the patch; (xi, eta) is where to start. */
    double distance_along(
      const NagataPatch &patch, const Vector3 &foot, const Vector3 &normal, double xi, double eta)
    {
      // Newton's method for P(xi, eta) - foot - distance normal = 0.
      double distance = 0.;
      for (unsigned int iteration = 0; iteration < 8; ++iteration)
        {
          Matrix3 jacobian;
          jacobian << patch.along_xi(xi, eta), patch.along_eta(xi, eta), -normal;
          const Vector3 residual = patch.value(xi, eta) - foot - distance * normal;
          const Vector3 step     = jacobian.partialPivLu().solve(residual);
          xi -= step[0];
          eta -= step[1];
          distance -= step[2];
          if (step.squaredNorm() < 1e-26)
            break;
        }
      return distance;
    }
  } // namespace

  FacetSurface with_smooth_patches(FacetSurface surface)
  {
    const std::vector<double> points = gauss_lobatto_points(points_per_direction);
    surface.offset_points            = points_per_direction;
    surface.offset_row.resize(surface.facets.size());
    surface.offsets.clear();
    for (std::size_t f = 0; f < surface.facets.size(); ++f)
      {
        // The patch through the facet's corners, as offsets along the interpolated normal at the
        // Gauss-Lobatto points.
        surface.offset_row[f] = static_cast<unsigned int>(f);
        std::array<Vector3, 4> x, n;
        for (unsigned int k = 0; k < 4; ++k)
          {
            x[k] = surface.positions[surface.facets[f][k]];
            n[k] = surface.normals[surface.facets[f][k]].normalized();
          }
        const NagataPatch patch(x, n);
        for (const double eta : points)
          for (const double xi : points)
            {
              const auto N = bilinear_weights(xi, eta);
              surface.offsets.push_back(
                distance_along(patch,
                               N[0] * x[0] + N[1] * x[1] + N[2] * x[2] + N[3] * x[3],
                               (N[0] * n[0] + N[1] * n[1] + N[2] * n[2] + N[3] * n[3]).normalized(),
                               xi,
                               eta));
            }
      }
    return surface;
  }

  bool has_sharp_edges(const FacetSurface &surface)
  {
    const double least_cosine = std::cos(40. / 180. * pi);
    std::map<std::pair<unsigned int, unsigned int>, Vector3> sides;
    for (const auto &facet : surface.facets)
      {
        const auto corner = [&](const unsigned int k) { return surface.positions[facet[k % 4]]; };
        const Vector3 normal = (corner(2) - corner(0)).cross(corner(3) - corner(1)).normalized();
        for (unsigned int k = 0; k < 4; ++k)
          {
            const auto side  = std::minmax(facet[k], facet[(k + 1) % 4]);
            const auto added = sides.emplace(side, normal);
            if (!added.second && normal.dot(added.first->second) < least_cosine)
              return true;
          }
      }
    return false;
  }
} // namespace vfife
