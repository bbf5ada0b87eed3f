// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_contact_pass_smallest_gap_h
#define vfife_contact_pass_smallest_gap_h

#include <vfife/contact/contact_results.h>
#include <vfife/contact/pass/pass_surfaces.h>
#include <vfife/contact/pass/point_list.h>

#include <vector>

namespace vfife
{
  /** Smallest gap over the slave's facets, also between their points. The search begins at the
   * smallest gaps of @p points, where points of a facet follow each other. The gap is infinite when
   * there is none. */
  ContactPoint find_smallest_gap(PassSurfaces &surfaces, const std::vector<ListedPoint> &points);
} // namespace vfife

#endif
