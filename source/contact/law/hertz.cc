// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/contact/law/hertz.h>

#include <cmath>

namespace vfife
{
  namespace
  {
    /** Of the ellipse with axes 1 and b: int (1 - e^2 sin^2)^(+-1/2), and A/B of the gap that has
     * it. */
    struct EllipseIntegrals
    {
      double first, second, curvature_ratio;

      explicit EllipseIntegrals(const double b)
      {
        const double e = std::sqrt((1. - b) * (1. + b));
        first          = std::comp_ellint_1(e);
        second         = std::comp_ellint_2(e);
        // Johnson (4.26): B/A = ((a/b)^2 E - K)/(K - E); both vanish together on a circle.
        curvature_ratio =
          e < 1e-4 ? 1. - 0.75 * e * e : (first - second) * b * b / (second - b * b * first);
      }
    };
  } // namespace

  HertzContact::HertzContact(const Vector2 &curvatures, const double modulus)
  {
    if (!(curvatures[0] > 0. && curvatures[1] >= curvatures[0] && modulus > 0.))
      throw InputError("Hertz's contact needs positive relative curvatures, the smaller one first, "
                       "and a positive modulus");
    // The ratio of the axes falls with that of the curvatures: bisection of its logarithm.
    const double ratio = curvatures[0] / curvatures[1];
    double       low = 1e-7, high = 1.;
    while (high / low > 1. + 1e-14)
      {
        const double middle                                             = std::sqrt(low * high);
        (EllipseIntegrals(middle).curvature_ratio < ratio ? low : high) = middle;
        if (middle == low && middle == high)
          break;
      }
    axis_ratio_ = std::sqrt(low * high);
    const EllipseIntegrals integrals(axis_ratio_);

    // With p0 = 3F/(2 pi a b): approach = p0 b K/E*, and along x the curvature A/2 = p0 b (K -
    // E)/(E* e^2 a^2), along y B/2 = p0 b ((a/b)^2 E - K)/(E* e^2 a^2) (Johnson (4.24) to (4.26)).
    // Their sum (A + B)/2 = p0 b ((a/b)^2 - 1) E/(E* e^2 a^2) = p0 E/(E* b) holds on a circle too.
    const double sum = curvatures.sum();
    major_ =
      std::cbrt(3. * integrals.second / (pi * modulus * sum)) / std::pow(axis_ratio_, 2. / 3.);
    approach_ = 1.5 * integrals.first / (pi * modulus * major_);
  }

  Vector2 HertzContact::semi_axes(const double force) const
  {
    const double a = major_ * std::cbrt(force);
    return {a, axis_ratio_ * a};
  }

  double HertzContact::largest_pressure(const double force) const
  {
    const Vector2 axes = semi_axes(force);
    return axes[1] > 0. ? 1.5 * force / (pi * axes[0] * axes[1]) : 0.;
  }

  double HertzContact::approach(const double force) const
  {
    return approach_ * std::pow(force, 2. / 3.);
  }

  double contact_modulus(const double youngs_modulus_1,
                         const double poissons_ratio_1,
                         const double youngs_modulus_2,
                         const double poissons_ratio_2)
  {
    return 1. / ((1. - poissons_ratio_1 * poissons_ratio_1) / youngs_modulus_1 +
                 (1. - poissons_ratio_2 * poissons_ratio_2) / youngs_modulus_2);
  }
} // namespace vfife
