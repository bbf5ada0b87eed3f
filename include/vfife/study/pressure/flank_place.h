// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_study_pressure_flank_place_h
#define vfife_study_pressure_flank_place_h

#include <vfife/base/types.h>

namespace vfife
{
  struct BlankOutline;

  /** Where a point of a flank at radius and height @p r_z [mm] of its body frame is: along the face
   * from the mean cone distance, > 0 to the heel, and along the profile from the pitch cone, > 0 to
   * the tip [mm]. */
  Vector2 place_on_flank(const BlankOutline &blank, const Vector2 &r_z);
} // namespace vfife

#endif
