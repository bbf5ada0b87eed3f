// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/mesh/body_mesh.h>

#include <deal.II/grid/tria_description.h>

#include <boost/algorithm/string/predicate.hpp>

#include <algorithm>
#include <cstdint>

namespace vfife
{
  std::string BodyMesh::find_spelling(const std::string &name) const
  {
    if (!names_without_case || node_sets.count(name) != 0)
      return name;
    for (const auto &set : node_sets)
      if (boost::iequals(set.first, name, std::locale::classic()))
        return set.first;
    return name;
  }

  FaceSet faces_of(const FacetSurface &surface)
  {
    FaceSet faces;
    for (const auto &facet : surface.facets)
      {
        std::array<unsigned int, 4> nodes;
        for (unsigned int i = 0; i < 4; ++i)
          nodes[i] = surface.nodes[facet[i]];
        std::sort(nodes.begin(), nodes.end());
        faces.insert(nodes);
      }
    return faces;
  }

  void create_triangulation(BodyMesh                        &mesh,
                            const std::vector<Vector3>      &nodes,
                            const std::vector<CellNodes>    &hexahedra,
                            const std::vector<unsigned int> &regions,
                            const unsigned int               n_sectors)
  {
    mesh.structure = BodyStructure(n_sectors, nodes.size(), hexahedra.size());

    std::vector<dealii::Point<3>> points;
    points.reserve(nodes.size());
    for (const Vector3 &node : nodes)
      points.emplace_back(node[0], node[1], node[2]);

    // deal.II's cell data; nodes without a cell would be left out and all others renumbered
    std::vector<bool>                used(nodes.size(), false);
    std::vector<dealii::CellData<3>> cells(hexahedra.size());
    for (std::size_t e = 0; e < regions.size(); ++e)
      cells[e].material_id = regions[e];
    for (std::size_t e = 0; e < hexahedra.size(); ++e)
      for (unsigned int v = 0; v < 8; ++v)
        {
          cells[e].vertices[v]     = hexahedra[e][v];
          used.at(hexahedra[e][v]) = true;
        }
    for (std::size_t i = 0; i < used.size(); ++i)
      if (!used[i])
        throw InputError("mesh " + mesh.name + ": node " + std::to_string(i) +
                         " belongs to no element");

    // It reorders cells whose edges do not agree in direction: that must not have happened.
    mesh.triangulation.create_triangulation(points, cells, dealii::SubCellData());

    for (const auto &cell : mesh.triangulation.active_cell_iterators())
      for (unsigned int v = 0; v < 8; ++v)
        if (cell->vertex_index(v) != hexahedra[cell->active_cell_index()][v])
          throw NumericalError("mesh " + mesh.name + ": deal.II renumbered element " +
                               std::to_string(cell->active_cell_index()));
  }

  void name_surface_faces(BodyMesh &mesh, const std::vector<std::string> &names)
  {
    std::map<std::array<unsigned int, 4>, unsigned int> ids;
    for (unsigned int i = 0; i < names.size(); ++i)
      {
        mesh.boundaries[i + 1] = names[i];
        for (const auto &nodes : faces_of(mesh.surfaces.at(names[i])))
          ids.emplace(nodes, i + 1);
      }
    for (const auto &cell : mesh.triangulation.active_cell_iterators())
      for (const auto &face : cell->face_iterators())
        {
          if (!face->at_boundary())
            continue;
          std::array<unsigned int, 4> nodes;
          for (unsigned int v = 0; v < 4; ++v)
            nodes[v] = face->vertex_index(v);
          std::sort(nodes.begin(), nodes.end());
          const auto found = ids.find(nodes);
          face->set_boundary_id(found == ids.end() ? 0 : found->second);
        }
  }

  void name_boundaries(BodyMesh &mesh, const std::vector<std::string> &names)
  {
    // A face has one boundary id, a node may be in several sets: names become ids 1, 2, ... of
    // faces, 0 is the rest of the surface.
    // One bit a name: a face belongs to the sets that all its four nodes have.
    std::vector<std::uint32_t> sets_of_node(mesh.triangulation.n_vertices(), 0);
    Assert(names.size() <= most_boundaries, dealii::ExcInternalError());
    for (unsigned int i = 0; i < names.size(); ++i)
      {
        const auto set = mesh.node_sets.find(names[i]);
        if (set == mesh.node_sets.end())
          continue;
        mesh.boundaries[i + 1] = names[i];
        for (const unsigned int node : set->second)
          sets_of_node[node] |= std::uint32_t(1) << i;
      }
    for (const auto &cell : mesh.triangulation.active_cell_iterators())
      for (const auto &face : cell->face_iterators())
        {
          if (!face->at_boundary())
            continue;
          std::uint32_t common = ~std::uint32_t(0);
          for (unsigned int v = 0; v < 4; ++v)
            common &= sets_of_node[face->vertex_index(v)];
          // the first name in the list wins
          unsigned int id = 0;
          for (unsigned int i = names.size(); i > 0; --i)
            if ((common >> (i - 1) & 1u) != 0)
              id = i;
          face->set_boundary_id(id);
        }
  }
} // namespace vfife
