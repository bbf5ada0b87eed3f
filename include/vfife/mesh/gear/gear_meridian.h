// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_mesh_gear_gear_meridian_h
#define vfife_mesh_gear_gear_meridian_h

#include <vfife/base/text/table.h>
#include <vfife/gear/gear_geometry.h>
#include <vfife/mesh/gear/gear_body_options.h>
#include <vfife/mesh/solid_integrals.h>

#include <string>
#include <vector>

namespace vfife
{
  /** A part of a gear body in the meridian plane: closed polygon of corners (r, z) [mm]. */
  struct MeridianPart
  {
    std::string          name; ///< "teeth", "rim", "web", "hub", "shaft 1", "shaft 2", ...
    std::vector<Vector2> corners;
  };

  /**
   * The meridian of the true body, without a mesh: teeth between root and tip, rim (of a solid body
   * down to the bore), web with its fillets (arcs of many chords), hub, and each section of a
   * shaft. Everything but the teeth is a solid of revolution.
   */
  std::vector<MeridianPart> compute_meridian(const GearGeometry    &gear,
                                             const GearBodyOptions &options);

  /** Corners of the parts as rows: body, part, r, z. */
  void add_meridian_rows(const GearGeometry &gear, const GearBodyOptions &options, Table &table);
  /** A table with columns for these rows. */
  Table make_meridian_table();

  /**
   * Integrals over the true body: all teeth between their true flanks and fillets, by sections
   * of constant L, and the solids of revolution under them (doc/theory/mesh.md). What a mesh
   * converges to.
   */
  SolidIntegrals compute_true_integrals(const GearGeometry &gear, const GearBodyOptions &options);
} // namespace vfife

#endif
