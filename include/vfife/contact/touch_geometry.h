// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_contact_touch_geometry_h
#define vfife_contact_touch_geometry_h

#include <vfife/contact/search/local_search.h>
#include <vfife/contact/surface/surface_geometry.h>

#include <array>

namespace vfife
{
  /** Weight of a point near the master's border and its slopes in xi and eta. */
  struct Fading
  {
    double weight = 1., slope_xi = 0., slope_eta = 0.;

    Fading() = default;
    /** From 0 at the border to 1 over the part @p width of a border facet, 0 < width <= 1; without
     * kink. */
    Fading(const SurfaceGeometry &master, const Projection &p, double width);
  };

  /** Directions along the master's facet at a point, and what a tangential force there needs. */
  struct TangentBasis
  {
    Vector3               normal;              ///< unit normal at the foot
    Vector3               dual_xi, dual_eta;   ///< gradients of xi and eta [1/mm]
    double                slope_xi, slope_eta; ///< of the gap, as the point slides: -dg/dxi [mm]
    double                distance;            ///< of slave and master point along the normal [mm]
    std::array<double, 4> shape_xi, shape_eta; ///< derivatives of the bilinear weights

    /** At the slave's point @p x with its foot @p p and the @p unit_normal there. */
    TangentBasis(SurfaceGeometry  &master,
                 const Projection &p,
                 const Vector3    &x,
                 const Vector3    &unit_normal);

    /** What balances the moment of a tangential @p force on the slave: a force along the normal on
     * the master's corner @p k. */
    double couple_share(const Vector3 &force, unsigned int k) const;
  };
} // namespace vfife

#endif
