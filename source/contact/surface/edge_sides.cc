// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/contact/surface/edge_sides.h>

namespace vfife
{
  unsigned int group_of(const FacetSurface &surface, const std::size_t facet)
  {
    return surface.group.empty() ? 0 : surface.group[facet];
  }

  unsigned int
  edge_number(const FacetSurface &surface, const std::size_t facet, const unsigned int side)
  {
    if (!surface.edges.empty())
      return surface.edges[facet][side];
    const unsigned int other = surface.neighbours[facet][side];
    return other == FacetSurface::no_facet || group_of(surface, other) != group_of(surface, facet);
  }
} // namespace vfife
