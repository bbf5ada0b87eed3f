// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/contact/law/linear_law.h>

namespace vfife
{
  LinearLaw::LinearLaw(const PenaltyOptions &)
  {
  }

  void LinearLaw::evaluate(std::vector<PressedPoint> &points) const
  {
    for (PressedPoint &point : points)
      {
        point.pressure = point.penalty * point.penetration;
        point.energy   = 0.5 * point.pressure * point.penetration;
        point.tangent  = point.penalty;
      }
  }
} // namespace vfife
