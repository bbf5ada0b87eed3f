// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_contact_search_local_search_h
#define vfife_contact_search_local_search_h

#include <vfife/contact/surface/surface_geometry.h>

namespace vfife
{
  /** A point seen from the master: x = y(xi, eta) + lambda m(xi, eta), m = sum N_k n_k (not
   * normalized). */
  struct Projection
  {
    unsigned int facet  = FacetSurface::no_facet;
    double       xi     = 0.5;
    double       eta    = 0.5;
    double       lambda = 0.;
    bool inside = false; ///< converged with (xi, eta) in the facet; else beyond the border or lost
  };

  /**
   * Solves x = y(xi, eta) + lambda m(xi, eta) on one facet by Newton's method from the values in @p
   * projection, without leaving the facet. (xi, eta) are kept in [-1, 2]. Sides in @p border_sides
   * (bits) are the surface's border: a thousandth of the facet beyond them still counts as inside.
   * Returns whether it converged.
   */
  bool project_on_facet(const FacetState &facet,
                        unsigned int      border_sides,
                        const Vector3    &x,
                        Projection       &projection);

  /**
   * The same with the inside-outside walk: when (xi, eta) leaves the facet, the search goes on in
   * the neighbour across the side that it left, until it is inside or only border sides are left to
   * cross. Returns false when it got lost (a wide search is due); being beyond the border is no
   * loss.
   */
  bool project_walking(SurfaceGeometry &master, const Vector3 &x, Projection &projection);

  /** Distance [mm] from @p x to the facet's point at (xi, eta) clamped into the facet. */
  double clamped_distance(const FacetState &facet, const Vector3 &x, const Projection &projection);
} // namespace vfife

#endif
