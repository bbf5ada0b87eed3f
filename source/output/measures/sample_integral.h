// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_output_measures_sample_integral_h
#define vfife_output_measures_sample_integral_h

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace vfife
{
  /** Integral over the row index of the samples joined by straight lines. */
  class SampleIntegral
  {
  public:
    /** @p samples: two or more */
    explicit SampleIntegral(std::vector<double> samples)
      : samples_(std::move(samples))
      , sums_(samples_.size(), 0.)
    {
      for (std::size_t i = 1; i < samples_.size(); ++i)
        sums_[i] = sums_[i - 1] + 0.5 * (samples_[i - 1] + samples_[i]);
    }

    /** Mean between two row indices, which need not be whole. */
    double mean(const double begin, const double end) const
    {
      return (integral(end) - integral(begin)) / (end - begin);
    }

  private:
    double integral(const double row) const
    {
      const std::size_t i = std::min(static_cast<std::size_t>(row), samples_.size() - 2);
      // The trapezoidal rule up to a place between two samples.
      const double s = row - static_cast<double>(i);
      return sums_[i] + s * (samples_[i] + 0.5 * s * (samples_[i + 1] - samples_[i]));
    }

    std::vector<double> samples_, sums_;
  };

  /** Largest less smallest of the whole samples between two row indices, its ends included to
   * round-off. */
  inline double
  compute_peak_to_peak(const std::vector<double> &samples, const double begin, const double end)
  {
    const auto at = [&samples](const double row) {
      return samples.begin() + static_cast<std::ptrdiff_t>(row);
    };
    const auto range =
      std::minmax_element(at(std::ceil(begin - 1e-6)), at(std::floor(end + 1e-6)) + 1);
    return *range.second - *range.first;
  }
} // namespace vfife

#endif
