// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/types.h>
#include <vfife/lumped/fourier_series.h>

#include <algorithm>

namespace vfife
{
  FourierSeries::FourierSeries(const double mean)
    : mean_(mean)
  {
  }

  FourierSeries::FourierSeries(const double        mean,
                               std::vector<double> cosines,
                               std::vector<double> sines)
    : mean_(mean)
    , cosines_(std::move(cosines))
    , sines_(std::move(sines))
  {
    // Either list may be shorter: what it does not have is zero.
    const std::size_t n = std::max(cosines_.size(), sines_.size());
    cosines_.resize(n, 0.);
    sines_.resize(n, 0.);
  }

  FourierSeries FourierSeries::interpolate(const std::vector<double> &samples)
  {
    const std::size_t   N    = samples.size();
    double              mean = 0;
    std::vector<double> cosines(N / 2, 0.), sines(N / 2, 0.);
    for (std::size_t i = 0; i < N; ++i)
      {
        mean += samples[i] / N;
        for (std::size_t n = 1; n <= N / 2; ++n)
          {
            // The highest harmonic of an even number of samples has a cosine only.
            const bool last = 2 * n == N;
            // c_n = 2/N sum_i f_i cos(2 pi n i/N), s_n alike; n i is taken modulo N, which keeps
            // angles small and exact.
            const double angle = 2 * pi * ((n * i) % N) / N;
            cosines[n - 1] += (last ? 1. : 2.) * samples[i] * std::cos(angle) / N;
            sines[n - 1] += last ? 0. : 2. * samples[i] * std::sin(angle) / N;
          }
      }
    return FourierSeries(mean, cosines, sines);
  }

  double FourierSeries::value(const double x) const
  {
    double sum = mean_;
    for (std::size_t n = 1; n <= cosines_.size(); ++n)
      sum += cosines_[n - 1] * std::cos(2 * pi * n * x) + sines_[n - 1] * std::sin(2 * pi * n * x);
    return sum;
  }

  double FourierSeries::slope(const double x) const
  {
    double sum = 0;
    for (std::size_t n = 1; n <= cosines_.size(); ++n)
      sum +=
        2 * pi * n *
        (sines_[n - 1] * std::cos(2 * pi * n * x) - cosines_[n - 1] * std::sin(2 * pi * n * x));
    return sum;
  }
} // namespace vfife
