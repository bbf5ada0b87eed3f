// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_contact_surface_edge_sides_h
#define vfife_contact_surface_edge_sides_h

#include <vfife/base/facet_surface.h>

namespace vfife
{
  /** Of a facet, 0 where the surface has no groups. */
  unsigned int group_of(const FacetSurface &surface, std::size_t facet);

  /** The number of the body's edge on which a side of a facet lies, FacetSurface::edges; where
   * edges are not numbered the whole border of a group is its edge 1. 0: none. The surface's
   * neighbours must be known. */
  unsigned int edge_number(const FacetSurface &surface, std::size_t facet, unsigned int side);
} // namespace vfife

#endif
