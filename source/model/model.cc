// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/text/nearest_name.h>
#include <vfife/contact/surface/facet_integrals.h>
#include <vfife/mesh/body_mesh.h>
#include <vfife/model/model.h>

#include <algorithm>
#include <unordered_map>

namespace vfife
{
  unsigned int Model::add_body(Body &&body)
  {
    // Bodies lie behind each other in the model's numbering.
    body.first_node    = n_nodes();
    body.first_element = n_elements();
    bodies.push_back(std::move(body));
    return bodies.size() - 1;
  }

  unsigned int Model::n_nodes() const
  {
    return bodies.empty() ? 0 : bodies.back().first_node + bodies.back().n_nodes();
  }

  bool Model::any_body_turns() const
  {
    return std::any_of(bodies.begin(), bodies.end(), [](const Body &body) {
      return body.rate != 0;
    });
  }

  bool Model::has_initial_strains() const
  {
    return std::any_of(bodies.begin(), bodies.end(), [](const Body &body) {
      return body.has_initial_strains();
    });
  }

  const Transmission *Model::only_transmission() const
  {
    if (transmissions.size() > 1)
      {
        std::vector<std::string> pairs;
        for (const Transmission &t : transmissions)
          pairs.push_back(bodies[t.driver].name() + " with " + bodies[t.driven].name());
        throw InputError("expected at most one gear pair, got " + std::to_string(pairs.size()) +
                         " (" + list_of(pairs) +
                         "). Transmission errors, equilibria, root stresses and reduced models "
                         "are those of a single pair");
      }
    return transmissions.empty() ? nullptr : &transmissions.front();
  }

  unsigned int Model::n_elements() const
  {
    return bodies.empty() ? 0 : bodies.back().first_element + bodies.back().n_elements();
  }

  bool is_one_of(const SelectedFaces &faces, std::array<unsigned int, 4> nodes)
  {
    if (!faces)
      return true;
    std::sort(nodes.begin(), nodes.end());
    return faces->count(nodes) != 0;
  }

  std::vector<double> compute_nodal_areas(const Body                      &body,
                                          const std::vector<unsigned int> &nodes,
                                          const SelectedFaces             &faces)
  {
    // Place of a node in the set.
    std::unordered_map<unsigned int, unsigned int> row;
    for (unsigned int i = 0; i < nodes.size(); ++i)
      row.emplace(nodes[i], i);

    // Places of the body frame: a placement changes no area.
    const auto         &x = body.node_positions();
    std::vector<double> areas(nodes.size(), 0.);
    for (const auto &cell : body.mesh().triangulation.active_cell_iterators())
      {
        if (!cell->at_boundary())
          continue;
        for (const unsigned int f : cell->face_indices())
          {
            if (!cell->face(f)->at_boundary())
              continue;
            // A face counts when all its corners are in the set: an edge of it alone carries no
            // area.
            std::array<unsigned int, 4> v;
            bool                        inside = true;
            for (unsigned int i = 0; i < 4; ++i)
              {
                v[i]   = cell->face(f)->vertex_index(i);
                inside = inside && row.count(v[i]) != 0;
              }
            if (!inside || !is_one_of(faces, v))
              continue;
            // A face's vertices are lexicographic, as its functions are: 0 and 3 are opposite.
            const auto integrals = integrate_areas({{x[v[0]], x[v[1]], x[v[3]], x[v[2]]}});
            for (unsigned int i = 0; i < 4; ++i)
              areas[row[v[i]]] += integrals[i];
          }
      }
    return areas;
  }
} // namespace vfife
