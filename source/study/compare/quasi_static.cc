// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/types.h>
#include <vfife/study/compare/quasi_static.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numeric>

namespace vfife
{
  TurningModes::TurningModes(const Table &coupled_modes, const double least)
  {
    const std::vector<std::string> &axes     = coupled_modes.columns().front().texts;
    const bool                      standing = std::count(axes.begin(), axes.end(), "standing") > 0;
    for (std::size_t i = 0; i < coupled_modes.n_rows(); ++i)
      {
        const double share = coupled_modes.numbers("share of the static turn")[i];
        if (share > least && (!standing || axes[i] == "standing"))
          {
            frequencies.push_back(coupled_modes.numbers("frequency")[i]);
            shares.push_back(share);
          }
      }
  }

  double estimate_swing(const std::vector<double> &positions,
                        const std::vector<double> &curve,
                        const double               mesh_frequency,
                        const TurningModes        &modes)
  {
    // Below, a harmonic is round-off, which the swing would raise to anything at resonance.
    constexpr double least_part = 1e-12;
    const double     largest =
      std::accumulate(curve.begin(), curve.end(), 0., [](const double most, const double value) {
        return std::max(most, std::abs(value));
      });
    const std::size_t n         = positions.size();
    double            departure = 0;
    for (unsigned int k = 1; 2 * k <= n; ++k)
      {
        std::complex<double> sum = 0;
        for (std::size_t j = 0; j < n; ++j)
          sum += curve[j] * std::polar(1., -2 * pi * k * positions[j]);
        const double amplitude = std::abs(sum) * (2 * k == n ? 1. : 2.) / n;
        if (amplitude < least_part * largest)
          continue;

        double amplification = 0;
        for (std::size_t i = 0; i < modes.frequencies.size(); ++i)
          {
            const double r = k * mesh_frequency / modes.frequencies[i];
            amplification += modes.shares[i] * r * r / (1. - r * r);
          }
        departure += amplitude * std::abs(amplification);
      }
    return departure;
  }
} // namespace vfife
