// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include "boundary_set.h"

#include <algorithm>
#include <numeric>

namespace vfife
{
  std::vector<BoundaryFace> find_whole_boundary(const Body &body)
  {
    std::vector<unsigned int> all(body.n_nodes());
    std::iota(all.begin(), all.end(), 0u);
    return find_boundary_faces(body, all);
  }

  BoundarySet::BoundarySet(const Body                      &body,
                           const std::vector<unsigned int> &nodes,
                           const std::vector<BoundaryFace> &boundary,
                           const bool                       edges_of_faces)
    : nodes_(body.n_nodes(), false)
  {
    for (const unsigned int node : nodes)
      nodes_[node] = true;
    for (const BoundaryFace &face : boundary)
      {
        std::array<unsigned int, 4> corners = face.nodes;
        const bool                  whole   = std::all_of(corners.begin(),
                                       corners.end(),
                                       [this](const unsigned int node) { return nodes_[node]; });
        for (unsigned int k = 0; k < 4; ++k)
          {
            const unsigned int one = corners[k], two = corners[(k + 1) % 4];
            if (whole || (!edges_of_faces && nodes_[one] && nodes_[two]))
              edges_.insert(std::array<unsigned int, 2>{{std::min(one, two), std::max(one, two)}});
          }
        std::sort(corners.begin(), corners.end());
        if (whole)
          faces_.insert(corners);
      }
  }

  bool BoundarySet::contains(const std::vector<unsigned int> &nodes) const
  {
    switch (nodes.size())
      {
      case 1:
        return nodes_[nodes[0]];
      case 2:
        return edges_.count({{nodes[0], nodes[1]}}) != 0;
      case 4:
        return faces_.count({{nodes[0], nodes[1], nodes[2], nodes[3]}}) != 0;
      default:
        return false; // inside an element
      }
  }
} // namespace vfife
