// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/parameters/expression.h>
#include <vfife/base/parameters/parameters.h>
#include <vfife/base/text/nearest_name.h>
#include <vfife/model/node_selection.h>

#include <numeric>
#include <set>

namespace vfife
{
  void NodeSelection::declare(dealii::ParameterHandler &prm)
  {
    declare_text(prm, "body", body, "Name of a body");
    declare_names(prm, "nodes", sets, "Node sets of the body, taken together; all: every node");
    declare_text(prm,
                 "where",
                 where,
                 "Condition on x, y, z [mm] in the undeformed body frame that the nodes must meet, "
                 "such as \"abs(y) < 0.1 && x > 5\"; empty: none");
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
                     "there is no body \"" + body + "\" (bodies: " + list_of(names) + ")" +
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
        try
          {
            const auto &members = selected_body.node_set(set);
            nodes.insert(members.begin(), members.end());
          }
        catch (const InputError &error)
          {
            throw InputError(section + "/nodes", error.what());
          }
    if (sets.empty())
      throw InputError(section + "/nodes", "which nodes? (a set of the body, or all)");
    if (!where.empty())
      try
        {
          // Anything but zero is true; there is no time yet.
          const Expression condition(where);
          for (auto node = nodes.begin(); node != nodes.end();)
            node = condition(selected_body.node_positions()[*node], 0.) != 0. ? std::next(node)
                                                                              : nodes.erase(node);
        }
      catch (const InputError &error)
        {
          throw InputError(section + "/where", error.what());
        }
    if (nodes.empty())
      throw InputError(section + (where.empty() ? "/nodes" : "/where"),
                       "no node of body \"" + selected_body.name() + "\" is selected");
    // Each node once, in ascending order.
    return {nodes.begin(), nodes.end()};
  }
} // namespace vfife
