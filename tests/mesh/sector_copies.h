// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_tests_mesh_sector_copies_h
#define vfife_tests_mesh_sector_copies_h

#include "../tests.h"

#include <vfife/mesh/body_mesh.h>
#include <vfife/mesh/boundary_surface.h>

#include <algorithm>
#include <iterator>
#include <numeric>
#include <vector>

inline vfife::Vector3 vertex(const vfife::BodyMesh &mesh, const unsigned int i)
{
  const auto &x = mesh.triangulation.get_vertices()[i];
  return {x[0], x[1], x[2]};
}

/** Least and largest z of the nodes of a set [mm]. */
inline vfife::Vector2 ends_of(const vfife::BodyMesh &mesh, const char *set)
{
  vfife::Vector2 ends(1e9, -1e9);
  for (const unsigned int node : mesh.node_sets.at(set))
    {
      const double z = vertex(mesh, node)[2];
      ends           = {std::min(ends[0], z), largest_of(ends[1], z)};
    }
  return ends;
}

/** Node i of sector k is node i of sector 0 turned by k pitches, and so are cells. */
inline void check_copies(const vfife::BodyMesh &mesh)
{
  const unsigned int nodes   = mesh.triangulation.n_vertices() / mesh.structure.n_sectors();
  const unsigned int cells   = mesh.triangulation.n_active_cells() / mesh.structure.n_sectors();
  const unsigned int n       = mesh.triangulation.n_vertices();
  double             largest = 0.;
  for (unsigned int i = 0; i < n; ++i)
    {
      const vfife::Matrix3 rotation =
        vfife::rotation_about(vfife::Vector3::UnitZ(),
                              2. * vfife::pi * (i / nodes) / mesh.structure.n_sectors());
      largest = largest_of(largest, (vertex(mesh, i) - rotation * vertex(mesh, i % nodes)).norm());
    }
  check_below(mesh.name + ": copies of the sector's nodes [mm]", largest, 1e-12);

  bool same = true;
  for (const auto &cell : mesh.triangulation.active_cell_iterators())
    {
      const unsigned int e = cell->active_cell_index(), k = e / cells;
      const auto         first = std::next(mesh.triangulation.begin_active(), e % cells);
      same                     = same && mesh.structure.sector_of_element(e) == k;
      for (unsigned int v = 0; v < 8; ++v)
        same = same && cell->vertex_index(v) == (first->vertex_index(v) + k * nodes) % n;
    }
  check(mesh.name + ": cells are copies, sector by sector", same);
}

/** A body around an axis with a bore is bounded by a torus: no border, Euler characteristic 0.
 * Returns the number of faces. */
inline std::size_t check_closed(const vfife::BodyMesh &mesh)
{
  std::vector<unsigned int> all(mesh.triangulation.n_vertices());
  std::iota(all.begin(), all.end(), 0u);
  const auto surface = vfife::surface_of_boundary(mesh.triangulation, "all", all);
  bool       closed  = true;
  for (const auto &sides : surface.neighbours)
    for (const unsigned int neighbour : sides)
      closed = closed && neighbour != vfife::FacetSurface::no_facet;
  const long faces = surface.facets.size(), euler = long(surface.nodes.size()) - 2 * faces + faces;
  check(mesh.name + ": boundary is closed", closed && euler == 0);
  return faces;
}

#endif
