// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_dynamics_loads_contact_contact_ranks_h
#define vfife_dynamics_loads_contact_contact_ranks_h

#include <vfife/contact/point_share.h>

#include <cstdint>
#include <cstring>
#include <map>
#include <memory>
#include <type_traits>
#include <vector>

namespace vfife
{
  class ByteStream;
  class Communicator;
  struct ContactOfPair;
  struct ContactPart;
  struct ContactSurface;
  struct Model;

  /**
   * Who works on what may touch at the moment, and what ranks tell each other.
   *
   * Pairs of groups (teeth) that have nodes in common form a cluster; clusters do not see each
   * other. They are dealt to ranks by the work that they have been (deal_clusters): a rank has
   * some of them to itself, or shares the points of its only part with others. The owner of a node
   * tells those that work on its cluster where it is, these tell all that hold a copy what force it
   * gets; nobody else hears of it. So the number of messages follows from what touches and not from
   * the number of ranks.
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

    /** Up to so many ranks all may be given work, and never fewer than these. */
    static constexpr unsigned int least_number = 8;

    ContactRanks(const Model &model, const Pairs &pairs, const Communicator &communicator);

    /** Deals the candidates of all pairs, on all ranks alike; whether shares have changed since the
     * last call. What stays with its ranks keeps its lists as long as these have not much more to
     * do than they might. Collective. */
    bool choose(const Pairs &pairs);

    /** This rank's share of each candidate of a pair. */
    const std::vector<PointShare> &shares(const unsigned int pair) const
    {
      return shares_[pair];
    }

    /** The cluster of a candidate of a pair. */
    unsigned int cluster(const unsigned int pair, const unsigned int candidate) const
    {
      return clusters_[first_entry_[pair] + candidate];
    }

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
    const std::vector<Node> &own_nodes() const
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
    std::vector<Node> add_up_forces(const std::vector<Node> &touched);

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

    /** For checkpoints: who works on what. */
    void serialize(const Pairs &pairs, ByteStream &stream);

  private:
    using Ranks = std::vector<std::uint32_t>; ///< ascending

    /** A candidate of a pair. */
    struct Entry
    {
      unsigned int pair, slave_group, master_group;

      bool operator<(const Entry &other) const;
      bool operator==(const Entry &other) const
      {
        return !(*this < other) && !(other < *this);
      }
    };
    /** A message: to or from whom, of what. */
    struct Motion
    {
      std::uint32_t       rank;
      std::vector<Node>   nodes;
      std::vector<double> buffer;
    };
    struct NodeForce
    {
      std::uint32_t surface, node;
      double        force[3];
    };

    const std::vector<unsigned int> &nodes_of(const Entry &entry, unsigned int side) const;
    /** Whether there are other candidates than before. */
    bool find_clusters(const Pairs &pairs);
    /** Of each cluster. */
    std::vector<double> find_work(const Pairs &pairs) const;
    void                find_candidates();
    /** The ranks that have had the clusters, for those that are new whoever has least; nothing
     * where that is not possible. */
    std::vector<Ranks> keep(const std::vector<double> &work) const;
    /** Ranks for the clusters of the parts. */
    std::vector<Ranks> give(std::vector<ContactPart> parts, const std::vector<double> &work) const;
    Ranks              former_ranks(unsigned int cluster) const;
    static double find_load(const std::vector<Ranks> &of_clusters, const std::vector<double> &work);
    /** Shares and messages, from the ranks of each cluster. */
    bool              set_ranks(std::vector<Ranks> of_clusters);
    void              find_messages();
    std::vector<char> exchange_bytes(const void *data, std::size_t n_bytes) const;

    const Communicator &communicator_;
    /** Of the slave and the master of each pair: itself, nodes of each group, and of each node the
     * ranks whose elements touch it, the first of which owns it. */
    std::vector<ContactSurface *>                       surfaces_;
    std::vector<std::vector<std::vector<unsigned int>>> group_nodes_;
    std::vector<std::vector<Ranks>>                     holders_;

    std::vector<Entry>                   entries_;     ///< pair by pair
    std::vector<unsigned int>            first_entry_; ///< of each pair
    std::vector<unsigned int>            clusters_;    ///< of each entry
    unsigned int                         n_clusters_ = 0;
    Ranks                                candidates_;  ///< that may be given work
    std::vector<Ranks>                   of_clusters_; ///< that work on each
    std::map<Entry, Ranks>               ranks_of_;    ///< of the last choice
    std::vector<std::vector<PointShare>> shares_;
    Ranks                                fellows_; ///< that share points, this rank among them
    unsigned int                         place_ = 0;
    std::vector<Node>                    own_nodes_;
    std::vector<Motion>                  sent_, received_;
    Ranks                                targets_, sources_; ///< of forces
  };
} // namespace vfife

#endif
