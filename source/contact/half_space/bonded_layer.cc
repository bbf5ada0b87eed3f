// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/contact/half_space/bonded_layer.h>

#include <boost/math/special_functions/bessel.hpp>

#include <cmath>

namespace vfife
{
  namespace
  {
    /** Of the table, over the depth: beyond it the layer does not move any more. */
    constexpr double step = 0.02, reach = 14.;
    /** Wave numbers times the depth at which a layer and a half-space agree to 1e-14, and the
     * points of Simpson's rule up to there: 10 and more for a wave of the Bessel function. */
    constexpr double       largest_wave = 20.;
    constexpr unsigned int n_waves      = 500;

    /** Double precision suffices: Simpson's rule is good to 1e-12. */
    using Precision = boost::math::policies::policy<boost::math::policies::promote_double<false>>;

    /** int du dv/sqrt(u^2 + v^2) over a rectangle between 0 and (u, v), with the sign of u v. */
    double corner_integral(const double u, const double v)
    {
      double sum = 0.;
      if (u != 0.)
        sum += u * std::asinh(v / std::abs(u));
      if (v != 0.)
        sum += v * std::asinh(u / std::abs(v));
      return sum;
    }

    /** Amplitude under a pressure that waves with the wave number times the depth @p k, over that
     * of a half-space. */
    double amplitude(const double k, const double nu)
    {
      // Numerator and denominator times 2 exp(-2k).
      const double e = std::exp(-2. * k), a = 3. - 4. * nu;
      return (a * (1. - e * e) - 4. * k * e) /
             (a * (1. + e * e) + 2. * e * (2. * k * k + 5. - 12. * nu + 8. * nu * nu));
    }
  } // namespace

  double integrate_inverse_distance(const Vector2 &from_middle, const Vector2 &sides)
  {
    const Vector2 high = from_middle + .5 * sides, low = from_middle - .5 * sides;
    return corner_integral(high[0], high[1]) - corner_integral(low[0], high[1]) -
           corner_integral(high[0], low[1]) + corner_integral(low[0], low[1]);
  }

  BondedLayer::BondedLayer(const double poissons_ratio)
  {
    std::vector<double> weights;
    constexpr double    dk = largest_wave / n_waves;
    for (unsigned int i = 0; i <= n_waves; ++i)
      {
        const double simpson = i == 0 || i == n_waves ? 1. : (i % 2 == 1 ? 4. : 2.);
        weights.push_back(dk / 3. * simpson * (amplitude(i * dk, poissons_ratio) - 1.));
      }
    const unsigned int n = static_cast<unsigned int>(std::lround(reach / step));
    for (unsigned int j = 0; j <= n; ++j)
      {
        double sum = 0.;
        for (unsigned int i = 0; i <= n_waves; ++i)
          sum += weights[i] * boost::math::cyl_bessel_j(0, i * dk * j * step, Precision());
        values_.push_back(sum);
      }
  }

  double BondedLayer::correction(const double distance, const double depth) const
  {
    const double place = distance / (depth * step);
    const auto   low   = static_cast<std::size_t>(place);
    if (low + 1 >= values_.size())
      return -1. / distance;
    const double part = place - low;
    return ((1. - part) * values_[low] + part * values_[low + 1]) / depth;
  }
} // namespace vfife
