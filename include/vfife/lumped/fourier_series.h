// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_lumped_fourier_series_h
#define vfife_lumped_fourier_series_h

#include <cmath>
#include <vector>

namespace vfife
{
  /**
   * mean + sum over n = 1, 2... of cosine_n cos(2 pi n x) + sine_n sin(2 pi n x): something that
   * repeats with every mesh cycle, x the position in mesh cycles.
   */
  class FourierSeries
  {
  public:
    FourierSeries(double mean = 0);
    FourierSeries(double mean, std::vector<double> cosines, std::vector<double> sines);

    /** The trigonometric interpolation of samples at x = 0, 1/N, ... (N - 1)/N. */
    static FourierSeries interpolate(const std::vector<double> &samples);

    double mean() const
    {
      return mean_;
    }
    /** Highest harmonic. */
    std::size_t n_harmonics() const
    {
      return cosines_.size();
    }
    /** Of harmonic @p n = 1, 2..., at most n_harmonics(). */
    double amplitude(std::size_t n) const
    {
      return std::hypot(cosines_[n - 1], sines_[n - 1]);
    }
    double value(double x) const;
    /** Derivative with respect to x. */
    double slope(double x) const;

  private:
    double              mean_;
    std::vector<double> cosines_, sines_; ///< of equal length
  };
} // namespace vfife

#endif
