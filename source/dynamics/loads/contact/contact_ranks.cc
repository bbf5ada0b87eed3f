// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/process/communicator.h>
#include <vfife/base/text/byte_stream.h>
#include <vfife/dynamics/loads/contact/contact_dealing.h>
#include <vfife/dynamics/loads/contact/contact_of_pair.h>
#include <vfife/dynamics/loads/contact/contact_ranks.h>

#include <algorithm>
#include <numeric>
#include <set>
#include <tuple>

namespace vfife
{
  namespace
  {
    /** How much more than in a new deal the busiest rank may have to do before clusters change
     * hands: each then has to list its points anew. */
    constexpr double patience = 1.25;

    /** What following a node costs between two searches, in the cost of finding where a point lies:
     * some 40 steps, each with a sixteenth of it. */
    constexpr double work_of_node = 2.5;

    /** Representative of a set, whose path to it is halved on the way. */
    unsigned int find_root(std::vector<unsigned int> &parents, unsigned int i)
    {
      while (parents[i] != i)
        i = parents[i] = parents[parents[i]];
      return i;
    }
  } // namespace

  bool ContactRanks::Entry::operator<(const Entry &other) const
  {
    return std::tie(pair, slave_group, master_group) <
           std::tie(other.pair, other.slave_group, other.master_group);
  }

  ContactRanks::ContactRanks(const Model        &model,
                             const ContactPairs &pairs,
                             const Communicator &communicator)
    : communicator_(communicator)
    , nodes_(model, pairs, communicator.size())
    , messages_(nodes_, communicator)
  {
  }

  const std::vector<unsigned int> &ContactRanks::nodes_of(const Entry       &entry,
                                                          const unsigned int side) const
  {
    return nodes_
      .of_groups[2 * entry.pair + side][side == 0 ? entry.slave_group : entry.master_group];
  }

  bool ContactRanks::choose(const ContactPairs &pairs)
  {
    const bool others = find_clusters(pairs);
    if (communicator_.size() == 1)
      {
        // All is this rank's, and remains so.
        if (others)
          set_ranks(std::vector<Ranks>(n_clusters_, Ranks(1, 0)));
        return false;
      }
    const std::vector<double>      work  = find_work(pairs);
    const std::vector<ContactPart> parts = deal_clusters(work, candidates_.size());
    std::vector<Ranks>             ranks = others ? keep(work) : of_clusters_;
    if (ranks.size() != n_clusters_ ||
        find_load(ranks, work) > patience * find_largest_load(parts, work))
      ranks = give(parts, work);
    return (others || ranks != of_clusters_) && set_ranks(ranks);
  }

  bool ContactRanks::find_clusters(const ContactPairs &pairs)
  {
    std::vector<Entry>        entries;
    std::vector<unsigned int> first_entry;
    for (unsigned int p = 0; p < pairs.size(); ++p)
      {
        first_entry.push_back(entries.size());
        for (const auto &groups : pairs[p]->contact.candidate_pairs())
          entries.push_back({p, groups.first, groups.second});
      }
    if (entries == entries_ && !first_entry_.empty())
      return false;
    entries_     = std::move(entries);
    first_entry_ = std::move(first_entry);
    // Candidates that have a node in common are one cluster.
    std::vector<unsigned int> parents(entries_.size());
    std::iota(parents.begin(), parents.end(), 0u);
    std::map<unsigned int, unsigned int> entry_of_node;
    for (unsigned int e = 0; e < entries_.size(); ++e)
      for (unsigned int side = 0; side < 2; ++side)
        for (const unsigned int i : nodes_of(entries_[e], side))
          {
            const unsigned int number = nodes_.surfaces[2 * entries_[e].pair + side]->numbers[i];
            const unsigned int other  = entry_of_node.emplace(number, e).first->second;
            parents[find_root(parents, e)] = find_root(parents, other);
          }
    // Numbered as they come.
    n_clusters_ = 0;
    clusters_.assign(entries_.size(), 0);
    std::map<unsigned int, unsigned int> number_of_root;
    for (unsigned int e = 0; e < entries_.size(); ++e)
      {
        const auto found = number_of_root.emplace(find_root(parents, e), n_clusters_);
        n_clusters_ += found.second ? 1 : 0;
        clusters_[e] = found.first->second;
      }
    find_candidates();
    return true;
  }

  std::vector<double> ContactRanks::find_work(const ContactPairs &pairs) const
  {
    std::vector<double> of_entries;
    for (const auto &pair : pairs)
      {
        const std::vector<double> of_pair = pair->contact.take_work();
        of_entries.insert(of_entries.end(), of_pair.begin(), of_pair.end());
      }
    communicator_.sum(of_entries);
    std::vector<double> work(n_clusters_, 0.);
    for (std::size_t e = 0; e < entries_.size(); ++e)
      work[clusters_[e]] += of_entries[e] + work_of_node * (nodes_of(entries_[e], 0).size() +
                                                            nodes_of(entries_[e], 1).size());
    return work;
  }

  void ContactRanks::find_candidates()
  {
    if (communicator_.size() == 1)
      return;
    // Who holds a node; then the lowest ranks, until there are enough.
    std::set<std::uint32_t> ranks;
    for (const Entry &entry : entries_)
      for (unsigned int side = 0; side < 2; ++side)
        for (const unsigned int i : nodes_of(entry, side))
          {
            const Ranks &holders = nodes_.holders[2 * entry.pair + side][i];
            ranks.insert(holders.begin(), holders.end());
          }
    for (std::uint32_t rank = 0; rank < communicator_.size() && ranks.size() < least_number; ++rank)
      ranks.insert(rank);
    candidates_.assign(ranks.begin(), ranks.end());
  }

  double ContactRanks::find_load(const std::vector<Ranks>  &of_clusters,
                                 const std::vector<double> &work)
  {
    std::map<Ranks, ContactPart> parts;
    for (unsigned int c = 0; c < of_clusters.size(); ++c)
      {
        parts[of_clusters[c]].clusters.push_back(c);
        parts[of_clusters[c]].n_ranks = of_clusters[c].size();
      }
    double largest = 0.;
    for (const auto &part : parts)
      largest = std::max(largest, part.second.load(work));
    return largest;
  }

  ContactRanks::Ranks ContactRanks::former_ranks(const unsigned int cluster) const
  {
    // Of the first of its candidates that is not new.
    for (std::size_t e = 0; e < entries_.size(); ++e)
      if (clusters_[e] == cluster)
        {
          const auto found = ranks_of_.find(entries_[e]);
          if (found != ranks_of_.end())
            return found->second;
        }
    return {};
  }

  std::vector<ContactRanks::Ranks> ContactRanks::keep(const std::vector<double> &work) const
  {
    std::vector<Ranks>              of_clusters(n_clusters_);
    std::map<std::uint32_t, double> loads;
    for (const std::uint32_t rank : candidates_)
      loads[rank] = 0.;
    std::set<std::uint32_t> taken; // share points: nothing else for them
    for (unsigned int c = 0; c < n_clusters_; ++c)
      {
        of_clusters[c] = former_ranks(c);
        for (const std::uint32_t rank : of_clusters[c])
          {
            if (loads.count(rank) == 0)
              return {};
            loads[rank] += work[c];
            if (of_clusters[c].size() > 1)
              taken.insert(rank);
          }
      }
    for (unsigned int c = 0; c < n_clusters_; ++c)
      if (of_clusters[c].empty())
        {
          const std::uint32_t *least = nullptr;
          for (const std::uint32_t &rank : candidates_)
            if (taken.count(rank) == 0 && (least == nullptr || loads[rank] < loads[*least]))
              least = &rank;
          if (least == nullptr)
            return {};
          of_clusters[c] = Ranks(1, *least);
          loads[*least] += work[c];
        }
    return of_clusters;
  }

  std::vector<ContactRanks::Ranks> ContactRanks::give(std::vector<ContactPart>   parts,
                                                      const std::vector<double> &work) const
  {
    std::stable_sort(parts.begin(), parts.end(), [&](const ContactPart &a, const ContactPart &b) {
      return a.load(work) > b.load(work);
    });
    // Who has worked on a part, and who owns its nodes, gets it.
    std::vector<Ranks>      of_clusters(n_clusters_);
    std::set<std::uint32_t> left(candidates_.begin(), candidates_.end());
    for (const ContactPart &part : parts)
      {
        std::map<std::uint32_t, std::pair<double, std::size_t>> merits;
        for (const std::uint32_t rank : left)
          merits[rank] = {0., 0};
        for (const unsigned int c : part.clusters)
          {
            for (const std::uint32_t rank : former_ranks(c))
              if (left.count(rank) == 1)
                merits[rank].first += work[c];
            for (std::size_t e = 0; e < entries_.size(); ++e)
              if (clusters_[e] == c)
                for (unsigned int side = 0; side < 2; ++side)
                  for (const unsigned int i : nodes_of(entries_[e], side))
                    {
                      const auto owner = nodes_.holders[2 * entries_[e].pair + side][i].front();
                      if (left.count(owner) == 1)
                        ++merits[owner].second;
                    }
          }
        Ranks by_merit(left.begin(), left.end());
        std::stable_sort(by_merit.begin(), by_merit.end(), [&merits](const auto a, const auto b) {
          return merits[a] > merits[b];
        });
        by_merit.resize(part.n_ranks);
        std::sort(by_merit.begin(), by_merit.end());
        for (const unsigned int c : part.clusters)
          of_clusters[c] = by_merit;
        for (const std::uint32_t rank : by_merit)
          left.erase(rank);
      }
    return of_clusters;
  }

  bool ContactRanks::set_ranks(std::vector<Ranks> of_clusters)
  {
    of_clusters_ = std::move(of_clusters);
    std::map<Entry, Ranks> ranks_of;
    for (std::size_t e = 0; e < entries_.size(); ++e)
      ranks_of[entries_[e]] = of_clusters_[clusters_[e]];
    // Of a candidate that is new or gone nobody has a list.
    bool changes = false;
    for (const auto &entry : ranks_of)
      {
        const auto found = ranks_of_.find(entry.first);
        changes          = changes || found == ranks_of_.end() || found->second != entry.second;
      }
    ranks_of_ = std::move(ranks_of);

    const std::uint32_t me = communicator_.rank();
    Ranks               fellows(1, me);
    shares_.assign(first_entry_.size(), {});
    for (std::size_t e = 0; e < entries_.size(); ++e)
      {
        const Ranks &ranks = of_clusters_[clusters_[e]];
        const auto   place = std::find(ranks.begin(), ranks.end(), me);
        PointShare   share{0, 0};
        if (place != ranks.end())
          {
            share = {static_cast<unsigned int>(place - ranks.begin()),
                     static_cast<unsigned int>(ranks.size())};
            if (share.number > 1)
              fellows = ranks;
          }
        shares_[entries_[e].pair].push_back(share);
      }
    messages_.set_workers(find_workers(), fellows);
    return changes;
  }

  std::vector<std::map<unsigned int, const ContactRanks::Ranks *>>
  ContactRanks::find_workers() const
  {
    std::vector<std::map<unsigned int, const Ranks *>> workers(nodes_.surfaces.size());
    for (std::size_t e = 0; e < entries_.size(); ++e)
      for (unsigned int side = 0; side < 2; ++side)
        for (const unsigned int i : nodes_of(entries_[e], side))
          workers[2 * entries_[e].pair + side][i] = &of_clusters_[clusters_[e]];
    return workers;
  }

  void ContactRanks::serialize(const ContactPairs &pairs, ByteStream &stream)
  {
    find_clusters(pairs);
    std::vector<std::uint32_t> numbers; // of each candidate: how many ranks, these
    if (!stream.reads())
      for (const Entry &entry : entries_)
        {
          const Ranks &ranks = ranks_of_.at(entry);
          numbers.push_back(ranks.size());
          numbers.insert(numbers.end(), ranks.begin(), ranks.end());
        }
    stream.pass(numbers);
    if (!stream.reads())
      return;
    std::vector<Ranks> of_clusters(n_clusters_);
    std::size_t        next = 0;
    for (std::size_t e = 0; e < entries_.size(); ++e)
      {
        const std::size_t n = next < numbers.size() ? numbers[next++] : 0;
        stream.require(n > 0 && n <= communicator_.size() && n <= numbers.size() - next,
                       "a contact has no rank");
        of_clusters[clusters_[e]].assign(numbers.begin() + next, numbers.begin() + next + n);
        next += n;
        for (const std::uint32_t rank : of_clusters[clusters_[e]])
          stream.require(rank < communicator_.size(), "a rank does not exist");
      }
    set_ranks(std::move(of_clusters));
  }
} // namespace vfife
