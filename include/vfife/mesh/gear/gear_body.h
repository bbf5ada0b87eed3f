// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_mesh_gear_gear_body_h
#define vfife_mesh_gear_gear_body_h

#include <vfife/gear/gear_geometry.h>
#include <vfife/mesh/body_mesh.h>
#include <vfife/mesh/gear/gear_body_options.h>

#include <memory>

namespace vfife
{
  /**
   * The mesh of a gear: one sector is built (doc/theory/mesh.md) and turned z times about the axis;
   * node and cell numbers run sector by sector, node i of sector k is node i of sector 0 turned by
   * 2 pi k / z. Node sets, surfaces and boundary ids as in node_set_names.h, material ids as in
   * GearRegion, manifolds as in gear_manifolds.h: further refinement keeps to the true surfaces
   * (sets and surfaces describe the mesh as it is returned). Throws InputError as check() does, and
   * NumericalError for an inverted cell.
   */
  std::unique_ptr<BodyMesh> make_gear_body(const GearGeometry    &gear,
                                           const GearBodyOptions &options);
} // namespace vfife

#endif
