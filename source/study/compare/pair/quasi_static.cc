// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/text/column_names.h>
#include <vfife/lumped/fourier_series.h>
#include <vfife/study/compare/pair/quasi_static.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace vfife
{
  TurningModes::TurningModes(const Table &coupled_modes, const double least)
  {
    const std::vector<std::string> &axes = coupled_modes.column(column::axes).texts;
    // A pair that spins is seen from space; one at rest has modes in its own axes alone.
    const bool standing = std::count(axes.begin(), axes.end(), axes_of_modes::fixed) > 0;
    for (std::size_t i = 0; i < coupled_modes.n_rows(); ++i)
      {
        const double share = coupled_modes.numbers(column::share_of_static_rotation)[i];
        if (share > least && (!standing || axes[i] == axes_of_modes::fixed))
          {
            frequencies.push_back(coupled_modes.numbers(column::frequency)[i]);
            shares.push_back(share);
          }
      }
  }

  std::vector<std::optional<double>> compute_mean_mesh(const std::vector<double> &time,
                                                       const std::vector<double> &values,
                                                       const double               mesh_frequency,
                                                       const std::vector<double> &positions)
  {
    std::vector<std::optional<double>> means;
    for (const double position : positions)
      {
        double       sum = 0;
        unsigned int n   = 0;
        for (std::size_t i = 0; i + 1 < time.size(); ++i)
          {
            // In mesh cycles from the position: the mesh is there where this is a whole number,
            // and there is one between the samples where ceil(here) < next.
            const double here = time[i] * mesh_frequency - position;
            const double next = time[i + 1] * mesh_frequency - position;
            // Samples lie on positions up to round-off: the next sample is the first beyond.
            const double whole = std::ceil(here - 1e-6);
            if (whole >= next - 1e-6)
              continue;
            sum += values[i] + (values[i + 1] - values[i]) * (whole - here) / (next - here);
            ++n;
          }
        means.push_back(n > 0 ? std::optional<double>(sum / n) : std::nullopt);
      }
    return means;
  }

  double estimate_swing(const std::vector<double> &curve,
                        const double               mesh_frequency,
                        const TurningModes        &modes)
  {
    // Below, a harmonic is round-off, which the swing would raise to anything at resonance.
    constexpr double least_part = 1e-12;
    const double     largest =
      std::accumulate(curve.begin(), curve.end(), 0., [](const double most, const double value) {
        return std::max(most, std::abs(value));
      });
    // The static curve over a mesh cycle by harmonics: the modes are driven by each of them.
    const FourierSeries series    = FourierSeries::interpolate(curve);
    double              departure = 0;
    // Without damping a mode follows harmonic k with 1/(1 - r^2); less the 1 of the static curve
    // that is r^2/(1 - r^2). Modes are in phase or opposite, so their shares add up with signs;
    // phases of the harmonics are left open, so magnitudes are added.
    for (std::size_t k = 1; k <= series.n_harmonics(); ++k)
      {
        if (series.amplitude(k) < least_part * largest)
          continue;
        double amplification = 0;
        for (std::size_t i = 0; i < modes.frequencies.size(); ++i)
          {
            const double r = k * mesh_frequency / modes.frequencies[i];
            amplification += modes.shares[i] * r * r / (1. - r * r);
          }
        departure += series.amplitude(k) * std::abs(amplification);
      }
    return departure;
  }
} // namespace vfife
