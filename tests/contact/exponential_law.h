// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_tests_contact_exponential_law_h
#define vfife_tests_contact_exponential_law_h

#include <vfife/contact/law/penalty_options.h>

#include <cmath>

/**
 * A contact law that the program does not have: the pressure grows exponentially with the
 * penetration until its slope has reached the penalty at the depth `depth`, and linearly from there
 * on.
 */
class ExponentialLaw : public vfife::ContactLaw
{
public:
  static constexpr double length = 2e-3, depth = 8e-3; // [mm]

  explicit ExponentialLaw(const vfife::PenaltyOptions &)
  {
  }

  void evaluate(std::vector<vfife::PressedPoint> &points) const override
  {
    const double start = std::exp(-depth / length);
    for (vfife::PressedPoint &point : points)
      {
        // p = eps l (e^((h - d)/l) - e^(-d/l)) up to the depth d
        const double h      = std::min(point.penetration, depth);
        const double beyond = point.penetration - h;
        const double slope  = std::exp((h - depth) / length);
        point.pressure      = point.penalty * length * (slope - start);
        point.energy        = point.penalty * length * (length * (slope - start) - h * start);
        point.tangent       = point.penalty * slope;
        point.energy += beyond * (point.pressure + 0.5 * point.penalty * beyond);
        point.pressure += point.penalty * beyond;
      }
  }
};

#endif
