// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_dynamics_loads_contact_contact_ranks_h
#define vfife_dynamics_loads_contact_contact_ranks_h

#include <vfife/contact/pass/point_list.h>
#include <vfife/dynamics/loads/contact/contact_messages.h>
#include <vfife/dynamics/loads/contact/contact_nodes.h>

#include <map>
#include <vector>

namespace vfife
{
  class ByteStream;
  class Communicator;
  struct ContactPart;

  /**
   * Who works on what may touch at the moment. Pairs of groups (teeth) that have nodes in common
   * form a cluster; clusters do not see each other. They are dealt to ranks by the work that they
   * have been (deal_clusters): a rank has some of them to itself, or shares the points of its only
   * part with others. ContactMessages are between ranks that work and ranks that hold nodes.
   */
  class ContactRanks
  {
  public:
    /** Up to so many ranks all may be given work, and never fewer than these. */
    static constexpr unsigned int least_number = 8;

    ContactRanks(const Model &model, const ContactPairs &pairs, const Communicator &communicator);

    /** Deals the candidates of all pairs, on all ranks alike; whether shares have changed since the
     * last call. What stays with its ranks keeps its lists as long as these have not much more to
     * do than they might. Collective. */
    bool choose(const ContactPairs &pairs);

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

    /** The surfaces' nodes of all pairs. */
    const ContactNodes &nodes() const
    {
      return nodes_;
    }

    /** Between the ranks that work and those that hold nodes. */
    ContactMessages &messages()
    {
      return messages_;
    }
    const ContactMessages &messages() const
    {
      return messages_;
    }

    /** For checkpoints: who works on what. */
    void serialize(const ContactPairs &pairs, ByteStream &stream);

  private:
    using Ranks = ContactNodes::Ranks;

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

    const std::vector<unsigned int> &nodes_of(const Entry &entry, unsigned int side) const;
    /** Whether there are other candidates than before. */
    bool find_clusters(const ContactPairs &pairs);
    /** Of each cluster. */
    std::vector<double> find_work(const ContactPairs &pairs) const;
    void                find_candidates();
    /** The ranks that have had the clusters, for those that are new whoever has least; nothing
     * where that is not possible. */
    std::vector<Ranks> keep(const std::vector<double> &work) const;
    /** Ranks for the clusters of the parts. */
    std::vector<Ranks> give(std::vector<ContactPart> parts, const std::vector<double> &work) const;
    Ranks              former_ranks(unsigned int cluster) const;
    static double find_load(const std::vector<Ranks> &of_clusters, const std::vector<double> &work);
    /** Shares and messages, from the ranks of each cluster. */
    bool set_ranks(std::vector<Ranks> of_clusters);
    /** Of each surface's nodes that may touch. */
    std::vector<std::map<unsigned int, const Ranks *>> find_workers() const;

    const Communicator &communicator_;
    ContactNodes        nodes_;
    ContactMessages     messages_;

    std::vector<Entry>                   entries_;     ///< pair by pair
    std::vector<unsigned int>            first_entry_; ///< of each pair
    std::vector<unsigned int>            clusters_;    ///< of each entry
    unsigned int                         n_clusters_ = 0;
    Ranks                                candidates_;  ///< that may be given work
    std::vector<Ranks>                   of_clusters_; ///< that work on each
    std::map<Entry, Ranks>               ranks_of_;    ///< of the last choice
    std::vector<std::vector<PointShare>> shares_;
  };
} // namespace vfife

#endif
