// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/mesh/solid_integrals.h>

#include <deal.II/base/quadrature_lib.h>

#include <Eigen/LU>

namespace vfife
{
  SolidIntegrals &SolidIntegrals::operator+=(const SolidIntegrals &other)
  {
    volume += other.volume;
    radius_squared += other.radius_squared;
    height += other.height;
    height_squared += other.height_squared;
    return *this;
  }

  double SolidIntegrals::centre() const
  {
    return height / volume;
  }

  double SolidIntegrals::polar() const
  {
    return radius_squared;
  }

  double SolidIntegrals::transverse() const
  {
    // int (x^2 + z^2) dV about the centre (Steiner), int x^2 dV = int r^2 dV/2 by symmetry
    return .5 * radius_squared + height_squared - height * height / volume;
  }

  SolidIntegrals compute_solid_integrals(const dealii::Triangulation<3> &triangulation,
                                         const std::vector<double>      &weights)
  {
    // The determinant is quadratic in each coordinate and so are squares of positions: three Gauss
    // points a direction are exact.
    const dealii::QGauss<3> quadrature(3);
    SolidIntegrals          sum;
    for (const auto &cell : triangulation.active_cell_iterators())
      for (unsigned int q = 0; q < quadrature.size(); ++q)
        {
          const auto &xi = quadrature.point(q);
          Vector3     x  = Vector3::Zero();
          Matrix3     J  = Matrix3::Zero();
          for (unsigned int v = 0; v < 8; ++v)
            {
              // weights of the corner and their derivatives on the unit cube
              double value[3], slope[3];
              for (unsigned int d = 0; d < 3; ++d)
                {
                  const bool upper = ((v >> d) & 1u) != 0;
                  value[d]         = upper ? xi[d] : 1. - xi[d];
                  slope[d]         = upper ? 1. : -1.;
                }
              const auto   &p = cell->vertex(v);
              const Vector3 corner(p[0], p[1], p[2]);
              x += value[0] * value[1] * value[2] * corner;
              J.col(0) += slope[0] * value[1] * value[2] * corner;
              J.col(1) += value[0] * slope[1] * value[2] * corner;
              J.col(2) += value[0] * value[1] * slope[2] * corner;
            }
          const double weight = quadrature.weight(q) * J.determinant() *
                                (weights.empty() ? 1. : weights[cell->active_cell_index()]);
          sum.volume += weight;
          sum.radius_squared += weight * x.head<2>().squaredNorm();
          sum.height += weight * x[2];
          sum.height_squared += weight * x[2] * x[2];
        }
    return sum;
  }

  SolidIntegrals compute_solid_integrals(const std::vector<Vector2> &meridian)
  {
    // The integral of f r over the meridian is that of f r^2/2 dz (of r^4/4 dz for f = r^2) along
    // its border: degree 4 on an edge, exact with three Gauss points.
    const dealii::QGauss<1> quadrature(3);
    SolidIntegrals          sum;
    for (std::size_t i = 0; i < meridian.size(); ++i)
      {
        const Vector2 a = meridian[i], b = meridian[(i + 1) % meridian.size()];
        for (unsigned int q = 0; q < quadrature.size(); ++q)
          {
            // point of the edge, and pi r^2 dz: V = pi int r^2 dz and so on (doc/theory/mesh.md)
            const Vector2 x      = a + quadrature.point(q)[0] * (b - a);
            const double  weight = pi * quadrature.weight(q) * (b[1] - a[1]) * x[0] * x[0];
            sum.volume += weight;
            sum.radius_squared += .5 * weight * x[0] * x[0];
            sum.height += weight * x[1];
            sum.height_squared += weight * x[1] * x[1];
          }
      }
    if (sum.volume < 0.) // corners in the other sense
      return {-sum.volume, -sum.radius_squared, -sum.height, -sum.height_squared};
    return sum;
  }
} // namespace vfife
