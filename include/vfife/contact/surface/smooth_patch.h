// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_contact_surface_smooth_patch_h
#define vfife_contact_surface_smooth_patch_h

#include <vfife/base/facet_surface.h>

namespace vfife
{
  /**
   * Gives a surface of plain facets the offsets to smooth patches through its nodes: quadratic
   * patches whose edges are normal to the nodal normals at both ends (Nagata, Computer Aided
   * Geometric Design 22, 2005, 327-347). Neighbours share the curve along their edge, so the
   * patched surface has no gaps; across edges its slope is continuous at the nodes and nearly so
   * between.
   *
   * The nodal normals are FacetSurface::normals, one per node. Existing offsets are replaced.
   */
  FacetSurface with_smooth_patches(FacetSurface surface);

  /** Whether two facets of a surface that share a side are inclined by more than 40 degrees:
   * patches would round that edge off. */
  bool has_sharp_edges(const FacetSurface &surface);
} // namespace vfife

#endif
