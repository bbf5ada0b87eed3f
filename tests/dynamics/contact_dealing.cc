// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// What ranks get of the contact: whole clusters, shares of heavy ones, or shares of all.
#include "../model_parts.h"
#include "../parts.h"
#include "../tests.h"

#include <vfife/dynamics/loads/contact/contact_dealing.h>

#include <cstdint>

using namespace vfife;

/** Each cluster is in one part, no part is empty, and there are ranks for all. */
bool is_complete(const std::vector<ContactPart> &parts,
                 const std::size_t               n_clusters,
                 const unsigned int              n_ranks)
{
  std::vector<unsigned int> found;
  unsigned int              used = 0;
  for (const ContactPart &part : parts)
    {
      found.insert(found.end(), part.clusters.begin(), part.clusters.end());
      used += part.n_ranks;
      if (part.clusters.empty() || part.n_ranks == 0)
        return false;
    }
  std::sort(found.begin(), found.end());
  return found == numbers_below(n_clusters) && used <= n_ranks;
}

void check_simple()
{
  check("nothing touches", deal_clusters({}, 4).empty());

  // One rank does all. Two clusters of 60 and 50 on two ranks: one each, none shares points.
  const auto alone = deal_clusters({60., 50.}, 1);
  check_close("one rank: largest load", find_largest_load(alone, {60., 50.}), 110., 0.);
  const auto each = deal_clusters({60., 40., 10.}, 2);
  check("two ranks: complete", is_complete(each, 3, 2));
  check_close("two ranks, clusters that fit", find_largest_load(each, {60., 40., 10.}), 60., 0.);
  check("two ranks: nothing is shared", each.size() == 2 && each[0].n_ranks == 1);

  // One heavy cluster: both ranks share all, 0.3 of the work is done by both.
  const auto heavy = deal_clusters({100., 1.}, 2);
  check("a heavy one: shared by both", heavy.size() == 1 && heavy[0].n_ranks == 2);
  check_close("a heavy one: load", find_largest_load(heavy, {100., 1.}), 101. * .65, 1e-12);

  // Clusters without work yet are dealt too.
  const auto idle = deal_clusters({0., 0., 0.}, 2);
  check("without work: complete", is_complete(idle, 3, 2));
}

/** Whatever the work: complete, the same again, and no rank has more than in the simpler deals,
 * all by one rank or all shared by all. With many like clusters all ranks have the same. */
void check_many()
{
  std::uint32_t seed = 7;
  const auto    next = [&seed] {
    seed = seed * 1664525u + 1013904223u;
    return (seed >> 8) / 16777216.;
  };
  unsigned int wrong = 0;
  for (unsigned int round = 0; round < 2000; ++round)
    {
      const unsigned int  n_ranks = 1 + static_cast<unsigned int>(next() * 12.);
      std::vector<double> work(1 + static_cast<unsigned int>(next() * 9.));
      for (double &w : work)
        w = next() < .3 ? 0. : next() * next() * 100.;
      const auto   parts    = deal_clusters(work, n_ranks);
      const double sum      = std::accumulate(work.begin(), work.end(), 0.);
      const double load     = find_largest_load(parts, work);
      const double together = n_ranks == 1 ? sum : sum * (.3 + .7 / n_ranks);
      if (!is_complete(parts, work.size(), n_ranks) || load > together * (1. + 1e-12) ||
          load < sum / n_ranks * (1. - 1e-12))
        ++wrong;
    }
  check_close("2000 deals that are not complete or not good", wrong, 0, 0.);
  const std::vector<double> like(24, 5.);
  check_close("24 like clusters on 8 ranks: load",
              find_largest_load(deal_clusters(like, 8), like),
              15.,
              1e-12);
}

int main()
{
  return run_parts({check_simple, check_many});
}
