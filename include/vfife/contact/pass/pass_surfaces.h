// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_contact_pass_pass_surfaces_h
#define vfife_contact_pass_pass_surfaces_h

#include <vfife/contact/pass/slave_points.h>
#include <vfife/contact/search/local_search.h>
#include <vfife/contact/touch_geometry.h>

namespace vfife
{
  /** The two surfaces of a pass in their current state: points against facets. */
  struct PassSurfaces
  {
    SlavePoints     slave;
    SurfaceGeometry master;
    double          edge_fading; ///< part of a border facet of the master; 0: none

    PassSurfaces(const FacetSurface   &slave,
                 const FacetSurface   &master,
                 const ContactOptions &options,
                 const double          area_factor)
      : slave(slave, options, area_factor)
      , master(master, options.surface, EdgeRelief(master, options))
      , edge_fading(options.edge_fading)
    {
    }

    /** Sets the current state; the arrays must stay valid until the next call. */
    void bind(const SurfaceMotion &of_slave, const SurfaceMotion &of_master)
    {
      slave.bind(of_slave);
      master.bind(of_master);
    }

    /** Gap at the foot of a slave's point between the true surfaces [mm]. */
    double gap(const Projection &foot, const double slave_offset)
    {
      // lambda counts in lengths of the normal field.
      return foot.lambda * master.state(foot.facet).normal(foot.xi, foot.eta).norm() -
             master.offset(foot.facet, foot.xi, foot.eta) - slave_offset;
    }

    /** The master's unit normal at a foot. */
    Vector3 normal(const Projection &foot)
    {
      return master.state(foot.facet).normal(foot.xi, foot.eta).normalized();
    }

    Fading fading(const Projection &foot) const
    {
      return edge_fading > 0. ? Fading(master, foot, edge_fading) : Fading();
    }
  };
} // namespace vfife

#endif
