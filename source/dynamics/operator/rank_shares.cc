// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/dynamics/operator/pack_layout.h>
#include <vfife/dynamics/operator/rank_shares.h>
#include <vfife/model/model.h>

#include <algorithm>
#include <set>

namespace vfife
{
  std::vector<RankShare> find_shares(const Model &model, const unsigned int n_ranks)
  {
    const std::vector<std::uint32_t>     rank_of_element = assign_elements(model, n_ranks);
    std::vector<RankShare>               shares(n_ranks);
    std::vector<std::set<std::uint32_t>> neighbours(n_ranks);
    for (const Body &body : model.bodies)
      {
        // 1. The ranks of each node's elements.
        const bool                              whole = keeps_sectors(body, n_ranks);
        std::vector<std::vector<std::uint32_t>> ranks(body.n_nodes());
        for (std::uint32_t e = 0; e < body.n_elements(); ++e)
          {
            const std::uint32_t rank = rank_of_element[body.first_element + e];
            ++(whole ? shares[rank].in_sectors : shares[rank].in_pieces);
            for (const std::uint32_t node : body.elements()[e])
              if (auto &of_node = ranks[node];
                  std::find(of_node.begin(), of_node.end(), rank) == of_node.end())
                of_node.push_back(rank);
          }
        // 2. Each of them sends its part to all others.
        for (const auto &of_node : ranks)
          for (const std::uint32_t from : of_node)
            {
              shares[from].n_sent += of_node.size() - 1;
              for (const std::uint32_t to : of_node)
                if (to != from)
                  neighbours[from].insert(to);
            }
      }
    for (unsigned int rank = 0; rank < n_ranks; ++rank)
      shares[rank].n_neighbours = neighbours[rank].size();
    return shares;
  }
} // namespace vfife
