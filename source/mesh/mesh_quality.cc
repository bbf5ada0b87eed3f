// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/mesh/mesh_quality.h>

#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <array>
#include <limits>

namespace vfife
{
  namespace
  {
    using Corners = std::array<Vector3, 8>;

    /** dX/dxi of the trilinear map X = sum N_v(xi) x_v at a point of the unit cube, N_v the product
     * of xi_d or 1 - xi_d. */
    Matrix3 jacobian(const Corners &x, const Vector3 &xi)
    {
      Matrix3 J = Matrix3::Zero();
      for (unsigned int v = 0; v < 8; ++v)
        {
          Vector3 value, slope;
          for (unsigned int d = 0; d < 3; ++d)
            {
              const bool upper = ((v >> d) & 1u) != 0;
              value[d]         = upper ? xi[d] : 1. - xi[d];
              slope[d]         = upper ? 1. : -1.;
            }
          J.col(0) += slope[0] * value[1] * value[2] * x[v];
          J.col(1) += value[0] * slope[1] * value[2] * x[v];
          J.col(2) += value[0] * value[1] * slope[2] * x[v];
        }
      return J;
    }

    Vector3 centre_of(const Corners &x)
    {
      Vector3 centre = Vector3::Zero();
      for (const Vector3 &corner : x)
        centre += corner / 8.;
      return centre;
    }

    /** Largest area of the six faces, each as half the cross product of its diagonals. */
    double largest_face(const Corners &x)
    {
      constexpr unsigned int faces[6][4] = {
        {0, 2, 6, 4}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 3, 7, 6}, {0, 1, 3, 2}, {4, 5, 7, 6}};
      double largest = 0.;
      for (const auto &f : faces)
        largest = std::max(largest, .5 * (x[f[2]] - x[f[0]]).cross(x[f[3]] - x[f[1]]).norm());
      return largest;
    }

    /** Corners' share: edges, determinants, scaled Jacobian (returned). */
    double measure_corners(const Corners &x, MeshQuality &quality)
    {
      // det(e1, e2, e3) of the edges that leave a corner, and over their lengths
      double least    = std::numeric_limits<double>::max();
      double shortest = std::numeric_limits<double>::max(), longest = 0.;
      for (unsigned int v = 0; v < 8; ++v)
        {
          Matrix3 edges;
          double  lengths = 1.;
          for (unsigned int d = 0; d < 3; ++d)
            {
              const unsigned int bit = 1u << d;
              edges.col(d)           = x[v | bit] - x[v & ~bit];
              const double length    = edges.col(d).norm();
              shortest               = std::min(shortest, length);
              longest                = std::max(longest, length);
              lengths *= length;
            }
          const double determinant  = edges.determinant();
          quality.least_determinant = std::min(quality.least_determinant, determinant);
          least                     = std::min(least, determinant / lengths);
        }
      quality.least_edge           = std::min(quality.least_edge, shortest);
      quality.largest_edge         = std::max(quality.largest_edge, longest);
      quality.largest_aspect_ratio = std::max(quality.largest_aspect_ratio, longest / shortest);
      return least;
    }
  } // namespace

  MeshQuality compute_mesh_quality(const dealii::Triangulation<3> &triangulation)
  {
    MeshQuality quality;
    quality.cells                   = triangulation.n_active_cells();
    quality.nodes                   = triangulation.n_used_vertices();
    quality.least_scaled_jacobian   = std::numeric_limits<double>::max();
    quality.least_determinant       = std::numeric_limits<double>::max();
    quality.least_gauss_determinant = std::numeric_limits<double>::max();
    quality.least_edge              = std::numeric_limits<double>::max();
    quality.least_height            = std::numeric_limits<double>::max();

    //     6-----7     Corner v by its bits x, y, z. The scaled Jacobian of a cell is the least over
    //    /|    /|     its corners of det(e1, e2, e3) over the lengths of the three edges that leave
    //   4-----5 |     the corner along x, y, z: 1 of a cuboid, negative where the cell is inverted.
    //   | 2---|-3
    //   |/    |/
    //   0-----1
    // The determinant is quadratic in each coordinate: two Gauss points a direction are exact.
    const dealii::QGauss<3> gauss(2);

    for (const auto &cell : triangulation.active_cell_iterators())
      {
        Corners x;
        for (unsigned int v = 0; v < 8; ++v)
          x[v] = Vector3(cell->vertex(v)[0], cell->vertex(v)[1], cell->vertex(v)[2]);

        // corners: edges, determinants, scaled Jacobian
        const double scaled = measure_corners(x, quality);
        if (scaled < quality.least_scaled_jacobian)
          {
            quality.least_scaled_jacobian = scaled;
            quality.worst_cell_centre     = centre_of(x);
          }

        if (!(scaled > 0.))
          ++quality.inverted_corners;

        // inside: least determinant, volume, and volume over the largest face
        double volume = 0.;
        for (unsigned int q = 0; q < gauss.size(); ++q)
          {
            const auto  &xi           = gauss.point(q);
            const double determinant  = jacobian(x, {xi[0], xi[1], xi[2]}).determinant();
            quality.least_determinant = std::min(quality.least_determinant, determinant);
            if (determinant < quality.least_gauss_determinant)
              {
                quality.least_gauss_determinant = determinant;
                quality.worst_gauss_centre      = centre_of(x);
              }
            volume += gauss.weight(q) * determinant;
          }
        quality.volume += volume;
        quality.least_height = std::min(quality.least_height, volume / largest_face(x));
      }
    return quality;
  }
} // namespace vfife
