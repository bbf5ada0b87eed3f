// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_tests_study_prescribed_ring_h
#define vfife_tests_study_prescribed_ring_h

#include "../model_sections.h"

/** Section Model: a thin ring, widened by 0.01 mm and turned by half a degree at its inner radius.
 */
inline std::string prescribed_ring()
{
  return "subsection Model\n"
         "  set bodies      = ring\n"
         "  set constraints = inside, below\n"
         "  set probes      = inner, outer\n" +
         model_text::ring("ring", {{20, 40, 2}}, {{10, 60, 1}}) +
         model_text::section("Constraint inside", R"(
    set kind         = displacement
    set nodes        = inner
    set directions   = r, theta
    set displacement = 0.01, 0, 0 mm
    set angle        = 0.5 deg
)") + model_text::section("Constraint below", R"(
    set kind       = displacement
    set nodes      = bottom
    set where      = x^2 + y^2 > 401
    set directions = z
)") + model_text::probe("inner", "20, 0, 0 mm", "r, theta, z") +
         model_text::probe("outer", "40, 0, 0 mm", "r, theta, z") + "end\n";
}

#endif
