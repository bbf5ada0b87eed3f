// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_dynamics_loads_contact_contact_dealing_h
#define vfife_dynamics_loads_contact_contact_dealing_h

#include <vector>

namespace vfife
{
  /** Clusters of contact that some ranks work on: one rank on its own, or several that share the
   * points of each of them. */
  struct ContactPart
  {
    std::vector<unsigned int> clusters;
    unsigned int              n_ranks = 1;

    /** What one of its ranks has to do. Ranks that share points all follow the motion of the whole
     * part and all solve for its pressures: that share of the @p work of the clusters is repeated.
     */
    double load(const std::vector<double> &work) const;
  };

  /** The largest load of a rank. */
  double find_largest_load(const std::vector<ContactPart> &parts, const std::vector<double> &work);

  /**
   * Deals clusters, which have no node in common, to at most @p n_ranks ranks by their @p work, so
   * that no rank has much more than the others: whole ones where these are enough, the heaviest
   * first; some ranks for one that is heavier than a rank's share; or all together to all ranks.
   * The same on all ranks; no part is empty.
   */
  std::vector<ContactPart> deal_clusters(const std::vector<double> &work, unsigned int n_ranks);
} // namespace vfife

#endif
