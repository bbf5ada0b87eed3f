// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_contact_pass_point_list_h
#define vfife_contact_pass_point_list_h

#include <vfife/base/facet_surface.h>
#include <vfife/contact/search/local_search.h>

#include <vector>

namespace vfife
{
  /**
   * Where on the master a slave's point sticks: its friction is a spring from there to its foot. As
   * the place belongs to the facet, it moves and turns with it. (xi, eta) may lie a little beyond
   * the facet.
   */
  struct ContactAnchor
  {
    unsigned int facet = FacetSurface::no_facet; ///< none: the point does not touch
    double       xi = 0.5, eta = 0.5;
    double       elastic = 0.; ///< displacement from here to the foot, when it last moved on [mm]
    double       energy  = 0.; ///< of the spring then [mJ]

    bool holds() const
    {
      return facet != FacetSurface::no_facet;
    }
  };

  /** The anchor of a point of the slave, whoever has the point. */
  struct AnchorOfPoint
  {
    unsigned int  pass, slave_group, master_group, slave_facet, rule_point;
    ContactAnchor anchor;
  };

  /** Which of the points of a pair of groups a rank looks at: those of the slave facets f with
   * f % number == place. Several ranks share a pair by their places; number is 0 where a rank has
   * nothing to do with it. */
  struct PointShare
  {
    unsigned int place = 0, number = 1;

    bool empty() const
    {
      return number == 0;
    }
    bool has(const unsigned int slave_facet) const
    {
      return number > 0 && slave_facet % number == place;
    }
    bool operator==(const PointShare &other) const
    {
      return place == other.place && number == other.number;
    }
  };

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
