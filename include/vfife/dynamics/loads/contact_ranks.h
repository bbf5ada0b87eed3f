// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_dynamics_loads_contact_ranks_h
#define vfife_dynamics_loads_contact_ranks_h

#include <cstdint>
#include <cstring>
#include <memory>
#include <type_traits>
#include <vector>

namespace vfife
{
  class Communicator;
  struct ContactOfPair;
  struct ContactSurface;
  struct Model;

  /**
   * The ranks that work on what may touch at the moment, and what they tell each other. All that
   * hold a node of it are among them; the others take no part until the next search. Messages go
   * from each of them to each other one, so their number follows from what touches and not from the
   * number of ranks.
   */
  class ContactRanks
  {
  public:
    using Pairs = std::vector<std::unique_ptr<ContactOfPair>>;

    /** A node of a surface. */
    struct Node
    {
      ContactSurface *surface;
      unsigned int    number; ///< of the surface
    };

    /** Up to so many ranks all take part, and never fewer than these. */
    static constexpr unsigned int least_number = 8;

    ContactRanks(const Model &model, const Pairs &pairs, const Communicator &communicator);

    /** Chooses them for the active nodes of the pairs, on all ranks alike; whether they are others
     * than before. */
    bool choose(const Pairs &pairs);

    /** Whether this rank is among them. */
    bool takes_part() const;

    /** The number of this rank among them, and how many they are. */
    unsigned int place() const;
    unsigned int number() const;

    /** Brings what the owners of the active nodes have in arrays of surfaces, three numbers a node,
     * to all that take part. For those alone, as all below. */
    void bring(const std::vector<std::vector<double> ContactSurface::*> &arrays);

    /** Sums up the forces at some nodes, the same on all that take part, in ascending order of
     * rank: all get the same to the last bit. */
    void add_up_forces(const std::vector<Node> &nodes);

    /** The active nodes, and those of them that this rank owns. */
    const std::vector<Node> &nodes() const;
    const std::vector<Node> &own_nodes() const;

    /** The records of all that take part, in the order of their places; lengths may differ. */
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
    /** The ranks whose elements touch each node of a surface, ascending: the first owns it. */
    struct Holders
    {
      std::vector<std::vector<std::uint32_t>> of_node;
    };

    std::vector<char> exchange_bytes(const void *data, std::size_t n_bytes) const;

    const Communicator              &communicator_;
    std::vector<Holders>             holders_; ///< of the slave and the master of each pair
    std::vector<std::uint32_t>       ranks_;   ///< ascending
    unsigned int                     place_ = 0;
    std::vector<Node>                nodes_;
    std::vector<std::vector<Node>>   owned_;   ///< active nodes by the place of their owner
    std::vector<std::vector<double>> buffers_; ///< by place
  };
} // namespace vfife

#endif
