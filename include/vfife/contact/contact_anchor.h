// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_contact_contact_anchor_h
#define vfife_contact_contact_anchor_h

#include <vfife/base/facet_surface.h>

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
} // namespace vfife

#endif
