// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/mesh/files/exported_mesh.h>
#include <vfife/mesh/hexahedron_corners.h>

#include <cctype>
#include <map>

namespace vfife
{
  namespace
  {
    /** Appends a body's nodes, elements and named parts, numbers counted on from those before. */
    void add_body(const ExportedBody &body, const unsigned int number, ExportedMesh &all)
    {
      const BodyMesh &mesh = *body.mesh;
      if (mesh.triangulation.has_hanging_nodes())
        throw InputError("export of " + body.name +
                         ": a locally refined mesh (hanging nodes) cannot be exported");
      const unsigned int first_node = all.nodes.size(), first_element = all.elements.size();
      // nodes where the body stands, and their sets
      for (const auto &x : mesh.triangulation.get_vertices())
        all.nodes.push_back(body.placement(Vector3(x[0], x[1], x[2])));
      for (const auto &set : mesh.node_sets)
        {
          all.node_sets.push_back({body.name + " " + set.first, set.second});
          for (unsigned int &node : all.node_sets.back().nodes)
            node += first_node;
        }

      // regions by material ids, surfaces by boundary ids, in the order in which they are met
      std::map<unsigned int, unsigned int> region_of_id, surface_of_id;
      const auto name_of = [](const std::map<unsigned int, std::string> &names,
                              const unsigned int                         id,
                              const std::string                         &other) {
        const auto found = names.find(id);
        return found == names.end() ? other : found->second;
      };
      for (const auto &cell : mesh.triangulation.active_cell_iterators())
        {
          const unsigned int element = first_element + cell->active_cell_index();
          CellNodes          nodes;
          for (unsigned int v = 0; v < 8; ++v)
            nodes[v] = first_node + cell->vertex_index(v);
          all.elements.push_back(nodes);
          all.sector.push_back(mesh.structure.sector_of_element(cell->active_cell_index()));
          all.body.push_back(number);

          const auto region = region_of_id.emplace(cell->material_id(), all.regions.size());
          if (region.second)
            all.regions.push_back(
              {body.name + " " + name_of(mesh.regions, cell->material_id(), "body"), number, {}});
          all.regions[region.first->second].elements.push_back(element);

          for (unsigned int f = 0; f < 6; ++f)
            {
              if (!cell->face(f)->at_boundary())
                continue;
              const auto id      = cell->face(f)->boundary_id();
              const auto surface = surface_of_id.emplace(id, all.surfaces.size());
              if (surface.second)
                all.surfaces.push_back(
                  {body.name + " " + name_of(mesh.boundaries, id, "outside"), {}});
              all.surfaces[surface.first->second].faces.push_back({element, f});
            }
        }
    }
  } // namespace

  std::array<unsigned int, 4> ExportedMesh::face_nodes(const Face &face) const
  {
    std::array<unsigned int, 4> result;
    for (unsigned int v = 0; v < 4; ++v)
      result[v] = elements[face.element][outward_faces[face.face][v]];
    return result;
  }

  ExportedMesh collect(const std::vector<ExportedBody> &bodies)
  {
    ExportedMesh all;
    for (unsigned int i = 0; i < bodies.size(); ++i)
      add_body(bodies[i], i, all);
    return all;
  }

  std::string abaqus_name(const std::string &name)
  {
    // Names of the format have letters, digits and _ only; sides such as x- and x+ stay apart.
    std::string result;
    for (const char c : name)
      if (c == '-')
        result += "_MINUS";
      else if (c == '+')
        result += "_PLUS";
      else
        result += std::isalnum(static_cast<unsigned char>(c)) != 0
                    ? static_cast<char>(std::toupper(static_cast<unsigned char>(c)))
                    : '_';
    return result;
  }
} // namespace vfife
