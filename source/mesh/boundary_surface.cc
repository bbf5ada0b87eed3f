// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/mesh/boundary_surface.h>
#include <vfife/mesh/hexahedron_corners.h>

#include <algorithm>
#include <map>

namespace vfife
{
  namespace
  {
    using FaceNodes = std::array<unsigned int, 4>;
    using FaceTest  = std::function<bool(dealii::types::boundary_id, const FaceNodes &)>;

    /** Facets of the boundary faces that pass the test, numbered as first met; a node's normal is
     * the sum of its facets' area vectors, normalised. */
    FacetSurface collect_facets(const dealii::Triangulation<3> &triangulation,
                                const std::string              &name,
                                const FaceTest                 &takes)
    {
      FacetSurface                         surface;
      std::map<unsigned int, unsigned int> surface_node;
      surface.name = name;

      for (const auto &cell : triangulation.active_cell_iterators())
        for (unsigned int f = 0; f < 6; ++f)
          {
            if (!cell->face(f)->at_boundary())
              continue;
            // corners of the face, counter-clockwise seen from outside
            FaceNodes              nodes;
            std::array<Vector3, 4> x;
            for (unsigned int v = 0; v < 4; ++v)
              {
                const auto &corner = cell->vertex(outward_faces[f][v]);
                nodes[v]           = cell->vertex_index(outward_faces[f][v]);
                x[v]               = Vector3(corner[0], corner[1], corner[2]);
              }
            if (!takes(cell->face(f)->boundary_id(), nodes))
              continue;

            // the same as places among the surface's nodes; new ones are added
            FaceNodes facet;
            for (unsigned int v = 0; v < 4; ++v)
              {
                const auto found = surface_node.emplace(nodes[v], surface.nodes.size());
                if (found.second)
                  {
                    surface.nodes.push_back(nodes[v]);
                    surface.positions.push_back(x[v]);
                    surface.normals.push_back(Vector3::Zero());
                  }
                facet[v] = found.first->second;
                surface.normals[facet[v]] += (x[2] - x[0]).cross(x[3] - x[1]); // twice the area
              }
            surface.facets.push_back(facet);
          }

      // Area vectors were summed up: large facets count more in a node's normal.
      // mean normals, neighbours
      if (surface.facets.empty())
        throw InputError("surface " + name + " has no boundary face");
      for (Vector3 &normal : surface.normals)
        normal.normalize();
      surface.group.assign(surface.facets.size(), 0);
      find_neighbours(surface);
      return surface;
    }
  } // namespace

  FacetSurface surface_of_boundary(const dealii::Triangulation<3>  &triangulation,
                                   const std::string               &name,
                                   const std::vector<unsigned int> &nodes)
  {
    return collect_facets(
      triangulation, name, [&nodes](dealii::types::boundary_id, const FaceNodes &face) {
        return std::all_of(face.begin(), face.end(), [&nodes](const unsigned int i) {
          return std::binary_search(nodes.begin(), nodes.end(), i);
        });
      });
  }

  FacetSurface surface_of_boundary(const dealii::Triangulation<3> &triangulation,
                                   const std::string              &name,
                                   const FaceSet                  &faces)
  {
    return collect_facets(triangulation,
                          name,
                          [&faces](dealii::types::boundary_id, FaceNodes face) {
                            std::sort(face.begin(), face.end());
                            return faces.count(face) != 0;
                          });
  }

  FacetSurface surface_of_boundary(const dealii::Triangulation<3>  &triangulation,
                                   const std::string               &name,
                                   const dealii::types::boundary_id boundary)
  {
    return collect_facets(triangulation,
                          name,
                          [boundary](const dealii::types::boundary_id id, const FaceNodes &) {
                            return id == boundary;
                          });
  }

  void add_named_side(BodyMesh                                &mesh,
                      const std::string                       &name,
                      const std::function<bool(unsigned int)> &selected)
  {
    auto &set = mesh.node_sets[name];
    for (unsigned int i = 0; i < mesh.triangulation.n_vertices(); ++i)
      if (selected(i))
        set.push_back(i);
    // Nodes are selected in ascending order, as the search among them wants.
    mesh.surfaces[name] = surface_of_boundary(mesh.triangulation, name, set);
  }
} // namespace vfife
