// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/bearing/bearing_law.h>

namespace vfife
{
  LinearBearing::LinearBearing(const Matrix5 &stiffness,
                               const Matrix5 &damping,
                               const Vector5 &preload)
    : BearingLaw(damping)
    , stiffness_(stiffness)
    , preload_(preload)
  {
  }

  BearingResponse LinearBearing::evaluate(const Vector5 &displacement, double /*turn*/) const
  {
    const Vector5 springs = stiffness_ * displacement;
    return {preload_ - springs, stiffness_, displacement.dot(.5 * springs - preload_), 0.};
  }
} // namespace vfife
