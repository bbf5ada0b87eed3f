// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_study_reduced_speed_response_h
#define vfife_study_reduced_speed_response_h

#include <vfife/lumped/lumped_solver.h>
#include <vfife/study/reduced/low_pass.h>

#include <Eigen/Core>

#include <array>
#include <complex>
#include <deque>
#include <functional>
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
    /** As StressWavePlaces::read() has them: without vibration at this position of the mesh cycle,
     * and what there is beyond. */
    Eigen::MatrixXd slow_stresses, vibration;
  };

  /**
   * What a pair does at one speed, from equal samples of whole mesh cycles. Transmission errors,
   * forces and vibrations of stresses are those below a frequency: modes near the cut-off of
   * reduced bodies are not the bodies' own.
   */
  class SpeedResponse
  {
  public:
    /** Waves of the rim with 1 to this many diameters are followed. */
    static constexpr unsigned int largest_wave = 6;

    /** Of each place the largest of stresses of one instant. */
    using FindLargest = std::function<std::vector<double>(const Eigen::MatrixXd &)>;

    SpeedResponse(LowPass low_pass, FindLargest find_largest);

    /** Samples that have to be added before those that count, and after them. */
    unsigned int n_around() const
    {
      return low_pass_.reach();
    }

    void add(SpeedSample sample);

    LumpedResponse response(double energy_error) const;
    /** Transmission errors of the samples that count, with all their vibrations [rad]. */
    const std::vector<double> &errors() const
    {
      return errors_;
    }
    /** Of a wave: what stands in space, and the largest distance from it [um]. */
    std::pair<double, double> wave(unsigned int n) const;
    /** Of a place the largest stress of all samples [MPa]. */
    double largest_stress(std::size_t place) const;

  private:
    /** Counts a sample whose transmission error, force and vibration of stresses, one after the
     * other, are @p slow. */
    void count(SpeedSample sample, const Eigen::VectorXd &slow);

    LowPass                 low_pass_;
    FindLargest             find_largest_;
    std::deque<SpeedSample> waiting_; ///< for those after them
    std::vector<double>     errors_, slow_errors_, forces_, slow_forces_;
    std::size_t             n_coast_ = 0;
    std::array<std::vector<std::complex<double>>, largest_wave> waves_;
    std::vector<double>                                         largest_stresses_; ///< by place
  };
} // namespace vfife

#endif
