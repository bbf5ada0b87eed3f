// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/process/communicator.h>
#include <vfife/dynamics/operator/halo_exchange.h>
#include <vfife/model/model.h>

#include <map>
#include <set>

namespace vfife
{
  namespace
  {
    constexpr int halo_tag = 0;
  }

  HaloExchange::HaloExchange(const Model                      &model,
                             const Partition                  &partition,
                             const std::vector<std::uint32_t> &rank_of_element,
                             const Communicator               &communicator)
    : communicator_(communicator)
    , rank_(communicator.rank())
  {
    // 1. Nodes that this rank holds and elements of other ranks touch: in the order of their global
    // numbers, which both sides know.
    std::map<unsigned int, std::set<std::uint32_t>> global_nodes;
    std::set<std::uint32_t>                         shared;
    for (const Body &body : model.bodies)
      for (std::uint32_t e = 0; e < body.n_elements(); ++e)
        {
          const unsigned int owner = rank_of_element[body.first_element + e];
          if (owner == rank_)
            continue;
          for (const std::uint32_t node : body.elements()[e])
            {
              const std::uint32_t global = body.first_node + node;
              if (partition.local_node[global] != Partition::absent)
                {
                  global_nodes[owner].insert(global);
                  shared.insert(partition.local_node[global]);
                }
            }
        }

    // 2. Room for what is sent to and received from each neighbour, ranks ascending.
    for (const auto &[rank, nodes] : global_nodes)
      {
        Neighbour neighbour{rank, {}, {}, {}};
        for (const std::uint32_t global : nodes)
          neighbour.nodes.push_back(partition.local_node[global]);
        neighbour.sent.resize(3 * nodes.size());
        neighbour.received.resize(3 * nodes.size());
        neighbours_.push_back(std::move(neighbour));
      }
    shared_.assign(shared.begin(), shared.end());
    own_.resize(3 * shared_.size());
    requests_.resize(2 * neighbours_.size());
  }

  void HaloExchange::add_over_ranks(NodeField &values)
  {
    start(values);
    finish(values);
  }

  void HaloExchange::start(NodeField &values)
  {
    // This rank's parts go to all neighbours of a node ...
    for (std::size_t i = 0; i < neighbours_.size(); ++i)
      {
        Neighbour &n = neighbours_[i];
        for (std::size_t k = 0; k < n.nodes.size(); ++k)
          Eigen::Map<Vector3>(n.sent.data() + 3 * k) = values.value(n.nodes[k]);
        requests_[2 * i]     = communicator_.start_receiving(n.received.data(),
                                                         n.received.size() * sizeof(double),
                                                         n.rank,
                                                         halo_tag);
        requests_[2 * i + 1] = communicator_.start_sending(n.sent.data(),
                                                           n.sent.size() * sizeof(double),
                                                           n.rank,
                                                           halo_tag);
      }

    // ... and are put aside: the sum begins at zero with the lowest rank's part.
    for (std::size_t k = 0; k < shared_.size(); ++k)
      {
        Eigen::Map<Vector3>(own_.data() + 3 * k) = values.value(shared_[k]);
        values.set(shared_[k], Vector3::Zero());
      }
  }

  void HaloExchange::finish(NodeField &values)
  {
    // Sums of floating point numbers depend on their order. Copies of a node whose forces differed
    // in the last digit would drift apart, as positions are never sent.
    Communicator::wait(requests_);

    // Parts in ascending order of rank, this rank's own among them: the same additions on all
    // ranks.
    const auto add_own = [&] {
      for (std::size_t k = 0; k < shared_.size(); ++k)
        values.add(shared_[k], Eigen::Map<const Vector3>(own_.data() + 3 * k));
    };
    bool own_is_added = false;
    for (const Neighbour &n : neighbours_)
      {
        if (!own_is_added && n.rank > rank_)
          {
            add_own();
            own_is_added = true;
          }
        for (std::size_t k = 0; k < n.nodes.size(); ++k)
          values.add(n.nodes[k], Eigen::Map<const Vector3>(n.received.data() + 3 * k));
      }
    if (!own_is_added)
      add_own();
  }
} // namespace vfife
