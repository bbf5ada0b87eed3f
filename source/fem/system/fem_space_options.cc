// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/text/nearest_name.h>
#include <vfife/fem/system/fem_space_options.h>
#include <vfife/mesh/body_mesh.h>
#include <vfife/mesh/node_set_names.h>
#include <vfife/model/model.h>

#include <set>

namespace vfife
{
  namespace
  {
    /** The node sets that a name means. */
    std::vector<std::string> sets_of(const std::string &name)
    {
      if (name == "fillets")
        return {node_set::concave_fillet, node_set::convex_fillet};
      if (name == "flanks")
        return {surface_name::concave, surface_name::convex};
      return {name};
    }

    /** The nodes of a set or surface, sorted; none where the body has neither. */
    std::vector<unsigned int> nodes_of(const Body &body, const std::string &name)
    {
      if (body.has_node_set(name))
        return body.node_set(name);
      const BodyMesh        &mesh    = body.mesh();
      const auto             surface = mesh.surfaces.find(mesh.find_spelling(name));
      std::set<unsigned int> nodes;
      if (surface != mesh.surfaces.end())
        nodes.insert(surface->second.nodes.begin(), surface->second.nodes.end());
      return {nodes.begin(), nodes.end()};
    }
  } // namespace

  const Choices<FemGeometry> &fem_geometry_choices()
  {
    static const Choices<FemGeometry> choices = {{"straight", FemGeometry::straight},
                                                 {"curved", FemGeometry::curved}};
    return choices;
  }

  std::vector<LocalRefinement> read_local_refinements(const std::vector<std::string> &texts)
  {
    constexpr unsigned int       most = 5;
    std::vector<LocalRefinement> refinements;
    for (const std::string &text : texts)
      {
        const std::size_t blank = text.find_last_of(' ');
        const std::string times = blank == std::string::npos ? "" : text.substr(blank + 1);
        if (times.size() != 1 || times[0] < '1' || times[0] > '0' + int(most))
          throw InputError("expected a name and 1 to " + std::to_string(most) +
                           " times, such as fillets 2, got \"" + text + "\"");
        refinements.push_back(
          {text.substr(0, text.find_last_not_of(' ', blank) + 1), unsigned(times[0] - '0')});
      }
    return refinements;
  }

  bool is_everywhere(const LocalRefinement &refinement)
  {
    return refinement.around == "all";
  }

  std::vector<std::vector<unsigned int>> nodes_of_refinement(const LocalRefinement &refinement,
                                                             const Body            &body)
  {
    std::vector<std::vector<unsigned int>> lists;
    for (const std::string &set : sets_of(refinement.around))
      lists.push_back(nodes_of(body, set));
    return lists;
  }

  void check_refinements(const Model &model, const std::vector<LocalRefinement> &refinements)
  {
    for (const LocalRefinement &asked : refinements)
      {
        if (is_everywhere(asked))
          continue;
        std::vector<std::string> known = {"all", "fillets", "flanks"};
        bool                     found = false;
        for (const Body &body : model.bodies)
          {
            for (const std::vector<unsigned int> &nodes : nodes_of_refinement(asked, body))
              found = found || !nodes.empty();
            for (const auto &set : body.mesh().node_sets)
              known.push_back(set.first);
            for (const auto &surface : body.mesh().surfaces)
              known.push_back(surface.first);
          }
        if (!found)
          throw InputError("Fem/local refinement",
                           "expected all or the name of a surface or node set, got \"" +
                             asked.around + "\"" + did_you_mean(asked.around, known));
      }
  }
} // namespace vfife
