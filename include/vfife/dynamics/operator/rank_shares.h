// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_dynamics_operator_rank_shares_h
#define vfife_dynamics_operator_rank_shares_h

#include <cstdint>
#include <vector>

namespace vfife
{
  struct Model;

  /** What one of several ranks has of a model, and what it sends in a step for its elements. */
  struct RankShare
  {
    std::uint64_t in_sectors   = 0; ///< elements of bodies whose sectors stay whole
    std::uint64_t in_pieces    = 0; ///< of the others
    std::uint64_t n_neighbours = 0; ///< ranks that share nodes: messages of a step
    std::uint64_t n_sent       = 0; ///< nodes whose forces it sends, once for each neighbour

    std::uint64_t n_elements() const
    {
      return in_sectors + in_pieces;
    }

    /** In the messages of a step. */
    std::uint64_t bytes() const
    {
      return 3 * sizeof(double) * n_sent;
    }
  };

  /** Of each of @p n_ranks ranks, as HaloExchange has them, without there being so many. */
  std::vector<RankShare> find_shares(const Model &model, unsigned int n_ranks);
} // namespace vfife

#endif
