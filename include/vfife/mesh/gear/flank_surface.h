// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_mesh_gear_flank_surface_h
#define vfife_mesh_gear_flank_surface_h

#include <vfife/base/facet_surface.h>
#include <vfife/mesh/gear/sector/gear_sector.h>

#include <vector>

namespace vfife
{
  /**
   * The flanks of one side of all teeth as FacetSurface: nodes on the true flank with true normals,
   * and the offsets of the bilinear facets to the true flank at 5 x 5 Gauss-Lobatto points, found
   * by Newton's method along the facet's normal field. Node i of the sector is node i + k *
   * nodes_per_sector of tooth k. Deviations of the gear's flanks are part of the offsets, also at
   * the nodes, which stay on the flank without them. Rows of the table are shared by all teeth that
   * deviate alike.
   */
  FacetSurface make_flank_surface(const GearGeometry &gear,
                                  const FlankGrid    &grid,
                                  unsigned int        nodes_per_sector);

  /** The five Gauss-Lobatto points of [0, 1] at which offsets are tabulated. */
  std::vector<double> offset_abscissae();
} // namespace vfife

#endif
