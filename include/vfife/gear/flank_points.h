// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_gear_flank_points_h
#define vfife_gear_flank_points_h

#include <vfife/base/text/table.h>
#include <vfife/gear/gear_geometry.h>

namespace vfife
{
  /**
   * Points of the true flanks of tooth 0 from toe to heel and from the start of the flank to
   * the tip, @p lengthwise x @p profile points a side (at least 2 each): side, L, h, position [mm]
   * and unit normal out of the metal, in the body frame.
   */
  Table compute_flank_points(const GearGeometry &gear, unsigned lengthwise, unsigned profile);
} // namespace vfife

#endif
