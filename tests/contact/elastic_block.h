// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_tests_contact_elastic_block_h
#define vfife_tests_contact_elastic_block_h

#include "surfaces.h"

#include <vfife/element/stiffness.h>

#include <Eigen/SparseCholesky>

namespace test_surfaces
{
  /** 0 to @p end in cells of @p size up to @p fine, then growing by at most @p growth. */
  inline std::vector<double>
  graded(const double size, const double fine, const double end, const double growth)
  {
    std::vector<double> x    = {0.};
    double              cell = size;
    while (x.back() < end * (1. - 1e-9))
      {
        if (x.back() > fine - 1e-9)
          cell *= growth;
        x.push_back(x.back() + cell);
      }
    // The last cell ends at `end`, all coarse ones give way a little.
    const double fine_end =
      *std::find_if(x.begin(), x.end(), [fine](double v) { return v > fine - 1e-9; });
    const double scale = (end - fine_end) / (x.back() - fine_end);
    for (double &v : x)
      if (v > fine_end)
        v = fine_end + (v - fine_end) * scale;
    return x;
  }

  /**
   * A linear elastic body that is pressed at the origin: x and y from the planes of symmetry
   * outwards, depth along `into` (+1: the body lies above z = 0, -1: below). Its surface is part of
   * a sphere or, with one row of cells along y, of a cylinder (plane strain), or flat with radius
   * 0. What the surface's nodes in `reach` of the origin do under forces on them is condensed into
   * a compliance.
   */
  struct ElasticBlock
  {
    std::vector<double> x, y, depth;
    double              radius, into, reach;
    bool                plane_strain;
    bool                free_sides = false; ///< the last x and y are free, not far surfaces
    Material            material;

    std::vector<Vector3>      nodes;
    FacetSurface              surface;        ///< its nodes are the first of `nodes`
    std::vector<unsigned int> columns;        ///< 3 * node + component, of the compliance
    Eigen::MatrixXd           compliance;     ///< [mm/N]
    Eigen::VectorXd           of_far_surface; ///< displacement by the far surface's for 1 N [mm/N]

    void build()
    {
      make_nodes();
      make_surface();
      condense();
    }

    /** Displacement of a half-space at a place of this body under 1 N into it (Boussinesq; Johnson
     * 1985, Eq. (3.19)). */
    Vector3 half_space(const Vector3 &position) const
    {
      const double g = material.mu(), nu = material.poissons_ratio, z = into * position[2];
      const double rho  = position.norm();
      const double by_r = z / std::pow(rho, 3) - (1. - 2. * nu) / (rho * (rho + z));
      const double u_z  = z * z / std::pow(rho, 3) + 2. * (1. - nu) / rho;
      return Vector3(by_r * position[0], by_r * position[1], into * u_z) / (4. * pi * g);
    }

  private:
    unsigned int node(unsigned int i, unsigned int j, unsigned int k) const
    {
      return (k * static_cast<unsigned int>(y.size()) + j) * static_cast<unsigned int>(x.size()) +
             i;
    }

    void make_nodes()
    {
      for (const double d : depth)
        for (const double v : y)
          for (const double u : x)
            {
              const double r2 = plane_strain ? u * u : u * u + v * v;
              const double height =
                radius > 0. ? r2 / (radius + std::sqrt(radius * radius - r2)) : 0.;
              nodes.emplace_back(u, v, into * (height + d * (1. - height / depth.back())));
            }
    }

    void make_surface()
    {
      const Vector3 centre(0., 0., into * radius), axis(0., plane_strain ? 1. : 0., 0.);
      surface.name = "pressed";
      for (unsigned int n = 0; n < x.size() * y.size(); ++n)
        {
          surface.nodes.push_back(n);
          surface.positions.push_back(nodes[n]);
          const Vector3 d = nodes[n] - centre;
          surface.normals.push_back(radius > 0. ? Vector3((d - axis * axis.dot(d)).normalized())
                                                : Vector3(0., 0., -into));
        }
      for (unsigned int j = 0; j + 1 < y.size(); ++j)
        for (unsigned int i = 0; i + 1 < x.size(); ++i)
          {
            std::array<unsigned int, 4> f = {
              {node(i, j, 0), node(i + 1, j, 0), node(i + 1, j + 1, 0), node(i, j + 1, 0)}};
            if (into > 0.)
              std::swap(f[1], f[3]);
            surface.facets.push_back(f);
            surface.group.push_back(0);
          }
      find_neighbours(surface);
      if (radius > 0.)
        add_sphere_offsets(surface, centre, radius, 5, axis);
    }

    /** 0: free, 1: plane of symmetry, 2: far surface. */
    int support(const unsigned int n, const unsigned int component) const
    {
      const unsigned int nx = x.size(), i = n % nx, j = (n / nx) % y.size(),
                         k = n / (nx * y.size());
      if (k + 1 == depth.size() ||
          (!free_sides && (i + 1 == nx || (j + 1 == y.size() && !plane_strain))))
        return 2;
      return (component == 0 && i == 0) || (component == 1 && (j == 0 || plane_strain)) ? 1 : 0;
    }

    void condense()
    {
      std::vector<int>                    unknown(3 * nodes.size(), -1);
      std::vector<Vector3>                far(nodes.size(), Vector3::Zero());
      std::vector<Eigen::Triplet<double>> entries;
      int                                 n = 0;
      for (unsigned int a = 0; a < nodes.size(); ++a)
        for (unsigned int c = 0; c < 3; ++c)
          if (support(a, c) == 0)
            unknown[3 * a + c] = n++;
          else if (support(a, c) == 2 && !plane_strain && !free_sides)
            far[a][c] = half_space(nodes[a])[c];
      Eigen::VectorXd right = Eigen::VectorXd::Zero(n);

      for (unsigned int k = 0; k + 1 < depth.size(); ++k)
        for (unsigned int j = 0; j + 1 < y.size(); ++j)
          for (unsigned int i = 0; i + 1 < x.size(); ++i)
            add_element(i, j, k, unknown, far, entries, right);
      Eigen::SparseMatrix<double> K(n, n);
      K.setFromTriplets(entries.begin(), entries.end());
      const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(K);

      for (unsigned int a = 0; a < surface.nodes.size(); ++a)
        for (unsigned int c = 0; c < 3; ++c)
          if (unknown[3 * a + c] >= 0 && nodes[a][0] < reach &&
              (plane_strain || nodes[a][1] < reach))
            columns.push_back(3 * a + c);
      compliance.resize(columns.size(), columns.size());
      of_far_surface.resize(columns.size());
      const Eigen::VectorXd by_far = solver.solve(right);
      for (unsigned int i = 0; i < columns.size(); ++i)
        {
          const Eigen::VectorXd u = solver.solve(Eigen::VectorXd::Unit(n, unknown[columns[i]]));
          for (unsigned int j = 0; j < columns.size(); ++j)
            compliance(j, i) = u[unknown[columns[j]]];
          of_far_surface[i] = by_far[unknown[columns[i]]];
        }
    }

    void add_element(const unsigned int                   i,
                     const unsigned int                   j,
                     const unsigned int                   k,
                     const std::vector<int>              &unknown,
                     const std::vector<Vector3>          &far,
                     std::vector<Eigen::Triplet<double>> &entries,
                     Eigen::VectorXd                     &right) const
    {
      std::array<unsigned int, 8> corner;
      HexahedronNodes             X;
      for (unsigned int a = 0; a < 8; ++a)
        {
          // right-handed cells in both directions of depth
          const unsigned int layer = (a / 4 == 1) == (into > 0.) ? k + 1 : k;
          corner[a]                = node(i + a % 2, j + (a / 2) % 2, layer);
          X.col(a)                 = nodes[corner[a]];
        }
      const Matrix24 Ke = compute_stiffness(X, material, StiffnessKind::incompatible_modes);
      for (unsigned int r = 0; r < 24; ++r)
        {
          const int row = unknown[3 * corner[r / 3] + r % 3];
          if (row < 0)
            continue;
          for (unsigned int c = 0; c < 24; ++c)
            {
              const int column = unknown[3 * corner[c / 3] + c % 3];
              if (column >= 0)
                entries.emplace_back(row, column, Ke(r, c));
              else
                right[row] -= Ke(r, c) * far[corner[c / 3]][c % 3];
            }
        }
    }
  };
} // namespace test_surfaces

#endif
