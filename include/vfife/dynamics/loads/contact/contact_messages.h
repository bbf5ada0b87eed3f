// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_dynamics_loads_contact_contact_messages_h
#define vfife_dynamics_loads_contact_contact_messages_h

#include <vfife/dynamics/loads/contact/contact_nodes.h>

#include <cstring>
#include <map>
#include <type_traits>
#include <vector>

namespace vfife
{
  class Communicator;

  /**
   * What ranks tell each other of the nodes that may touch. The owner of a node tells those that
   * work on it where it is, these tell all that hold a copy what force it gets; nobody else hears
   * of it. So the number of messages follows from what touches and not from the number of ranks.
   */
  class ContactMessages
  {
  public:
    using Ranks = ContactNodes::Ranks;

    /** @p nodes must outlive the object. */
    ContactMessages(const ContactNodes &nodes, const Communicator &communicator);

    /** Sets the @p workers on each node that may touch, by surface and number of the node, and the
     * @p fellows that share points with this rank, itself among them. */
    void set_workers(const std::vector<std::map<unsigned int, const Ranks *>> &workers,
                     const Ranks                                              &fellows);

    /** The number of this rank among those that share their points with it. */
    unsigned int place() const
    {
      return place_;
    }
    bool shares_points() const
    {
      return fellows_.size() > 1;
    }

    /** The nodes that may touch and that this rank owns. */
    const std::vector<ContactNode> &own_nodes() const
    {
      return own_nodes_;
    }

    /** Brings what the owners of nodes have in arrays of surfaces, three numbers a node, to those
     * that work on them. */
    void bring(const std::vector<std::vector<double> ContactSurface::*> &arrays);

    /**
     * Hands the forces of surfaces at the nodes @p touched by this rank's points to all that hold
     * these nodes: all get the same sums to the last bit, added in ascending order of rank. Returns
     * the nodes of which this rank then has forces, each once.
     */
    std::vector<ContactNode> add_up_forces(const std::vector<ContactNode> &touched);

    /** The records of all that share points with this rank, by their places; lengths may differ. */
    template <typename Record>
    std::vector<Record> exchange(const std::vector<Record> &records) const
    {
      static_assert(std::is_trivially_copyable<Record>::value, "records are sent as bytes");
      const std::vector<char> bytes =
        exchange_bytes(records.data(), records.size() * sizeof(Record));
      std::vector<Record> all(bytes.size() / sizeof(Record));
      if (!all.empty()) // memcpy must not be given what empty vectors have
        std::memcpy(all.data(), bytes.data(), bytes.size());
      return all;
    }

  private:
    /** A message: to or from whom, of what. */
    struct Motion
    {
      std::uint32_t            rank;
      std::vector<ContactNode> nodes;
      std::vector<double>      buffer;
    };
    struct NodeForce
    {
      std::uint32_t surface, node;
      double        force[3];
    };

    std::vector<char> exchange_bytes(const void *data, std::size_t n_bytes) const;

    const ContactNodes      &nodes_;
    const Communicator      &communicator_;
    Ranks                    fellows_; ///< that share points, this rank among them
    unsigned int             place_ = 0;
    std::vector<ContactNode> own_nodes_;
    std::vector<Motion>      sent_, received_;
    Ranks                    targets_, sources_; ///< of forces
  };
} // namespace vfife

#endif
