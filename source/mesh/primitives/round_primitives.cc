// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include "requirement.h"

#include <vfife/mesh/boundary_surface.h>
#include <vfife/mesh/primitives/disc_cells.h>
#include <vfife/mesh/primitives/primitives.h>

#include <deal.II/grid/manifold_lib.h>

#include <cmath>

namespace vfife
{
  namespace
  {
    /** Manifold id of curved faces, or of all that is curved. */
    constexpr dealii::types::manifold_id curved = 1;

    /** Refinement puts new nodes of the outer surface, the first boundary, on the manifold. */
    void curve_outer(BodyMesh &mesh, const dealii::Manifold<3> &manifold)
    {
      for (const auto &cell : mesh.triangulation.active_cell_iterators())
        for (const auto &face : cell->face_iterators())
          if (face->at_boundary() && face->boundary_id() == 1)
            face->set_all_manifold_ids(curved);
      mesh.triangulation.set_manifold(curved, manifold);
    }
  } // namespace

  std::unique_ptr<BodyMesh>
  make_ring(const double inner, const double outer, const double height, const Counts &counts)
  {
    require(inner > 0. && outer > inner, "ring: 0 < inner radius < outer radius is needed");
    require(height > 0., "ring: its height must be positive");
    require(counts[0] > 0 && counts[1] >= 3 && counts[2] > 0,
            "ring: at least one cell radially and axially and three around are needed");

    auto mesh  = std::make_unique<BodyMesh>();
    mesh->name = "ring";

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
        // cells between this sector's nodes and those of the next, the last one's being the first
        const unsigned int here = k * per_sector, next = (k + 1) % counts[1] * per_sector;
        for (unsigned int layer = 0; layer < counts[2]; ++layer)
          for (unsigned int i = 0; i < counts[0]; ++i)
            {
              CellNodes corners;
              for (unsigned int v = 0; v < 8; ++v)
                corners[v] =
                  ((v & 2u) != 0 ? next : here) + i + (v & 1u) + (layer + (v >> 2)) * per_row;
              hexahedra.push_back(corners);
            }
      }
    create_triangulation(*mesh, nodes, hexahedra, {}, counts[1]);

    const auto radial = [&](const unsigned int i) { return i % per_row; };
    const auto axial  = [&](const unsigned int i) { return i % per_sector / per_row; };
    add_named_side(*mesh, "inner", [&](const unsigned int i) { return radial(i) == 0; });
    add_named_side(*mesh, "outer", [&](const unsigned int i) { return radial(i) == counts[0]; });
    add_named_side(*mesh, "bottom", [&](const unsigned int i) { return axial(i) == 0; });
    add_named_side(*mesh, "top", [&](const unsigned int i) { return axial(i) == counts[2]; });
    name_boundaries(*mesh, {"inner", "outer", "bottom", "top"});
    mesh->triangulation.set_all_manifold_ids(curved);
    mesh->triangulation.set_manifold(curved, dealii::CylindricalManifold<3>(2));
    return mesh;
  }

  namespace
  {
    void require_core(const unsigned int core, const unsigned int rows, const std::string &shape)
    {
      require(core >= 2 && core % 2 == 0 && rows > 0,
              shape + ": an even number of cells across the core, and at least one row around it "
                      "are needed");
    }
  } // namespace

  std::unique_ptr<BodyMesh>
  make_cylinder(const double radius, const double height, const Counts &counts, const double bottom)
  {
    require(radius > 0. && height > 0., "cylinder: radius and height must be positive");
    require_core(counts[0], counts[1], "cylinder");
    require(counts[2] > 0, "cylinder: at least one layer of cells is needed");

    auto mesh                        = std::make_unique<BodyMesh>();
    mesh->name                       = "cylinder";
    const DiscCells        disc      = divide_disc(counts[0], counts[1]);
    const unsigned int     per_layer = disc.nodes.size();
    std::vector<Vector3>   nodes;
    std::vector<CellNodes> hexahedra;
    for (unsigned int layer = 0; layer <= counts[2]; ++layer)
      {
        for (const Vector2 &x : disc.nodes)
          nodes.emplace_back(radius * x[0], radius * x[1], bottom + height * layer / counts[2]);
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

    // named sides by the node's place in its layer: the circle comes last
    const unsigned int centre = (counts[0] + 1) * (counts[0] + 1) / 2;
    for (unsigned int layer = 0; layer <= counts[2]; ++layer)
      mesh->node_sets["axis"].push_back(centre + layer * per_layer);
    add_named_side(*mesh, "outer", [&](const unsigned int i) {
      return i % per_layer >= per_layer - disc.border;
    });
    add_named_side(*mesh, "bottom", [&](const unsigned int i) { return i / per_layer == 0; });
    add_named_side(*mesh, "top", [&](const unsigned int i) { return i / per_layer == counts[2]; });
    name_boundaries(*mesh, {"outer", "bottom", "top"});
    curve_outer(*mesh, dealii::CylindricalManifold<3>(2));
    return mesh;
  }

  std::unique_ptr<BodyMesh>
  make_disc(const double radius, const double thickness, const Counts &counts)
  {
    auto mesh  = make_cylinder(radius, thickness, counts, -.5 * thickness);
    mesh->name = "disc";
    return mesh;
  }

  namespace
  {
    /** Direction of a point of the surface of the cube [-1, 1]^3, equal angles along its faces. */
    Vector3 sphere_direction(const Vector3 &cube)
    {
      return (pi / 4. * cube).array().tan().matrix().normalized();
    }

    /** Point of the unit ball for a point of the cube [-1, 1]^3: concentric cubes become bulged
     * cubes. */
    Vector3 ball_core_point(const Vector3 &cube)
    {
      // As in the plane: between the cube of half-side m and the sphere above its faces.
      const double m = cube.cwiseAbs().maxCoeff();
      if (m == 0.)
        return Vector3::Zero();
      const double bulge = core_bulge * m;
      return (1. - bulge) * cube / std::sqrt(3.) + bulge * m * sphere_direction(cube / m);
    }

    /** The cells of a ball: core of n x n x n, then rows between the core's surface and the sphere.
     */
    struct Ball
    {
      std::vector<Vector3>   nodes;      ///< of the unit ball, the sphere last
      std::vector<CellNodes> cells;      ///< right-handed
      unsigned int           border = 0; ///< nodes of the sphere
    };

    /** Shells of cells between core and sphere, on all six sides of the cube. */
    void add_shells(const unsigned int n, const unsigned int rows, Ball &ball)
    {
      const unsigned int stride[3] = {1, n + 1, (n + 1) * (n + 1)}, n_core = ball.nodes.size();
      // nodes on the surface of the core and the directions in which the sphere lies above them
      std::vector<unsigned int> shell(n_core, n_core); // place of a surface node among them
      std::vector<Vector3>      directions;
      std::vector<unsigned int> surface;
      for (unsigned int node = 0; node < n_core; ++node)
        {
          const Vector3 cube(node % (n + 1), node / stride[1] % (n + 1), node / stride[2]);
          if (cube.minCoeff() > .5 && cube.maxCoeff() < n - .5)
            continue;
          shell[node] = surface.size();
          surface.push_back(node);
          directions.push_back(sphere_direction(2. / n * cube - Vector3::Ones()));
        }
      ball.border = surface.size();
      for (unsigned int row = 1; row <= rows; ++row)
        for (unsigned int i = 0; i < ball.border; ++i)
          {
            const double part = double(row) / rows;
            ball.nodes.push_back((1. - part) * ball.nodes[surface[i]] + part * directions[i]);
          }

      // node of a shell above a surface node of the core; row 0 is the core itself
      const auto node_of = [&](const unsigned int node, const unsigned int row) {
        return row == 0 ? node : n_core + (row - 1) * ball.border + shell[node];
      };
      for (unsigned int d = 0; d < 3; ++d)
        for (const unsigned int end : {0u, n})
          for (unsigned int row = 0; row < rows; ++row)
            for (unsigned int j = 0; j < n; ++j)
              for (unsigned int i = 0; i < n; ++i)
                {
                  // (u, v, outward) is right-handed on either end
                  const unsigned int u = stride[(d + (end == 0 ? 2 : 1)) % 3],
                                     v = stride[(d + (end == 0 ? 1 : 2)) % 3];
                  CellNodes cell;
                  for (unsigned int corner = 0; corner < 8; ++corner)
                    cell[corner] = node_of(end * stride[d] + (i + (corner & 1u)) * u +
                                             (j + ((corner >> 1) & 1u)) * v,
                                           row + (corner >> 2));
                  ball.cells.push_back(cell);
                }
    }

    Ball divide_ball(const unsigned int n, const unsigned int rows)
    {
      Ball               ball;
      const unsigned int along = n + 1;
      for (unsigned int node = 0; node < along * along * along; ++node)
        {
          const unsigned int i = node % along, j = node / along % along, k = node / (along * along);
          ball.nodes.push_back(core_part *
                               ball_core_point(2. / n * Vector3(i, j, k) - Vector3::Ones()));
          if (i == n || j == n || k == n)
            continue;
          CellNodes cell;
          for (unsigned int corner = 0; corner < 8; ++corner)
            cell[corner] =
              node + (corner & 1u) + ((corner >> 1) & 1u) * along + (corner >> 2) * along * along;
          ball.cells.push_back(cell);
        }
      add_shells(n, rows, ball);
      return ball;
    }
  } // namespace

  std::unique_ptr<BodyMesh> make_sphere(const double                       radius,
                                        const std::array<unsigned int, 2> &counts)
  {
    require(radius > 0., "sphere: its radius must be positive");
    require_core(counts[0], counts[1], "sphere");

    auto mesh  = std::make_unique<BodyMesh>();
    mesh->name = "sphere";
    Ball ball  = divide_ball(counts[0], counts[1]);
    for (Vector3 &node : ball.nodes)
      node *= radius;
    create_triangulation(*mesh, ball.nodes, ball.cells);

    const unsigned int along  = counts[0] + 1;
    mesh->node_sets["centre"] = {along * along * along / 2};
    add_named_side(*mesh, "outer", [&](const unsigned int i) {
      return i >= ball.nodes.size() - ball.border;
    });
    name_boundaries(*mesh, {"outer"});
    curve_outer(*mesh, dealii::SphericalManifold<3>());
    return mesh;
  }
} // namespace vfife
