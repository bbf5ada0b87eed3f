// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_contact_pass_wide_search_h
#define vfife_contact_pass_wide_search_h

#include <vfife/contact/pass/pass_surfaces.h>
#include <vfife/contact/pass/point_list.h>
#include <vfife/contact/search/broad_search.h>

#include <vector>

namespace vfife
{
  /** Finds points that have no projection on a group of the master, by boxes of its facets in their
   * state at construction. */
  class WideSearch
  {
  public:
    WideSearch(PassSurfaces &surfaces, unsigned int master_group);

    /** Nearest foot of @p x within @p reach [mm] on a facet that faces @p slave_normal; false where
     * there is none. */
    bool find_foot(const Vector3 &x, const Vector3 &slave_normal, double reach, Projection &foot);

    /** Replaces the points of a @p list with this master group: points of its share with gaps from
     * -@p depth_reach to @p open_reach [mm], and points beyond the border. */
    void find_points(PointList &list, double open_reach, double depth_reach);

  private:
    /** The same on the facets @p near, numbers in the group; the one found goes to their front. */
    bool find_foot(const Vector3             &x,
                   const Vector3             &slave_normal,
                   double                     reach,
                   std::vector<unsigned int> &near,
                   Projection                &foot);

    PassSurfaces                    &surfaces_;
    const std::vector<unsigned int> &group_;
    std::vector<Box>                 boxes_; ///< of the group's facets
  };
} // namespace vfife

#endif
