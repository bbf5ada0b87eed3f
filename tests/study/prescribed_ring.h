// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_tests_study_prescribed_ring_h
#define vfife_tests_study_prescribed_ring_h

#include <string>

/** Section Model: a thin ring, widened by 0.01 mm and turned by half a degree at its inner radius.
 */
inline std::string prescribed_ring()
{
  return R"(
subsection Model
  set bodies      = ring
  set constraints = inside, below
  set probes      = inner, outer
  subsection Body ring
    set mesh         = ring
    set inner radius = 20 mm
    set outer radius = 40 mm
    set height       = 2 mm
    set radial cells = 10
    set cells around = 60
    set axial cells  = 1
  end
  subsection Constraint inside
    set kind         = displacement
    set nodes        = inner
    set directions   = r, theta
    set displacement = 0.01, 0, 0 mm
    set angle        = 0.5 deg
  end
  subsection Constraint below
    set kind       = displacement
    set nodes      = bottom
    set where      = x^2 + y^2 > 401
    set directions = z
  end
  subsection Probe inner
    set point = 20, 0, 0 mm
    set axes  = r, theta, z
  end
  subsection Probe outer
    set point = 40, 0, 0 mm
    set axes  = r, theta, z
  end
end
)";
}

#endif
