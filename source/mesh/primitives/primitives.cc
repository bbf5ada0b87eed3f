// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include "requirement.h"

#include <vfife/mesh/boundary_surface.h>
#include <vfife/mesh/primitives/primitives.h>

#include <algorithm>

namespace vfife
{
  std::unique_ptr<BodyMesh>
  make_block(const Vector3 &size, const Counts &counts, const Vector3 &origin)
  {
    require(size.minCoeff() > 0., "block: its size must be positive in all directions");
    require(*std::min_element(counts.begin(), counts.end()) > 0,
            "block: at least one cell is needed in each direction");

    auto mesh  = std::make_unique<BodyMesh>();
    mesh->name = "block";
    // nodes are numbered x fastest; a cell is found at its lower corner
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
            x[d]        = origin[d] + size[d] * along(node, d) / counts[d];
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

    // sides: first and last nodes along each direction
    const char *axes = "xyz";
    for (unsigned int d = 0; d < 3; ++d)
      {
        const std::string axis(1, axes[d]);
        add_named_side(*mesh, axis + "-", [&](const unsigned int i) { return along(i, d) == 0; });
        add_named_side(*mesh, axis + "+", [&](const unsigned int i) {
          return along(i, d) == counts[d];
        });
      }
    name_boundaries(*mesh, {"x-", "x+", "y-", "y+", "z-", "z+"});
    return mesh;
  }

  std::unique_ptr<BodyMesh> make_beam(const Vector3 &size, const Counts &counts)
  {
    auto mesh  = make_block(size, counts, {0., -.5 * size[1], -.5 * size[2]});
    mesh->name = "beam";
    return mesh;
  }

  std::unique_ptr<BodyMesh> make_moved(const BodyMesh                                &mesh,
                                       const std::string                             &name,
                                       const std::function<Vector3(const Vector3 &)> &place)
  {
    std::vector<Vector3>   nodes;
    std::vector<CellNodes> hexahedra;
    for (const auto &x : mesh.triangulation.get_vertices())
      nodes.push_back(place(Vector3(x[0], x[1], x[2])));
    for (const auto &cell : mesh.triangulation.active_cell_iterators())
      {
        CellNodes corners;
        for (unsigned int v = 0; v < 8; ++v)
          corners[v] = cell->vertex_index(v);
        hexahedra.push_back(corners);
      }
    auto moved  = std::make_unique<BodyMesh>();
    moved->name = name;
    create_triangulation(*moved, nodes, hexahedra);
    return moved;
  }
} // namespace vfife
