// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/mesh/boundary_surface.h>
#include <vfife/mesh/primitives.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace vfife
{
  namespace
  {
    using Counts = std::array<unsigned int, 3>;

    void require(const bool condition, const std::string &message)
    {
      if (!condition)
        throw InputError(message);
    }

    /** The nodes in @p selected become the set @p name, the boundary faces between them the surface
     * of that name. */
    void name_side(BodyMesh                                &mesh,
                   const std::string                       &name,
                   const std::function<bool(unsigned int)> &selected)
    {
      auto &set = mesh.node_sets[name];
      for (unsigned int i = 0; i < mesh.triangulation.n_vertices(); ++i)
        if (selected(i))
          set.push_back(i);
      mesh.surfaces[name] = surface_of_boundary(mesh.triangulation, name, set);
    }
  } // namespace

  std::unique_ptr<BodyMesh> make_block(const Vector3 &size, const Counts &counts)
  {
    require(size.minCoeff() > 0., "block: its size must be positive in all directions");
    require(*std::min_element(counts.begin(), counts.end()) > 0,
            "block: at least one cell is needed in each direction");

    auto mesh                 = std::make_unique<BodyMesh>();
    mesh->name                = "block";
    const Counts       stride = {{1, counts[0] + 1, (counts[0] + 1) * (counts[1] + 1)}};
    const unsigned int n      = stride[2] * (counts[2] + 1);

    // index of a node along a direction
    const auto along = [&](const unsigned int node, const unsigned int d) {
      return node / stride[d] % (counts[d] + 1);
    };
    std::vector<Vector3>   nodes;
    std::vector<CellNodes> hexahedra;
    for (unsigned int node = 0; node < n; ++node)
      {
        Vector3 x;
        bool    starts_cell = true;
        for (unsigned int d = 0; d < 3; ++d)
          {
            x[d]        = size[d] * along(node, d) / counts[d];
            starts_cell = starts_cell && along(node, d) < counts[d];
          }
        nodes.push_back(x);
        if (!starts_cell)
          continue;
        CellNodes corners;
        for (unsigned int v = 0; v < 8; ++v)
          corners[v] =
            node + (v & 1u) * stride[0] + ((v >> 1) & 1u) * stride[1] + (v >> 2) * stride[2];
        hexahedra.push_back(corners);
      }
    create_triangulation(*mesh, nodes, hexahedra);
    mesh->sector.assign(hexahedra.size(), 0);

    const char *axes = "xyz";
    for (unsigned int d = 0; d < 3; ++d)
      {
        const std::string axis(1, axes[d]);
        name_side(*mesh, axis + "-", [&](const unsigned int i) { return along(i, d) == 0; });
        name_side(*mesh, axis + "+", [&](const unsigned int i) {
          return along(i, d) == counts[d];
        });
      }
    return mesh;
  }

  std::unique_ptr<BodyMesh>
  make_ring(const double inner, const double outer, const double height, const Counts &counts)
  {
    require(inner > 0. && outer > inner, "ring: 0 < inner radius < outer radius is needed");
    require(height > 0., "ring: its height must be positive");
    require(counts[0] > 0 && counts[1] >= 3 && counts[2] > 0,
            "ring: at least one cell radially and axially and three around are needed");

    auto mesh       = std::make_unique<BodyMesh>();
    mesh->name      = "ring";
    mesh->n_sectors = counts[1];

    // nodes of a sector: radius fastest, then z
    const unsigned int     per_row = counts[0] + 1, per_sector = per_row * (counts[2] + 1);
    std::vector<Vector3>   nodes;
    std::vector<CellNodes> hexahedra;
    for (unsigned int k = 0; k < counts[1]; ++k)
      {
        const Matrix3 rotation = rotation_about(Vector3::UnitZ(), 2. * pi * k / counts[1]);
        for (unsigned int layer = 0; layer <= counts[2]; ++layer)
          for (unsigned int i = 0; i <= counts[0]; ++i)
            nodes.push_back(rotation * Vector3(inner + (outer - inner) * i / counts[0],
                                               0.,
                                               height * layer / counts[2]));
        const unsigned int here = k * per_sector, next = (k + 1) % counts[1] * per_sector;
        for (unsigned int layer = 0; layer < counts[2]; ++layer)
          for (unsigned int i = 0; i < counts[0]; ++i)
            {
              CellNodes corners;
              for (unsigned int v = 0; v < 8; ++v)
                corners[v] =
                  ((v & 2u) != 0 ? next : here) + i + (v & 1u) + (layer + (v >> 2)) * per_row;
              hexahedra.push_back(corners);
              mesh->sector.push_back(k);
            }
      }
    create_triangulation(*mesh, nodes, hexahedra);

    const auto radial = [&](const unsigned int i) { return i % per_row; };
    const auto axial  = [&](const unsigned int i) { return i % per_sector / per_row; };
    name_side(*mesh, "inner", [&](const unsigned int i) { return radial(i) == 0; });
    name_side(*mesh, "outer", [&](const unsigned int i) { return radial(i) == counts[0]; });
    name_side(*mesh, "bottom", [&](const unsigned int i) { return axial(i) == 0; });
    name_side(*mesh, "top", [&](const unsigned int i) { return axial(i) == counts[2]; });
    return mesh;
  }

  namespace
  {
    /** Radius of the corners of a cylinder's core over the cylinder's radius: cells of about equal
     * size. */
    constexpr double core_part = .6;
    /** How far the sides of the core bulge from chords (0) to arcs (1): opens the corners at its
     * four edges. */
    constexpr double core_bulge = .5;

    /** Point of the unit disc for a point of the square [-1, 1]^2: concentric squares become bulged
     * squares. */
    Vector2 core_point(const Vector2 &square)
    {
      const double m = square.cwiseAbs().maxCoeff();
      if (m == 0.)
        return Vector2::Zero();
      const bool    wide  = std::abs(square[0]) >= std::abs(square[1]);
      const double  major = wide ? square[0] : square[1], minor = wide ? square[1] : square[0];
      const double  angle = pi / 4. * minor / m;
      const Vector2 arc   = wide ? Vector2(std::copysign(std::cos(angle), major), std::sin(angle))
                                 : Vector2(std::sin(angle), std::copysign(std::cos(angle), major));
      const double  bulge = core_bulge * m;
      return (1. - bulge) * square / std::sqrt(2.) + bulge * m * arc;
    }

    /** The cells of a disc: core of n x n, then rows between the core's border and the circle. */
    struct Disc
    {
      std::vector<Vector2>                     nodes;      ///< of the unit disc, the circle last
      std::vector<std::array<unsigned int, 4>> cells;      ///< lexicographic
      unsigned int                             border = 0; ///< nodes around
    };

    Disc make_disc(const unsigned int n, const unsigned int rows)
    {
      Disc       disc;
      const auto node = [n](const unsigned int i, const unsigned int j) { return j * (n + 1) + i; };
      for (unsigned int j = 0; j <= n; ++j)
        for (unsigned int i = 0; i <= n; ++i)
          disc.nodes.push_back(core_part * core_point({2. * i / n - 1., 2. * j / n - 1.}));
      for (unsigned int j = 0; j < n; ++j)
        for (unsigned int i = 0; i < n; ++i)
          disc.cells.push_back({{node(i, j), node(i + 1, j), node(i, j + 1), node(i + 1, j + 1)}});

      std::vector<unsigned int> previous; // counter-clockwise from the corner (-1, -1)
      for (unsigned int i = 0; i < n; ++i)
        previous.push_back(node(i, 0));
      for (unsigned int j = 0; j < n; ++j)
        previous.push_back(node(n, j));
      for (unsigned int i = n; i > 0; --i)
        previous.push_back(node(i, n));
      for (unsigned int j = n; j > 0; --j)
        previous.push_back(node(0, j));
      disc.border = previous.size();

      const std::vector<unsigned int> core = previous;
      for (unsigned int row = 1; row <= rows; ++row)
        {
          std::vector<unsigned int> next;
          for (unsigned int k = 0; k < disc.border; ++k)
            {
              const double angle = -.75 * pi + 2. * pi * k / disc.border, part = double(row) / rows;
              const Vector2 circle(std::cos(angle), std::sin(angle));
              const Vector2 point = (1. - part) * disc.nodes[core[k]] + part * circle;
              next.push_back(disc.nodes.size());
              disc.nodes.push_back(point);
            }
          for (unsigned int k = 0; k < disc.border; ++k)
            {
              const unsigned int l = (k + 1) % disc.border;
              disc.cells.push_back({{previous[k], next[k], previous[l], next[l]}});
            }
          previous = next;
        }
      return disc;
    }
  } // namespace

  std::unique_ptr<BodyMesh>
  make_cylinder(const double radius, const double height, const Counts &counts)
  {
    require(radius > 0. && height > 0., "cylinder: radius and height must be positive");
    require(counts[0] >= 2 && counts[0] % 2 == 0 && counts[1] > 0 && counts[2] > 0,
            "cylinder: an even number of cells across the core, and at least one row and layer are "
            "needed");

    auto mesh                        = std::make_unique<BodyMesh>();
    mesh->name                       = "cylinder";
    const Disc             disc      = make_disc(counts[0], counts[1]);
    const unsigned int     per_layer = disc.nodes.size();
    std::vector<Vector3>   nodes;
    std::vector<CellNodes> hexahedra;
    for (unsigned int layer = 0; layer <= counts[2]; ++layer)
      {
        for (const Vector2 &x : disc.nodes)
          nodes.emplace_back(radius * x[0], radius * x[1], height * layer / counts[2]);
        if (layer == counts[2])
          break;
        for (const auto &cell : disc.cells)
          {
            CellNodes corners;
            for (unsigned int v = 0; v < 8; ++v)
              corners[v] = cell[v & 3u] + (layer + (v >> 2)) * per_layer;
            hexahedra.push_back(corners);
          }
      }
    create_triangulation(*mesh, nodes, hexahedra);
    mesh->sector.assign(hexahedra.size(), 0);

    const unsigned int centre = (counts[0] + 1) * (counts[0] + 1) / 2;
    for (unsigned int layer = 0; layer <= counts[2]; ++layer)
      mesh->node_sets["axis"].push_back(centre + layer * per_layer);
    name_side(*mesh, "outer", [&](const unsigned int i) {
      return i % per_layer >= per_layer - disc.border;
    });
    name_side(*mesh, "bottom", [&](const unsigned int i) { return i / per_layer == 0; });
    name_side(*mesh, "top", [&](const unsigned int i) { return i / per_layer == counts[2]; });
    return mesh;
  }
} // namespace vfife
