// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_contact_pass_point_list_h
#define vfife_contact_pass_point_list_h

#include <vfife/contact/contact_anchor.h>
#include <vfife/contact/point_share.h>
#include <vfife/contact/search/local_search.h>

#include <vector>

namespace vfife
{
  /** A quadrature point of a slave facet that may touch, with its last projection. */
  struct ListedPoint
  {
    unsigned int slave_facet, rule_point;
    Projection   projection;
    double       area;          ///< [mm^2]
    double       slave_offset;  ///< [mm]
    double       gap, pressure; ///< of the last evaluation [mm], [MPa]
  };

  /** The points of a pair of groups that may touch, and what is known of each. */
  struct PointList
  {
    unsigned int             slave_group = 0, master_group = 0;
    PointShare               share;
    double                   work     = 0.; ///< in the cost of finding where a point lies
    bool                     listed   = false;
    double                   built_at = 0.; ///< path at the wide search [mm]
    std::vector<ListedPoint> points;
    /** Path of the pair at which each point must be looked at again [mm]. */
    std::vector<double>       awake_at;
    std::vector<unsigned int> touching; ///< points that touch in this evaluation
    /** Of each point, where there is friction; energy of those that have opened [mJ]. */
    std::vector<ContactAnchor> anchors;
    double                     released = 0.;
  };
} // namespace vfife

#endif
