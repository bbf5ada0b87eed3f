// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_study_reduced_speed_response_h
#define vfife_study_reduced_speed_response_h

#include <vfife/base/text/table.h>
#include <vfife/lumped/lumped_solver.h>

#include <complex>
#include <functional>
#include <string>
#include <vector>

namespace vfife
{
  class Log;
  class ReducedPair;
  struct Model;
  struct ReducedOptions;
  struct SpeedSweepOptions;

  /** What a pair does at one speed, from equal samples of whole tooth meshes. */
  class SpeedResponse
  {
  public:
    /** Waves of the rim with 1 to this many diameters are followed. */
    static constexpr unsigned int largest_wave = 6;

    /** @p error: transmission error [rad]; @p force: sum of the tooth pairs' [N]; @p coast: whether
     * coast flanks touch; @p waves: by number of diameters from 1 on, of the rim's axial motion in
     * space [um]. */
    void
    add(double error, double force, bool coast, const std::vector<std::complex<double>> &waves);

    LumpedResponse response(double energy_error) const;
    /** Of a wave: what stands in space, and the largest distance from it [um]. */
    std::pair<double, double> wave(unsigned int n) const;

  private:
    std::vector<double>                            errors_, forces_;
    std::vector<std::vector<std::complex<double>>> waves_;
    unsigned int                                   n_coast_ = 0;
  };

  /** Columns of wave_response.csv. */
  Table make_wave_response_table();

  /**
   * Turns @p pair, which has found its equilibrium, at all speeds of the passes of @p sweep, each
   * from the motion at the one before: rows of resonance.csv and wave_response.csv. @p samples: in
   * a tooth mesh. @p report is called after each speed. Throws NumericalError.
   */
  void sweep_speeds(const Model                 &model,
                    const ReducedOptions        &options,
                    double                       cutoff,
                    const SpeedSweepOptions     &sweep,
                    unsigned int                 samples,
                    ReducedPair                 &pair,
                    Table                       &resonance,
                    Table                       &waves,
                    const std::function<void()> &report,
                    Log                         &log);
} // namespace vfife

#endif
