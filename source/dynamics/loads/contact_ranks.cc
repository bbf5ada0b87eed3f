// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/process/communicator.h>
#include <vfife/dynamics/loads/contact_of_pair.h>
#include <vfife/dynamics/loads/contact_ranks.h>
#include <vfife/dynamics/operator/pack_layout.h>

#include <algorithm>

namespace vfife
{
  namespace
  {
    /** The halo has 0. */
    constexpr int motion_tag = 1, points_tag = 2, forces_tag = 3;

    constexpr std::size_t width = 3; // numbers a node
  }                                  // namespace

  ContactRanks::ContactRanks(const Model        &model,
                             const Pairs        &pairs,
                             const Communicator &communicator)
    : communicator_(communicator)
  {
    if (communicator.size() == 1)
      return;
    const std::vector<std::uint32_t> rank_of_element = assign_elements(model, communicator.size());
    for (const auto &pair : pairs)
      for (const ContactSurface *surface : pair->surfaces())
        {
          // Nodes of the body by their number in the surface.
          const Body                &body = model.bodies[surface->body];
          std::vector<std::uint32_t> number(body.n_nodes(), Partition::absent);
          for (std::size_t i = 0; i < surface->facets->nodes.size(); ++i)
            number[surface->facets->nodes[i]] = i;
          Holders holders{std::vector<std::vector<std::uint32_t>>(surface->facets->nodes.size())};
          for (std::uint32_t e = 0; e < body.n_elements(); ++e)
            for (const std::uint32_t node : body.elements()[e])
              if (number[node] != Partition::absent)
                {
                  auto      &ranks = holders.of_node[number[node]];
                  const auto rank  = rank_of_element[body.first_element + e];
                  const auto place = std::lower_bound(ranks.begin(), ranks.end(), rank);
                  if (place == ranks.end() || *place != rank)
                    ranks.insert(place, rank);
                }
          holders_.push_back(std::move(holders));
        }
  }

  bool ContactRanks::choose(const Pairs &pairs)
  {
    nodes_.clear();
    for (const auto &pair : pairs)
      for (ContactSurface *const surface : pair->surfaces())
        for (const unsigned int i : *surface->active)
          nodes_.push_back({surface, i});
    if (communicator_.size() == 1)
      return false;
    // 1. Who holds an active node; then the lowest ranks, until there are enough.
    std::vector<std::uint8_t>  chosen(communicator_.size(), 0);
    std::vector<std::uint32_t> owners;
    for (std::size_t p = 0; p < pairs.size(); ++p)
      for (unsigned int side = 0; side < 2; ++side)
        {
          for (const unsigned int i : *pairs[p]->surfaces()[side]->active)
            {
              const auto &holders = holders_[2 * p + side].of_node[i];
              for (const std::uint32_t rank : holders)
                chosen[rank] = 1;
              owners.push_back(holders.front());
            }
        }
    std::size_t n = std::count(chosen.begin(), chosen.end(), 1);
    for (std::size_t rank = 0; rank < chosen.size() && n < least_number; ++rank)
      if (chosen[rank] == 0)
        {
          chosen[rank] = 1;
          ++n;
        }

    // 2. Their places, and whose nodes come from whom.
    std::vector<std::uint32_t> ranks, place_of(chosen.size(), Partition::absent);
    for (std::uint32_t rank = 0; rank < chosen.size(); ++rank)
      if (chosen[rank] == 1)
        {
          place_of[rank] = ranks.size();
          ranks.push_back(rank);
        }
    place_ = place_of[communicator_.rank()];
    owned_.assign(ranks.size(), {});
    for (std::size_t i = 0; i < nodes_.size(); ++i)
      owned_[place_of[owners[i]]].push_back(nodes_[i]);
    buffers_.resize(ranks.size());
    const bool changes = ranks != ranks_;
    ranks_             = std::move(ranks);
    return changes;
  }

  bool ContactRanks::takes_part() const
  {
    return place_ != Partition::absent;
  }

  unsigned int ContactRanks::place() const
  {
    return place_;
  }

  unsigned int ContactRanks::number() const
  {
    return communicator_.size() == 1 ? 1 : ranks_.size();
  }

  const std::vector<ContactRanks::Node> &ContactRanks::nodes() const
  {
    return nodes_;
  }

  const std::vector<ContactRanks::Node> &ContactRanks::own_nodes() const
  {
    return communicator_.size() == 1 ? nodes_ : owned_[place_];
  }

  void ContactRanks::bring(const std::vector<std::vector<double> ContactSurface::*> &arrays)
  {
    // One array after the other, of the same nodes in the same order on both sides.
    const auto visit = [&](const std::vector<Node> &nodes, const auto &at_node) {
      for (const auto array : arrays)
        for (const Node &node : nodes)
          at_node((node.surface->*array).data() + width * node.number);
    };
    std::vector<MPI_Request> requests;
    for (std::size_t k = 0; k < ranks_.size(); ++k)
      {
        buffers_[k].resize(arrays.size() * width * owned_[k].size());
        if (k != place_ && !owned_[k].empty())
          requests.push_back(communicator_.start_receiving(
            buffers_[k].data(), buffers_[k].size() * sizeof(double), ranks_[k], motion_tag));
      }
    double *to = buffers_.empty() ? nullptr : buffers_[place_].data();
    if (ranks_.size() > 1)
      visit(owned_[place_], [&to](const double *values) { to = std::copy_n(values, width, to); });
    for (std::size_t k = 0; k < ranks_.size(); ++k)
      if (k != place_ && !owned_[place_].empty())
        requests.push_back(communicator_.start_sending(buffers_[place_].data(),
                                                       buffers_[place_].size() * sizeof(double),
                                                       ranks_[k],
                                                       motion_tag));
    Communicator::wait(requests);
    for (std::size_t k = 0; k < ranks_.size(); ++k)
      if (k != place_)
        {
          const double *from = buffers_[k].data();
          visit(owned_[k], [&from](double *values) {
            std::copy_n(from, width, values);
            from += width;
          });
        }
  }

  void ContactRanks::add_up_forces(const std::vector<Node> &nodes)
  {
    if (ranks_.size() < 2)
      return;
    const std::size_t        n = width * nodes.size();
    std::vector<MPI_Request> requests;
    for (std::size_t k = 0; k < ranks_.size(); ++k)
      {
        buffers_[k].resize(n);
        if (k != place_)
          requests.push_back(communicator_.start_receiving(
            buffers_[k].data(), n * sizeof(double), ranks_[k], forces_tag));
      }
    double *to = buffers_[place_].data();
    for (const Node &node : nodes)
      to = std::copy_n(node.surface->forces.data() + width * node.number, width, to);
    for (std::size_t k = 0; k < ranks_.size(); ++k)
      if (k != place_)
        requests.push_back(communicator_.start_sending(
          buffers_[place_].data(), n * sizeof(double), ranks_[k], forces_tag));
    Communicator::wait(requests);
    for (std::size_t i = 0; i < nodes.size(); ++i)
      for (std::size_t c = 0; c < width; ++c)
        {
          double sum = buffers_[0][width * i + c];
          for (std::size_t k = 1; k < ranks_.size(); ++k)
            sum += buffers_[k][width * i + c];
          nodes[i].surface->forces[width * nodes[i].number + c] = sum;
        }
  }

  std::vector<char> ContactRanks::exchange_bytes(const void *data, const std::size_t n_bytes) const
  {
    std::vector<MPI_Request> requests;
    for (std::size_t k = 0; k < ranks_.size(); ++k)
      if (k != place_)
        requests.push_back(communicator_.start_sending(data, n_bytes, ranks_[k], points_tag));
    std::vector<char> all;
    for (std::size_t k = 0; k < ranks_.size(); ++k)
      if (k == place_)
        all.insert(all.end(),
                   static_cast<const char *>(data),
                   static_cast<const char *>(data) + n_bytes);
      else
        {
          const std::vector<char> bytes = communicator_.receive(ranks_[k], points_tag);
          all.insert(all.end(), bytes.begin(), bytes.end());
        }
    Communicator::wait(requests);
    return all;
  }
} // namespace vfife
