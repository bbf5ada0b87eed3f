// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/dynamics/loads/contact/contact_dealing.h>

#include <algorithm>
#include <numeric>

namespace vfife
{
  namespace
  {
    /** Of the work on a cluster, what each of several ranks that share it does (measured,
     * doc/developer/performance.md, Two ranks). */
    constexpr double repeated_share = 0.3;

    /** The heaviest clusters get ranks of their own in proportion, the others go one by one to
     * the rank that has least. */
    std::vector<ContactPart> deal_whole(const std::vector<double> &work, const unsigned int n_ranks)
    {
      std::vector<unsigned int> order(work.size());
      std::iota(order.begin(), order.end(), 0u);
      std::stable_sort(order.begin(), order.end(), [&work](const unsigned a, const unsigned b) {
        return work[a] > work[b];
      });
      std::vector<ContactPart> parts;
      unsigned int             n_left    = n_ranks;
      double                   work_left = std::accumulate(work.begin(), work.end(), 0.);
      std::size_t              next      = 0;
      for (; next < order.size(); ++next)
        {
          const unsigned int others = next + 1 < order.size() ? 1 : 0;
          const double       share  = work_left > 0. ? work[order[next]] / work_left * n_left : 1.;
          const auto         n = std::min(n_left - others, static_cast<unsigned int>(share + .5));
          if (n < 2)
            break;
          parts.push_back({{order[next]}, n});
          n_left -= n;
          work_left -= work[order[next]];
        }
      std::vector<ContactPart> single(n_left);
      std::vector<double>      loads(n_left, 0.);
      for (; next < order.size(); ++next)
        {
          const auto least = std::min_element(loads.begin(), loads.end());
          *least += work[order[next]];
          single[least - loads.begin()].clusters.push_back(order[next]);
        }
      for (ContactPart &part : single)
        if (!part.clusters.empty())
          parts.push_back(std::move(part));
      return parts;
    }
  } // namespace

  double ContactPart::load(const std::vector<double> &work) const
  {
    double sum = 0.;
    for (const unsigned int cluster : clusters)
      sum += work[cluster];
    return n_ranks == 1 ? sum : sum * (repeated_share + (1. - repeated_share) / n_ranks);
  }

  double find_largest_load(const std::vector<ContactPart> &parts, const std::vector<double> &work)
  {
    double largest = 0.;
    for (const ContactPart &part : parts)
      largest = std::max(largest, part.load(work));
    return largest;
  }

  std::vector<ContactPart> deal_clusters(const std::vector<double> &work,
                                         const unsigned int         n_ranks)
  {
    if (work.empty())
      return {};
    ContactPart all;
    all.n_ranks = n_ranks;
    all.clusters.resize(work.size());
    std::iota(all.clusters.begin(), all.clusters.end(), 0u);
    const std::vector<ContactPart> together = {all}, whole = deal_whole(work, n_ranks);
    return find_largest_load(together, work) < find_largest_load(whole, work) ? together : whole;
  }
} // namespace vfife
