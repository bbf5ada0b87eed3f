// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/dynamics/loads/contact/contact_nodes.h>
#include <vfife/dynamics/loads/contact/contact_of_pair.h>
#include <vfife/dynamics/operator/pack_layout.h>

#include <algorithm>
#include <map>
#include <set>

namespace vfife
{
  namespace
  {
    std::vector<std::vector<unsigned int>> find_group_nodes(const FacetSurface &surface)
    {
      std::vector<std::set<unsigned int>> nodes(surface.n_groups);
      for (std::size_t f = 0; f < surface.facets.size(); ++f)
        nodes[surface.group[f]].insert(surface.facets[f].begin(), surface.facets[f].end());
      std::vector<std::vector<unsigned int>> lists;
      for (const auto &of_group : nodes)
        lists.emplace_back(of_group.begin(), of_group.end());
      return lists;
    }
  } // namespace

  ContactNodes::ContactNodes(const Model        &model,
                             const ContactPairs &pairs,
                             const unsigned int  n_ranks)
  {
    std::map<std::pair<unsigned int, unsigned int>, unsigned int> numbers;
    for (const auto &pair : pairs)
      for (ContactSurface *surface : pair->surfaces())
        {
          surfaces.push_back(surface);
          of_groups.push_back(find_group_nodes(*surface->facets));
          for (const unsigned int node : surface->facets->nodes)
            surface->numbers.push_back(
              numbers.emplace(std::make_pair(surface->body, node), numbers.size()).first->second);
        }
    n_numbers = numbers.size();
    if (n_ranks == 1)
      return;
    const std::vector<std::uint32_t> rank_of_element = assign_elements(model, n_ranks);
    for (const ContactSurface *surface : surfaces)
      {
        // Nodes of the body by their number in the surface.
        const Body                &body = model.bodies[surface->body];
        std::vector<std::uint32_t> number(body.n_nodes(), Partition::absent);
        for (std::size_t i = 0; i < surface->facets->nodes.size(); ++i)
          number[surface->facets->nodes[i]] = i;
        std::vector<Ranks> of_nodes(surface->facets->nodes.size());
        for (std::uint32_t e = 0; e < body.n_elements(); ++e)
          for (const std::uint32_t node : body.elements()[e])
            if (number[node] != Partition::absent)
              {
                Ranks     &ranks = of_nodes[number[node]];
                const auto rank  = rank_of_element[body.first_element + e];
                const auto place = std::lower_bound(ranks.begin(), ranks.end(), rank);
                if (place == ranks.end() || *place != rank)
                  ranks.insert(place, rank);
              }
        holders.push_back(std::move(of_nodes));
      }
  }
} // namespace vfife
