// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/gear/flank_points.h>

namespace vfife
{
  Table
  compute_flank_points(const GearGeometry &gear, const unsigned lengthwise, const unsigned profile)
  {
    if (lengthwise < 2 || profile < 2)
      throw InputError(
        "flank points: at least 2 along the tooth and 2 along its profile are needed");
    Table table;
    table.add_text_column("side");
    for (const char *name : {"L", "h", "x", "y", "z"})
      table.add_column(name, "mm");
    for (const char *name : {"normal x", "normal y", "normal z"})
      table.add_column(name, "-");

    const BlankOutline &blank = gear.blank();
    for (const FlankSide side : {FlankSide::concave, FlankSide::convex})
      for (unsigned i = 0; i < lengthwise; ++i)
        {
          const double L = blank.inner_cone_distance() + blank.face_width * i / (lengthwise - 1);
          // even steps of h between the end of the fillet and the tip
          const Vector3 start = gear.fillet_point(side, L, gear.fillet_end(side)).position;
          const double  low   = blank.coordinates_of(start)[1];
          for (unsigned j = 0; j < profile; ++j)
            {
              const double       h = low + (blank.flank_tip(L) - low) * j / (profile - 1);
              const SurfacePoint p = gear.flank_point(side, L, h);
              table.add_row({name_of(side),
                             L,
                             h,
                             p.position[0],
                             p.position[1],
                             p.position[2],
                             -p.normal[0],
                             -p.normal[1],
                             -p.normal[2]});
            }
        }
    return table;
  }
} // namespace vfife
