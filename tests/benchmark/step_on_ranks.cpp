// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include "step_on_ranks.h"

#include <vfife/base/process/communicator.h>
#include <vfife/base/process/wall_clock.h>
#include <vfife/dynamics/loads/contact/contact_dealing.h>
#include <vfife/dynamics/loads/contact/contact_ranks.h>
#include <vfife/dynamics/operator/rank_shares.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace vfife
{
  namespace
  {
    constexpr int          there_tag = 20, back_tag = 21;
    constexpr unsigned int largest_number = 1024;   ///< of ranks for which a step is estimated
    constexpr double       latency        = 1.5e-6; ///< assumed of a message [s]
    constexpr double       bandwidth      = 10;     ///< assumed of a rank [GB/s]

    /** Tooth pairs that share the load: clusters of like work. */
    const std::vector<double> pairs_in_mesh(2, .5);

    /** Least time of one way, there and back by the first two ranks [s]. */
    double measure_way(const Communicator &communicator, const std::size_t n_bytes)
    {
      constexpr unsigned int n_rounds = 20, n_ways = 50;
      const bool             first = communicator.rank() == 0;
      std::vector<char>      sent(n_bytes), received(n_bytes);
      double                 least = std::numeric_limits<double>::infinity();
      for (unsigned int round = 0; round < n_rounds; ++round)
        {
          const auto start = WallClock::now();
          for (unsigned int way = 0; way < n_ways; ++way)
            {
              std::vector<MPI_Request> requests = {communicator.start_receiving(
                received.data(), n_bytes, first ? 1 : 0, first ? back_tag : there_tag)};
              if (!first)
                Communicator::wait(requests);
              requests.push_back(communicator.start_sending(
                sent.data(), n_bytes, first ? 1 : 0, first ? there_tag : back_tag));
              Communicator::wait(requests);
            }
          least = std::min(least, seconds_since(start) / (2 * n_ways));
        }
      return least;
    }
  } // namespace

  Table measure_messages(const Communicator &communicator)
  {
    Table table{{"length", "B"}, {"time", "us"}, {"bandwidth", "GB/s"}};
    if (communicator.size() > 1)
      for (std::size_t n_bytes = 8; n_bytes <= (std::size_t(1) << 20); n_bytes *= 8)
        {
          const double time    = communicator.rank() < 2 ? measure_way(communicator, n_bytes) : 0.;
          const double longest = communicator.max(time);
          table.add_row({n_bytes, 1e6 * longest, 1e-9 * n_bytes / longest});
        }
    return table;
  }

  Table estimate_steps(const Model &model, const CoreTimes &core)
  {
    Table  table{{"ranks", "-"},
                {"most elements", "-"},
                {"of them in pieces", "-"},
                {"most neighbours", "-"},
                {"most sent", "kB"},
                {"elements and nodes", "us"},
                {"halo", "us"},
                {"contact", "us"},
                {"reduction", "us"},
                {"step", "us"},
                {"speed-up", "-"}};
    double one = 0;
    for (unsigned int n = 1; n <= largest_number; n *= 2)
      {
        std::uint64_t elements = 0, pieces = 0, neighbours = 0, bytes = 0;
        double        computing = 0, halo = 0;
        for (const RankShare &share : find_shares(model, n))
          {
            elements   = std::max(elements, share.n_elements());
            pieces     = std::max(pieces, share.in_pieces);
            neighbours = std::max(neighbours, share.n_neighbours);
            bytes      = std::max(bytes, share.bytes());
            // On one rank all copies share constants.
            computing =
              std::max(computing,
                       n == 1 ? core.shared * share.n_elements()
                              : core.shared * share.in_sectors + core.own * share.in_pieces);
            halo = std::max(halo, latency * share.n_neighbours + 1e-9 * share.bytes() / bandwidth);
          }
        // Motion to every other rank that works on the contact, and forces back; points among those
        // that share them.
        const unsigned int workers = std::min(n, ContactRanks::least_number);
        const double load = find_largest_load(deal_clusters(pairs_in_mesh, workers), pairs_in_mesh);
        const double contact =
          core.contact_all + core.contact_shared * load + 3 * (workers - 1) * latency;
        const double reduction = std::ceil(std::log2(n)) * latency;
        const double step      = computing + halo + contact + reduction;
        if (n == 1)
          one = step;
        table.add_row({n,
                       elements,
                       pieces,
                       neighbours,
                       1e-3 * bytes,
                       1e6 * computing,
                       1e6 * halo,
                       1e6 * contact,
                       1e6 * reduction,
                       1e6 * step,
                       one / step});
      }
    return table;
  }
} // namespace vfife
