// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/process/communicator.h>
#include <vfife/dynamics/loads/contact/contact_messages.h>
#include <vfife/dynamics/loads/contact/contact_of_pair.h>

#include <algorithm>
#include <set>

namespace vfife
{
  namespace
  {
    /** The halo has 0. */
    constexpr int motion_tag = 1, points_tag = 2, forces_tag = 3;

    constexpr std::size_t width = 3; // numbers a node
  }                                  // namespace

  ContactMessages::ContactMessages(const ContactNodes &nodes, const Communicator &communicator)
    : nodes_(nodes)
    , communicator_(communicator)
  {
  }

  void
  ContactMessages::set_workers(const std::vector<std::map<unsigned int, const Ranks *>> &workers_of,
                               const Ranks                                              &fellows)
  {
    // The nodes surface by surface, each once, so that all ranks have one order.
    const std::uint32_t me = communicator_.rank();
    fellows_               = fellows;
    place_                 = std::find(fellows.begin(), fellows.end(), me) - fellows.begin();
    own_nodes_.clear();
    std::map<std::uint32_t, std::vector<ContactNode>> to, from;
    std::set<std::uint32_t>                           targets, sources;
    for (std::size_t s = 0; s < workers_of.size(); ++s)
      for (const auto &[number, workers_of_node] : workers_of[s])
        {
          const ContactNode node{nodes_.surfaces[s], number};
          if (communicator_.size() == 1)
            {
              own_nodes_.push_back(node);
              continue;
            }
          const Ranks        &workers = *workers_of_node, &holders = nodes_.holders[s][number];
          const std::uint32_t owner = holders.front();
          const bool          works = std::binary_search(workers.begin(), workers.end(), me);
          if (owner == me)
            {
              own_nodes_.push_back(node);
              for (const std::uint32_t worker : workers)
                if (worker != me)
                  to[worker].push_back(node);
            }
          else if (works)
            from[owner].push_back(node);
          if (works)
            targets.insert(holders.begin(), holders.end());
          if (std::binary_search(holders.begin(), holders.end(), me))
            sources.insert(workers.begin(), workers.end());
        }
    targets.erase(me);
    sources.erase(me);
    targets_.assign(targets.begin(), targets.end());
    sources_.assign(sources.begin(), sources.end());
    const auto make_messages = [](std::map<std::uint32_t, std::vector<ContactNode>> &lists) {
      std::vector<Motion> messages;
      for (auto &list : lists)
        messages.push_back({list.first, std::move(list.second), {}});
      return messages;
    };
    sent_     = make_messages(to);
    received_ = make_messages(from);
  }

  void ContactMessages::bring(const std::vector<std::vector<double> ContactSurface::*> &arrays)
  {
    // One array after the other, of the same nodes in the same order on both sides.
    const auto visit = [&](const std::vector<ContactNode> &nodes, const auto &at_node) {
      for (const auto array : arrays)
        for (const ContactNode &node : nodes)
          at_node((node.surface->*array).data() + width * node.number);
    };
    std::vector<MPI_Request> requests;
    for (Motion &message : received_)
      {
        message.buffer.resize(arrays.size() * width * message.nodes.size());
        requests.push_back(communicator_.start_receiving(
          message.buffer.data(), message.buffer.size() * sizeof(double), message.rank, motion_tag));
      }
    for (Motion &message : sent_)
      {
        message.buffer.resize(arrays.size() * width * message.nodes.size());
        double *to = message.buffer.data();
        visit(message.nodes, [&to](const double *values) { to = std::copy_n(values, width, to); });
        requests.push_back(communicator_.start_sending(
          message.buffer.data(), message.buffer.size() * sizeof(double), message.rank, motion_tag));
      }
    Communicator::wait(requests);
    for (const Motion &message : received_)
      {
        const double *from = message.buffer.data();
        visit(message.nodes, [&from](double *values) {
          std::copy_n(from, width, values);
          from += width;
        });
      }
  }

  std::vector<ContactNode> ContactMessages::add_up_forces(const std::vector<ContactNode> &touched)
  {
    if (targets_.empty() && sources_.empty())
      return touched;
    // 1. This rank's forces, put aside: a sum begins at zero with the lowest rank's part.
    std::vector<NodeForce> own;
    for (const ContactNode &node : touched)
      {
        const auto surface =
          std::find(nodes_.surfaces.begin(), nodes_.surfaces.end(), node.surface);
        NodeForce record{static_cast<std::uint32_t>(surface - nodes_.surfaces.begin()),
                         node.number,
                         {}};
        double   *force = node.surface->forces.data() + width * node.number;
        std::copy_n(force, width, record.force);
        std::fill_n(force, width, 0.);
        own.push_back(record);
      }
    // 2. To all that hold such nodes what is theirs, though it be nothing: they wait for it.
    std::vector<MPI_Request>            requests;
    std::vector<std::vector<NodeForce>> outgoing(targets_.size());
    for (std::size_t k = 0; k < targets_.size(); ++k)
      {
        for (const NodeForce &record : own)
          {
            const Ranks &holders = nodes_.holders[record.surface][record.node];
            if (std::binary_search(holders.begin(), holders.end(), targets_[k]))
              outgoing[k].push_back(record);
          }
        requests.push_back(communicator_.start_sending(
          outgoing[k].data(), outgoing[k].size() * sizeof(NodeForce), targets_[k], forces_tag));
      }
    // 3. All parts in ascending order of rank, this rank's among them.
    std::vector<ContactNode> nodes;
    const auto               add = [&](const NodeForce &record) {
      ContactSurface *surface = nodes_.surfaces[record.surface];
      for (std::size_t c = 0; c < width; ++c)
        surface->forces[width * record.node + c] += record.force[c];
      if (surface->touched[record.node] == 0)
        {
          surface->touched[record.node] = 1;
          nodes.push_back({surface, record.node});
        }
    };
    const auto add_own = [&] {
      for (const NodeForce &record : own)
        add(record);
    };
    bool own_is_added = false;
    for (const std::uint32_t source : sources_)
      {
        if (!own_is_added && source > communicator_.rank())
          {
            add_own();
            own_is_added = true;
          }
        const std::vector<char> bytes = communicator_.receive(source, forces_tag);
        std::vector<NodeForce>  records(bytes.size() / sizeof(NodeForce));
        if (!records.empty())
          std::memcpy(records.data(), bytes.data(), bytes.size());
        for (const NodeForce &record : records)
          add(record);
      }
    if (!own_is_added)
      add_own();
    Communicator::wait(requests);
    for (const ContactNode &node : nodes)
      node.surface->touched[node.number] = 0;
    return nodes;
  }

  std::vector<char> ContactMessages::exchange_bytes(const void       *data,
                                                    const std::size_t n_bytes) const
  {
    std::vector<MPI_Request> requests;
    for (std::size_t k = 0; k < fellows_.size(); ++k)
      if (k != place_)
        requests.push_back(communicator_.start_sending(data, n_bytes, fellows_[k], points_tag));
    std::vector<char> all;
    for (std::size_t k = 0; k < fellows_.size(); ++k)
      if (k == place_)
        all.insert(all.end(),
                   static_cast<const char *>(data),
                   static_cast<const char *>(data) + n_bytes);
      else
        {
          const std::vector<char> bytes = communicator_.receive(fellows_[k], points_tag);
          all.insert(all.end(), bytes.begin(), bytes.end());
        }
    Communicator::wait(requests);
    return all;
  }
} // namespace vfife
