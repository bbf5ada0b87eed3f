// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/types.h>
#include <vfife/study/compare/spectrum_lines.h>

#include <boost/math/tools/minima.hpp>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numeric>

namespace vfife
{
  namespace
  {
    /** The windowed signal's spectrum at any frequency. */
    class Spectrum
    {
    public:
      Spectrum(const std::vector<double> &time, const std::vector<double> &signal)
        : step_((time.back() - time.front()) / (time.size() - 1))
        , weighted_(signal)
      {
        // Twice Hann's window, w_i = 1 - cos(2 pi i/(n - 1)): the factor cancels. The mean is the
        // one that the window sees, so that nothing of it leaks into the lowest lines.
        const std::size_t   n = signal.size();
        std::vector<double> window(n);
        for (std::size_t i = 0; i < n; ++i)
          window[i] = 1 - std::cos(2 * pi * i / (n - 1));
        sum_ = std::accumulate(window.begin(), window.end(), 0.);
        const double mean =
          std::inner_product(window.begin(), window.end(), signal.begin(), 0.) / sum_;
        for (std::size_t i = 0; i < n; ++i)
          weighted_[i] = window[i] * (signal[i] - mean);
      }

      /** 2 |sum w x exp(-2 pi i f t)|/sum w: a sine's own amplitude at its frequency. */
      double amplitude(const double frequency) const
      {
        // At any frequency and not on the grid of a fast transform: a line between its points keeps
        // its height.
        const std::complex<double> turn = std::polar(1., -2 * pi * frequency * step_);
        std::complex<double>       sum = 0, phase = 1;
        for (const double value : weighted_)
          {
            sum += value * phase;
            phase *= turn;
          }
        return 2 * std::abs(sum) / sum_;
      }

      /** The maximum between two frequencies. */
      double find_peak(const double low, const double high) const
      {
        constexpr int bits = 21; // of the frequency: 5e-7
        return boost::math::tools::brent_find_minima(
                 [this](const double f) { return -amplitude(f); }, low, high, bits)
          .first;
      }

      double step() const
      {
        return step_;
      }

    private:
      double              step_, sum_ = 0;
      std::vector<double> weighted_;
    };
  } // namespace

  std::vector<SpectrumLine> find_spectrum_lines(const std::vector<double> &time,
                                                const std::vector<double> &signal,
                                                const double               highest,
                                                const double               least)
  {
    std::vector<SpectrumLine> lines;
    if (time.size() < 8)
      return lines;
    // 1. A grid of a quarter of 1/T, up to half the sampling rate: the main lobe of a line is 4/T
    // wide, so no line falls between. A maximum needs both neighbours: the first can be at 1.5/T.
    const Spectrum      spectrum(time, signal);
    const double        length = time.back() - time.front();
    const double        grid = .25 / length, end = std::min(highest, .5 / spectrum.step());
    std::vector<double> frequencies, amplitudes;
    for (double f = 1.25 / length; f < end; f += grid)
      {
        frequencies.push_back(f);
        amplitudes.push_back(spectrum.amplitude(f));
      }
    // 2. Maxima of the grid, refined between their neighbours.
    for (std::size_t i = 1; i + 1 < amplitudes.size(); ++i)
      if (amplitudes[i] >= amplitudes[i - 1] && amplitudes[i] > amplitudes[i + 1])
        {
          const double peak = spectrum.find_peak(frequencies[i - 1], frequencies[i + 1]);
          lines.push_back({peak, spectrum.amplitude(peak)});
        }
    // 3. The strongest first; what is weak beside it may be a side lobe.
    std::sort(lines.begin(), lines.end(), [](const SpectrumLine &a, const SpectrumLine &b) {
      return a.amplitude > b.amplitude;
    });
    while (!lines.empty() && lines.back().amplitude < least * lines.front().amplitude)
      lines.pop_back();
    return lines;
  }
} // namespace vfife
