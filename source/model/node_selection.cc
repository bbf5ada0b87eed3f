// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/parameters/expression.h>
#include <vfife/base/parameters/parameters.h>
#include <vfife/base/text/nearest_name.h>
#include <vfife/mesh/body_mesh.h>
#include <vfife/model/load_shares.h>
#include <vfife/model/node_selection.h>

#include <algorithm>
#include <set>

namespace vfife
{
  void NodeSelection::declare(dealii::ParameterHandler &prm)
  {
    declare_text(prm, "body", body, "Name of a body");
    declare_names(prm, "nodes", sets, "Node sets of the body, combined; all: every node");
    declare_text(prm,
                 "where",
                 where,
                 "Condition on x, y, z [mm] in the undeformed body frame for selected "
                 "nodes, such as \"abs(y) < 0.1 && x > 5\"; empty: no condition");
  }

  unsigned int NodeSelection::find_body(const std::vector<Body> &bodies,
                                        const std::string       &section,
                                        const std::string       &entry) const
  {
    std::vector<std::string> names;
    for (unsigned int b = 0; b < bodies.size(); ++b)
      {
        if (bodies[b].name() == body)
          return b;
        names.push_back(bodies[b].name());
      }
    // With one body its name may be left out.
    if (body.empty() && bodies.size() == 1)
      return 0;
    throw InputError(section + "/" + entry,
                     "expected a body, got \"" + body + "\" (bodies: " + list_of(names) + ")" +
                       did_you_mean(body, names));
  }

  std::vector<unsigned int> NodeSelection::find_nodes(const Body        &selected_body,
                                                      const std::string &section) const
  {
    // Sets are united first; "where" then takes nodes away.
    std::set<unsigned int> nodes;
    for (const std::string &set : sets)
      if (set == "all")
        for (unsigned int i = 0; i < selected_body.n_nodes(); ++i)
          nodes.insert(nodes.end(), i);
      else
        for_entry(section + "/nodes", [&] {
          const auto &members = selected_body.node_set(set);
          nodes.insert(members.begin(), members.end());
        });
    if (sets.empty())
      throw InputError(section + "/nodes", "is empty. Give node sets of the body, or all");
    if (!where.empty())
      for_entry(section + "/where", [&] {
        // Anything but zero is true.
        const Expression condition(where);
        for (auto node = nodes.begin(); node != nodes.end();)
          node = condition.holds(selected_body.node_positions()[*node]) ? std::next(node)
                                                                        : nodes.erase(node);
      });
    if (nodes.empty())
      throw InputError(section + (where.empty() ? "/nodes" : "/where"),
                       "no node of body \"" + selected_body.name() + "\" is selected");
    // Each node once, in ascending order.
    return {nodes.begin(), nodes.end()};
  }

  SelectedFaces NodeSelection::find_faces(const Body                      &selected_body,
                                          const std::vector<unsigned int> &nodes,
                                          const std::string               &section) const
  {
    // 1. Facets of the surfaces, and the nodes of what is none.
    const BodyMesh        &mesh = selected_body.mesh();
    FaceSet                faces;
    std::set<unsigned int> of_sets;
    bool                   has_surface = false;
    for (const std::string &set : sets)
      {
        if (set == "all")
          return {};
        const std::string name     = mesh.find_spelling(set);
        const auto        unusable = mesh.unusable_surfaces.find(name);
        if (unusable != mesh.unusable_surfaces.end())
          throw InputError(section + "/nodes", unusable->second);
        const auto surface = mesh.surfaces.find(name);
        if (surface != mesh.surfaces.end())
          {
            has_surface = true;
            faces.merge(faces_of(surface->second));
          }
        else
          {
            const auto &members = selected_body.node_set(name);
            of_sets.insert(members.begin(), members.end());
          }
      }
    if (!has_surface)
      return {};
    for (const BoundaryFace &face :
         find_boundary_faces(selected_body, {of_sets.begin(), of_sets.end()}))
      {
        auto corners = face.nodes;
        std::sort(corners.begin(), corners.end());
        faces.insert(corners);
      }
    // 2. Without those that "where" leaves out, at one corner at least.
    for (auto face = faces.begin(); face != faces.end();)
      {
        const bool selected = std::all_of(face->begin(), face->end(), [&](const unsigned int node) {
          return std::binary_search(nodes.begin(), nodes.end(), node);
        });
        face                = selected ? std::next(face) : faces.erase(face);
      }
    return faces;
  }
} // namespace vfife
