// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/types.h>
#include <vfife/study/waves/wave_line.h>

#include <algorithm>
#include <cmath>

namespace vfife
{
  namespace
  {
    /** Of the amplitude at the peak: what others add less to is left to the background. */
    constexpr double counting_part = .01;
  } // namespace

  std::string WaveLine::name() const
  {
    const BodyWave   &wave = meeting.wave;
    const std::string met  = " at mesh order " + std::to_string(meeting.mesh_order);
    if (wave.diameters == 0)
      return "vibration without diameters" +
             (wave.order > 1 ? " (order " + std::to_string(wave.order) + ")" : "") + met;
    return "wave of " + std::to_string(wave.diameters) +
           (wave.diameters == 1 ? " diameter " : " diameters ") +
           (wave.order > 1 ? "(order " + std::to_string(wave.order) + ") " : "") +
           (wave.direction == WaveDirection::forward ? "with" : "against") + " the spin" + met;
  }

  double WaveLine::damping_ratio() const
  {
    return meeting.wave.damping_ratio(zeta);
  }

  double WaveLine::mesh_frequency() const
  {
    return linear_curve.peak * driver_teeth / (2. * pi);
  }

  double WaveResponse::amplification() const
  {
    double largest = 1;
    for (const double amplification : amplifications)
      largest = std::max(largest, amplification);
    return largest;
  }

  double WaveResponse::web_amplification() const
  {
    return n_probes == 0
             ? not_known
             : *std::max_element(amplifications.begin(), amplifications.begin() + n_probes);
  }

  double WaveResponse::root_amplification() const
  {
    return n_probes == amplifications.size()
             ? not_known
             : *std::max_element(amplifications.begin() + n_probes, amplifications.end());
  }

  const WaveMotion &WaveResponse::nearest(const double speed) const
  {
    return *std::min_element(motions.begin(),
                             motions.end(),
                             [speed](const WaveMotion &a, const WaveMotion &b) {
                               return std::abs(a.speed - speed) < std::abs(b.speed - speed);
                             });
  }

  std::optional<std::pair<double, double>> WaveLine::find_range_to_avoid(const double allowed) const
  {
    if (responses.empty())
      return {};
    // What the wave adds falls as the resonance curve: (A - 1)/sqrt(1 + (2 d/width)^2).
    const ResonanceFit &curve  = responses.front().curve;
    const double        excess = (responses.front().amplification() - 1.) / (allowed - 1.);
    if (!(excess > 1))
      return {};
    const double distance = .5 * curve.width * std::sqrt(excess * excess - 1.);
    return std::make_pair(curve.peak - distance, curve.peak + distance);
  }

  std::vector<Complex> WaveLine::others_beside(const std::vector<double> &speeds) const
  {
    // One speed more than numbers sought is left for the misfit.
    const std::size_t    least = 5;
    std::vector<Complex> poles;
    for (const auto &[residue, pole] : neighbours)
      {
        const double part = std::abs(residue / (linear_curve.peak - pole)) / linear_curve.amplitude;
        if (part > counting_part && poles.size() + least < speeds.size())
          poles.push_back(pole);
      }
    return poles;
  }

  namespace
  {
    /** Amplitude at the peak of the linear theory of one mode under the forces at all speeds: what
     * the wave itself makes of them is in proportion to it and moves the peak; the rest drives it.
     */
    double find_forced_peak(const WaveLine                &line,
                            const std::vector<WaveMotion> &motions,
                            const ResonanceFit            &curve,
                            const Complex                 &gain)
    {
      std::vector<Complex> waves, forces;
      for (const WaveMotion &motion : motions)
        {
          if (motion.force.size() == 0)
            return not_known;
          waves.push_back(motion.amplitude - curve.background);
          forces.push_back(line.meeting.wave.shape.dot(motion.force));
        }
      const Complex drive = fit_line(waves, forces).second;
      const double  omega = line.meeting.wave.frequency() * curve.peak / line.speed;
      return std::abs(gain * drive) / (line.zeta * omega);
    }

    /** Of the fitted amplitude between the speeds, all resonances together: parts of lines that are
     * nearer than their widths may be far larger than their sum. */
    double find_largest(const ResonanceFit &curve, const std::vector<double> &speeds)
    {
      constexpr unsigned int n_points = 1000;
      double                 largest  = 0;
      for (unsigned int k = 0; k <= n_points; ++k)
        {
          const double part = double(k) / n_points;
          largest =
            std::max(largest,
                     std::abs(curve.value((1. - part) * speeds.front() + part * speeds.back())));
        }
      return largest;
    }
  } // namespace

  WaveResponse evaluate_wave(const WaveLine            &line,
                             const std::string         &solver,
                             std::vector<WaveMotion>    motions,
                             std::vector<Complex>       linear,
                             const Eigen::RowVectorXcd &gains)
  {
    WaveResponse        found;
    std::vector<double> speeds;
    found.solver = solver;
    std::vector<Complex> amplitudes;
    for (const WaveMotion &motion : motions)
      {
        speeds.push_back(motion.speed);
        amplitudes.push_back(motion.amplitude);
      }
    const std::vector<Complex> others = line.others_beside(speeds);
    found.curve                       = fit_resonance(speeds, amplitudes, others);
    found.linear_fit                  = fit_resonance(speeds, linear, others);
    found.single                      = fit_resonance(speeds, amplitudes);
    found.linear_single               = fit_resonance(speeds, linear);
    found.linear                      = std::move(linear);
    found.forced_peak =
      find_forced_peak(line, motions, found.curve, (gains * line.meeting.wave.shape)(0));

    const WaveMotion &largest =
      *std::max_element(motions.begin(), motions.end(), [](const auto &a, const auto &b) {
        return std::abs(a.amplitude) < std::abs(b.amplitude);
      });
    const double to_peak = find_largest(found.curve, speeds) / std::abs(largest.amplitude);
    for (std::size_t p = 0; p < largest.static_stress.size(); ++p)
      found.amplifications.push_back(1. +
                                     to_peak * largest.wave_stress[p] / largest.static_stress[p]);
    found.motions          = std::move(motions);
    const WaveMotion &near = found.nearest(line.linear_curve.peak);
    found.build_up         = fit_build_up(near.meshes, near.mesh_time);
    return found;
  }
} // namespace vfife
