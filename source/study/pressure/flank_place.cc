// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/gear/blank_outline.h>
#include <vfife/study/pressure/flank_place.h>

#include <cmath>

namespace vfife
{
  Vector2 place_on_flank(const BlankOutline &blank, const Vector2 &r_z)
  {
    // Along and across the pitch cone from the apex, at which the axial section of a body has its
    // origin.
    const double sine = std::sin(blank.pitch_angle), cosine = std::cos(blank.pitch_angle);
    return Vector2(r_z[1] * cosine + r_z[0] * sine - blank.mean_cone_distance,
                   r_z[0] * cosine - r_z[1] * sine);
  }
} // namespace vfife
