// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_base_counted_angle_h
#define vfife_base_counted_angle_h

#include <vfife/base/types.h>

namespace vfife
{
  /** An angle that is known but for whole turns, with as many of them as bring it nearest to what
   * it was a moment ago, @p before [rad]. Without any it keeps its last digit. */
  inline double count_turns(const double angle, const double before)
  {
    return angle + 2. * pi * std::nearbyint((before - angle) / (2. * pi));
  }
} // namespace vfife

#endif
