// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_study_compare_spectrum_lines_h
#define vfife_study_compare_spectrum_lines_h

#include <vector>

namespace vfife
{
  /** A vibration of one frequency within a history. */
  struct SpectrumLine
  {
    double frequency = 0; ///< [Hz]
    double amplitude = 0; ///< in the unit of the history
  };

  /**
   * Maxima of the spectrum of equally spaced samples, under Hann's window and without their mean,
   * from 1.5/T (T the length of the record) to @p highest [Hz], the strongest first. Maxima below
   * @p least times the strongest are left out: side lobes of the window are below 3 %. Lines closer
   * than 2/T are one.
   */
  std::vector<SpectrumLine> find_spectrum_lines(const std::vector<double> &time,
                                                const std::vector<double> &signal,
                                                double                     highest,
                                                double                     least);
} // namespace vfife

#endif
