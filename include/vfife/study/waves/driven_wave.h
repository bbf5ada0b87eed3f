// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_study_waves_driven_wave_h
#define vfife_study_waves_driven_wave_h

#include <vfife/model/model.h>
#include <vfife/reduced/body_waves.h>
#include <vfife/reduced/reduced_pair.h>

#include <array>
#include <complex>
#include <vector>

namespace vfife
{
  /** A speed at which a wave is driven: steps in a tooth mesh, of which samples are taken. */
  struct WaveSchedule
  {
    double       speed           = 0; ///< of the driver [rad/s]
    unsigned int steps           = 0; ///< in a tooth mesh
    unsigned int samples         = 0; ///< in a tooth mesh, a divisor of the steps
    unsigned int settling_meshes = 0;
    unsigned int counted_meshes  = 0;
  };

  /** The driven wave of the rim's axial motion at one speed, from the equilibrium on; complex
   * amplitudes are those of u = Re(w exp(i n alpha + i omega t)), omega the frequency of the force
   * in the turning axes, and are of one phase reference for all speeds. */
  struct WaveMotion
  {
    double                            speed     = 0; ///< of the driver [rad/s]
    double                            mesh_time = 0; ///< [s]
    std::vector<std::complex<double>> meshes; ///< means over the tooth meshes, from the first [um]
    std::complex<double>              amplitude; ///< mean over those that are counted [um]
    /** What drives the wave's harmonic: the part of the modal forces with that frequency, mean over
     * the counted meshes. */
    Eigen::VectorXcd force;
    /** Over the counted meshes: largest distance of the wave with these diameters from what stands
     * in space [um], transmission error peak to peak [rad], largest force [N]. */
    double running = 0, pp_error = 0, largest_force = 0;
    /** Of each probe [MPa]: largest von Mises stress over all copies in the equilibrium, which is
     * the passage of one of them where nothing runs; that of the driven wave alone, over its
     * period. */
    std::vector<double> static_stress, wave_stress;
    double              energy_error = 0; ///< [-]
  };

  /** Drives waves of a pair's driven body. */
  class WaveDriver
  {
  public:
    /** Both must outlive the object. */
    WaveDriver(const Model &model, ReducedPair &pair);

    /** Starts from the equilibrium at the schedule's speed. Throws NumericalError. */
    WaveMotion drive(const WaveMeeting &meeting, const WaveSchedule &schedule);

    /** Amplitudes of the rim's axial wave with @p diameters [um] of unit coordinates of its
     * harmonic. */
    Eigen::RowVectorXcd rim_gains(unsigned int diameters) const;
    /** Place of the harmonic among those of the body. */
    std::size_t find_harmonic(unsigned int diameters) const;

    /** Probes of the driven body, whose copies are looked at. */
    const std::vector<Probe> &probes() const
    {
      return probes_;
    }

  private:
    const ReducedBody   &body() const;
    std::complex<double> read_rim(unsigned int diameters);
    std::vector<double>  read_stresses() const;

    /** Complex amplitudes of the components of Stress [MPa]. */
    using WaveStresses = std::array<std::complex<double>, 6>;
    /** Adds the part of all copies' stresses that follows the sectors as a wave with @p n
     * diameters, times @p turned, by probe. */
    void add_wave_stresses(unsigned int                n,
                           const std::complex<double> &turned,
                           std::vector<WaveStresses>  &sums) const;

    const Model                    &model_;
    ReducedPair                    &pair_;
    std::vector<Probe>              probes_;
    std::vector<std::vector<Probe>> copies_; ///< by probe
  };
} // namespace vfife

#endif
