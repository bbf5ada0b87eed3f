// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_contact_pass_smallest_gap_h
#define vfife_contact_pass_smallest_gap_h

#include <vfife/contact/contact_results.h>
#include <vfife/contact/pass/pass_surfaces.h>
#include <vfife/contact/pass/point_list.h>

#include <vector>

namespace vfife
{
  /** The smallest gap over the slave's facets, also between their points, searched from the gaps of
   * @p points (those of a facet one after another) on. The gap is infinite when there is none. */
  ContactPoint find_smallest_gap(PassSurfaces &surfaces, const std::vector<ListedPoint> &points);
} // namespace vfife

#endif
