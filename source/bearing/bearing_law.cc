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

  BearingResponse LinearBearing::evaluate(const Vector5 &displacement) const
  {
    const Vector5 springs = stiffness_ * displacement;
    return {preload_ - springs, stiffness_, displacement.dot(.5 * springs - preload_)};
  }

  Matrix5 mean_over_turns(const Matrix5 &matrix)
  {
    // T K T^T is a polynomial of second degree in the cosine and sine of the angle: four quarters
    // of a turn give its mean, all harmonics up to the third being summed to zero.
    Matrix5 mean = Matrix5::Zero();
    Matrix5 turn = Matrix5::Identity();
    Matrix5 quarter;
    quarter << 0, -1, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, -1, 0, 0, 0, 1, 0;
    for (unsigned int i = 0; i < 4; ++i)
      {
        mean += .25 * turn * matrix * turn.transpose();
        turn = (turn * quarter).eval();
      }
    return mean;
  }
} // namespace vfife
