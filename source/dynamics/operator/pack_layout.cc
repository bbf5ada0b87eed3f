// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/dynamics/operator/pack_layout.h>
#include <vfife/element/kernels/kernels.h>
#include <vfife/mesh/body_mesh.h>
#include <vfife/model/model.h>

#include <algorithm>
#include <tuple>
#include <utility>

namespace vfife
{
  namespace
  {
    /** A class with fewer members is cheaper with its lanes filled by others. */
    constexpr unsigned int least_shared_size = n_lanes / 2;

    void append_padded(std::vector<std::uint32_t> &packs,
                       const std::uint32_t        *first,
                       const std::size_t           n)
    {
      packs.insert(packs.end(), first, first + n);
      packs.insert(packs.end(), n_lanes - n, Partition::absent);
    }

    /** Nodes of the body that elements of other ranks touch: 1. */
    std::vector<std::uint8_t> find_border(const Body                       &body,
                                          const std::vector<std::uint32_t> &rank_of_element,
                                          const unsigned int                rank)
    {
      std::vector<std::uint8_t> border(body.n_nodes(), 0);
      for (std::uint32_t e = 0; e < body.n_elements(); ++e)
        if (rank_of_element[body.first_element + e] != rank)
          for (const std::uint32_t node : body.elements()[e])
            border[node] = 1;
      return border;
    }

    /** @p at_border: 1 for rows of `elements` that touch nodes of other ranks. */
    void fill_packs(BodyPacks                       &body,
                    const std::vector<std::uint8_t> &at_border,
                    const bool                       share_constants)
    {
      // 1. Rows of `elements` by congruence class.
      std::vector<std::vector<std::uint32_t>> members(body.classes.size.size());
      for (std::uint32_t row = 0; row < body.elements.size(); ++row)
        members[body.classes.class_of[row]].push_back(row);

      // 2. Large classes fill packs of their own, eight members each; the others are left for mixed
      // ones.
      struct Pack
      {
        std::uint32_t first, class_index, offset, n;
        bool          inside;
      };
      std::vector<Pack>          shared;
      std::vector<std::uint32_t> own;
      for (std::uint32_t c = 0; c < members.size(); ++c)
        if (share_constants && members[c].size() >= least_shared_size)
          for (std::uint32_t i = 0; i < members[c].size(); i += n_lanes)
            {
              const std::uint32_t n   = std::min<std::uint32_t>(n_lanes, members[c].size() - i);
              const auto          row = members[c].begin() + i;
              shared.push_back(
                {*row, c, i, n, std::none_of(row, row + n, [&](const std::uint32_t r) {
                   return at_border[r];
                 })});
            }
        else
          own.insert(own.end(), members[c].begin(), members[c].end());

      // 3. Shared packs: those that touch other ranks' nodes first, then by their first element.
      std::sort(shared.begin(), shared.end(), [](const Pack &a, const Pack &b) {
        return std::tie(a.inside, a.first) < std::tie(b.inside, b.first);
      });
      for (const Pack &pack : shared)
        {
          append_padded(body.shared_packs, &members[pack.class_index][pack.offset], pack.n);
          body.shared_class.push_back(pack.class_index);
          body.n_shared_at_border += !pack.inside;
        }

      // 4. Mixed packs: the same order, element by element.
      std::sort(own.begin(), own.end(), [&](const std::uint32_t a, const std::uint32_t b) {
        return std::make_pair(!at_border[a], a) < std::make_pair(!at_border[b], b);
      });
      for (std::size_t i = 0; i < own.size(); i += n_lanes)
        {
          append_padded(body.own_packs, &own[i], std::min<std::size_t>(n_lanes, own.size() - i));
          body.n_own_at_border += at_border[own[i]];
        }
    }

    /** Element of a body with its middle. */
    struct Place
    {
      Vector3       middle;
      std::uint32_t element;
    };

    /** Gives places [@p first, @p last) to @p n ranks from @p rank on: cut across the longest
     * extent of the middles into shares for the half of the ranks each, and so on. */
    void bisect(const std::vector<Place>::iterator first,
                const std::vector<Place>::iterator last,
                const std::uint32_t                rank,
                const std::uint32_t                n,
                std::vector<std::uint32_t>        &ranks)
    {
      if (n == 1 || first == last)
        {
          for (auto place = first; place != last; ++place)
            ranks[place->element] = rank;
          return;
        }
      Vector3 least = first->middle, most = first->middle;
      for (auto place = first; place != last; ++place)
        {
          least = least.cwiseMin(place->middle);
          most  = most.cwiseMax(place->middle);
        }
      Eigen::Index axis = 0;
      (most - least).maxCoeff(&axis);
      // Numbers decide between elements that lie abreast: all ranks cut alike.
      const std::uint32_t n_below = n / 2;
      const auto          middle  = first + (last - first) * n_below / n;
      std::nth_element(first, middle, last, [axis](const Place &a, const Place &b) {
        return std::make_pair(a.middle[axis], a.element) <
               std::make_pair(b.middle[axis], b.element);
      });
      bisect(first, middle, rank, n_below, ranks);
      bisect(middle, last, rank + n_below, n - n_below, ranks);
    }

    void bisect(const Body &body, const unsigned int n_ranks, std::vector<std::uint32_t> &ranks)
    {
      if (n_ranks == 1)
        return;
      std::vector<Place> places;
      for (std::uint32_t e = 0; e < body.n_elements(); ++e)
        places.push_back({body.element_nodes(e).rowwise().mean(), e});
      bisect(places.begin(), places.end(), 0, n_ranks, ranks);
    }
  } // namespace

  bool keeps_sectors(const Body &body, const unsigned int n_ranks)
  {
    // The copies of an element, one a sector, then fill at least half the lanes of a pack. Fewer
    // sectors a rank would also leave ranks with half as many again as others.
    const unsigned int n_sectors = body.structure().n_sectors();
    return n_ranks > 1 && n_sectors >= std::uint64_t(least_shared_size) * n_ranks;
  }

  std::vector<std::uint32_t> assign_elements(const Model &model, const unsigned int n_ranks)
  {
    std::vector<std::uint32_t> rank_of_element;
    rank_of_element.reserve(model.n_elements());
    for (unsigned int b = 0; b < model.bodies.size(); ++b)
      {
        const Body                &body = model.bodies[b];
        std::vector<std::uint32_t> parts(body.n_elements(), 0);
        if (keeps_sectors(body, n_ranks))
          {
            // Part p of n goes to rank p n_ranks/n, rounded down: shares that differ by one part at
            // most.
            const std::uint64_t n = body.structure().n_sectors();
            for (std::uint32_t e = 0; e < parts.size(); ++e)
              {
                const std::uint64_t sector = body.structure().sector_of_element(e);
                parts[e]                   = ((b % 2 == 1 ? n - 1 - sector : sector) * n_ranks) / n;
              }
          }
        else
          bisect(body, n_ranks, parts);
        // Every second body from the other end: a rank with one part more has one less there.
        for (const std::uint32_t part : parts)
          rank_of_element.push_back(b % 2 == 1 ? n_ranks - 1 - part : part);
      }
    return rank_of_element;
  }

  std::vector<BodyPacks> make_packs(const Model                      &model,
                                    const std::vector<std::uint32_t> &rank_of_element,
                                    const unsigned int                rank,
                                    const bool                        share_constants)
  {
    std::vector<BodyPacks> packs(model.bodies.size());
    for (unsigned int b = 0; b < model.bodies.size(); ++b)
      {
        const Body &body = model.bodies[b];
        for (std::uint32_t e = 0; e < body.n_elements(); ++e)
          if (rank_of_element[body.first_element + e] == rank)
            packs[b].elements.push_back(e);
        packs[b].classes = find_congruence_classes(body, packs[b].elements);

        // Elements at the border come first in each kind of pack: their forces are under way to the
        // neighbours while the others are computed.
        const std::vector<std::uint8_t> border = find_border(body, rank_of_element, rank);
        std::vector<std::uint8_t>       at_border;
        for (const std::uint32_t e : packs[b].elements)
          {
            const auto &nodes = body.elements()[e];
            at_border.push_back(std::any_of(nodes.begin(), nodes.end(), [&](const std::uint32_t i) {
              return border[i];
            }));
          }
        fill_packs(packs[b], at_border, share_constants);
      }
    return packs;
  }

  Partition make_partition(const Model                      &model,
                           const std::vector<BodyPacks>     &packs,
                           const std::vector<std::uint32_t> &rank_of_element,
                           const unsigned int                rank)
  {
    // 1. Local numbers as the packs meet the nodes: body, kind of pack, pack, corner, lane.
    Partition partition;
    partition.local_node.assign(model.n_nodes(), Partition::absent);
    for (unsigned int b = 0; b < model.bodies.size(); ++b)
      {
        const Body &body = model.bodies[b];
        partition.first_local_node.push_back(partition.n_local());
        for (const auto *rows : {&packs[b].shared_packs, &packs[b].own_packs})
          for (std::size_t pack = 0; pack < rows->size(); pack += n_lanes)
            for (unsigned int node = 0; node < 8; ++node)
              for (unsigned int lane = 0; lane < n_lanes; ++lane)
                {
                  if ((*rows)[pack + lane] == Partition::absent)
                    continue;
                  const std::uint32_t element = packs[b].elements[(*rows)[pack + lane]];
                  const std::uint32_t global  = body.first_node + body.elements()[element][node];
                  if (partition.local_node[global] == Partition::absent)
                    {
                      partition.local_node[global] = partition.n_local();
                      partition.global_node.push_back(global);
                    }
                }
        for (const std::uint32_t e : packs[b].elements)
          partition.elements.push_back(body.first_element + e);
      }
    partition.first_local_node.push_back(partition.n_local());

    // 2. The lowest rank that touches a node owns it.
    partition.owned.assign(partition.n_local(), 1);
    for (const Body &body : model.bodies)
      for (std::uint32_t e = 0; e < body.n_elements(); ++e)
        if (rank_of_element[body.first_element + e] < rank)
          for (const std::uint32_t node : body.elements()[e])
            {
              const std::uint32_t local = partition.local_node[body.first_node + node];
              if (local != Partition::absent)
                partition.owned[local] = 0;
            }
    return partition;
  }
} // namespace vfife
