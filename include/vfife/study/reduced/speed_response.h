// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_study_reduced_speed_response_h
#define vfife_study_reduced_speed_response_h

#include <vfife/lumped/lumped_solver.h>

#include <complex>
#include <utility>
#include <vector>

namespace vfife
{
  /** What a pair shows at one instant of a sweep over speed. */
  struct SpeedSample
  {
    double error = 0;     ///< of the transmission [rad]
    double force = 0;     ///< sum of the tooth pairs' [N]
    bool   coast = false; ///< whether coast flanks touch
    /** By number of diameters from 1 on, of the rim's axial motion in space [um]. */
    std::vector<std::complex<double>> waves;
    std::vector<double>
      stresses; ///< of StressWavePlaces::names(), the largest of all sectors [MPa]
  };

  /**
   * Equal samples of whole periods without what they have above @p highest periods in the record:
   * its mean and its first Fourier terms. The same where the samples have no more.
   */
  std::vector<double> cut_spectrum(const std::vector<double> &samples, std::size_t highest);

  /**
   * What a pair does at one speed, from equal samples of whole tooth meshes. Forces and stresses
   * are those below a frequency: modes near the cut-off of reduced bodies are not the bodies' own.
   */
  class SpeedResponse
  {
  public:
    /** Waves of the rim with 1 to this many diameters are followed. */
    static constexpr unsigned int largest_wave = 6;

    /** @p highest: vibrations in the record of forces and stresses that are looked at. */
    explicit SpeedResponse(const std::size_t highest)
      : highest_(highest)
    {
    }

    void add(SpeedSample sample);

    LumpedResponse response(double energy_error) const;
    /** Of a wave: what stands in space, and the largest distance from it [um]. */
    std::pair<double, double> wave(unsigned int n) const;
    /** Of a place the largest stress of all samples [MPa]. */
    double largest_stress(std::size_t place) const;

  private:
    std::size_t              highest_;
    std::vector<SpeedSample> samples_;
  };
} // namespace vfife

#endif
