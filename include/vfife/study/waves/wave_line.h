// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_study_waves_wave_line_h
#define vfife_study_waves_wave_line_h

#include <vfife/reduced/resonance/nearest_wave.h>
#include <vfife/study/waves/wave_fits.h>
#include <vfife/study/waves/wave_record.h>

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace vfife
{
  /** What was found where a wave was driven at and around its speed. */
  struct WaveResponse
  {
    std::string                       solver;  ///< what the pair was: "reduced", "run"
    std::vector<WaveMotion>           motions; ///< by speed, ascending
    std::vector<std::complex<double>> linear;  ///< by linear theory, at the same speeds [um]
    ResonanceFit                      curve;   ///< of the amplitudes over the driver's speed
    /** What the same fit makes of linear theory, and what one of a single resonance of both. */
    ResonanceFit linear_fit, single, linear_single;
    BuildUpFit   build_up; ///< at the speed nearest to the predicted one
    /** Amplitude at the peak of one mode under the forces at these speeds, less what the wave
     * itself makes of them [um]; no number where forces are not known. */
    double forced_peak = 0;
    /** Of each of StressWavePlaces::names() at the peak: largest stress without waves and that of
     * the wave over the first; von Mises stresses and tensions of sums are at most the sums. */
    std::vector<double> amplifications;
    std::size_t         n_probes = 0; ///< the first of these places

    /** Largest of all places; 1 without. */
    double amplification() const;
    /** Of the probes, which lie on the web, and of the fillets; no number without. */
    double web_amplification() const;
    double root_amplification() const;
    /** The motion at the speed nearest to @p speed. */
    const WaveMotion &nearest(double speed) const;
  };

  /** A speed at which a mesh order meets a wave, and what was found there. */
  struct WaveLine
  {
    WaveMeeting  meeting;
    double       speed        = 0; ///< of the driver, by the free body [rad/s]
    unsigned int driver_teeth = 0;
    double       zeta         = 0; ///< [1/s]
    /** The same by linear theory, which knows the contact: amplitudes [um] over the driver's speed.
     */
    ResonanceFit linear_curve;
    /** Of other free vibrations in contact, in the same amplitude over the driver's speed: residue
     * and pole, those that count most at the peak first. */
    std::vector<std::pair<std::complex<double>, std::complex<double>>> neighbours;
    /** By solver; what is said of the line is said by the first. */
    std::vector<WaveResponse> responses;

    /** "wave of 4 diameters against the spin at mesh order 1" */
    std::string name() const;
    double      damping_ratio() const;  ///< [-]
    double      mesh_frequency() const; ///< at the speed in contact [Hz]
    /** Poles of the neighbours that a fit over these @p speeds can tell apart. */
    std::vector<std::complex<double>> others_beside(const std::vector<double> &speeds) const;
    /** Range of the driver's speed [rad/s] in which the amplification is more than @p allowed, by
     * the resonance curve; nothing where it is nowhere. */
    std::optional<std::pair<double, double>> find_range_to_avoid(double allowed) const;
  };

  /** Evaluates what @p solver has measured at the speeds of a line: fits, amplifications.
   * @p linear: by linear theory at the same speeds [um]; @p gains: WaveDriver::rim_gains(). */
  WaveResponse evaluate_wave(const WaveLine                   &line,
                             const std::string                &solver,
                             std::vector<WaveMotion>           motions,
                             std::vector<std::complex<double>> linear,
                             const Eigen::RowVectorXcd        &gains);
} // namespace vfife

#endif
