// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_study_waves_wave_fits_h
#define vfife_study_waves_wave_fits_h

#include <complex>
#include <utility>
#include <vector>

namespace vfife
{
  /** A resonance a/(x - p) + b of a complex amplitude over the speed x, p = peak + i width/2,
   * beside others whose poles are known. */
  struct ResonanceFit
  {
    double               peak       = 0; ///< in the unit of the speeds
    double               width      = 0; ///< full, where |a/(x - p)|^2 is half its largest value
    double               amplitude  = 0; ///< |a/(x - p)| at the peak
    std::complex<double> background = 0; ///< b
    std::complex<double> residue = 0, pole = 0; ///< a, p
    /** Residue and pole of each of the others. */
    std::vector<std::pair<std::complex<double>, std::complex<double>>> others;
    /** Root mean square of what the fit leaves over that of the amplitudes [-]. */
    double residual = 0;

    std::complex<double> value(double speed) const;
  };

  /**
   * Fits at least four complex amplitudes over different speeds, all of one phase reference: x w =
   * p w + b x + (a - b p) is linear in p, b and a - b p, and its least squares are weighted
   * equally. With three speeds b is taken as zero. Throws NumericalError for fewer. @p others:
   * poles near by, each of which takes up d/(x - q) more, linear as well: x w = p w + b x + c + sum
   * of d (q - p)/(x - q); as many speeds more are needed.
   */
  ResonanceFit fit_resonance(const std::vector<double>               &speeds,
                             const std::vector<std::complex<double>> &amplitudes,
                             const std::vector<std::complex<double>> &others = {});

  /** A motion that approaches its end as w(t) = end + start exp((i beat - decay) t). */
  struct BuildUpFit
  {
    double               decay = 0; ///< [1/s]
    double               beat  = 0; ///< frequency of the motion less that of its force [rad/s]
    std::complex<double> start = 0, end = 0;
    /** Root mean square of what the fit leaves over that of the samples [-]. */
    double residual = 0;

    std::complex<double> value(double time) const;
  };

  /**
   * Fits equally spaced samples, @p interval [s] from one to the next, by the end and two motions
   * (Prony's method: a linear recurrence holds for such samples exactly), of which the larger one
   * is what is said: the other one takes up what else rings when the motion starts. |beat| interval
   * must be below pi. Throws NumericalError for fewer than eight samples.
   */
  BuildUpFit fit_build_up(const std::vector<std::complex<double>> &samples, double interval);

  /** @p a and @p b of y = a x + b with the least squares, complex. Throws NumericalError for fewer
   * than two points. */
  std::pair<std::complex<double>, std::complex<double>>
  fit_line(const std::vector<std::complex<double>> &x, const std::vector<std::complex<double>> &y);
} // namespace vfife

#endif
