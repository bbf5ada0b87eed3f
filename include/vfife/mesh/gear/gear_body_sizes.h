// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_mesh_gear_gear_body_sizes_h
#define vfife_mesh_gear_gear_body_sizes_h

#include <vfife/gear/gear_geometry.h>
#include <vfife/mesh/gear/gear_body_options.h>

namespace vfife
{
  /**
   * The body with the sizes that are open (0), in tenths of a millimetre and in the proportions
   * of the reference pair 27/79, whose own come out: thicknesses of web and rim 1.587 and 2.7
   * outer transverse modules; hub radius and length 0.632 and 0.379 of the root's radius at the
   * toe, the hub at least a fifth longer than the web's foot on it; the bore 5/6 of the hub
   * radius, or 0.64 of that radius of a solid body. An element size that is open follows from
   * edge_in_modules.
   */
  GearBodyOptions with_open_sizes(GearBodyOptions options, const BlankOutline &blank);

  /** The body with the counts that the element size asks for, each at least as small as
   * check_gear_body() allows; unchanged where no size is given. */
  GearBodyOptions with_counts_of_size(GearBodyOptions options, const GearGeometry &gear);
} // namespace vfife

#endif
