// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_study_waves_wave_record_h
#define vfife_study_waves_wave_record_h

#include <vfife/reduced/body_waves.h>

#include <complex>
#include <vector>

namespace vfife
{
  class ByteStream;
  struct Transmission;

  /** A speed at which a wave is driven: steps per mesh cycle, of which samples are taken. */
  struct WaveSchedule
  {
    double       speed           = 0; ///< of the driver [rad/s]
    unsigned int steps           = 0; ///< per mesh cycle
    unsigned int samples         = 0; ///< per mesh cycle, a divisor of the steps
    unsigned int settling_meshes = 0;
    unsigned int counted_meshes  = 0;

    unsigned int n_meshes() const
    {
      return settling_meshes + counted_meshes;
    }
  };

  /** The driven wave of the rim's axial motion at one speed, from the equilibrium on; complex
   * amplitudes are those of u = Re(w exp(i n alpha + i omega t)), omega the frequency of the force
   * in the turning axes, and are of one phase reference for all speeds. */
  struct WaveMotion
  {
    double                            speed     = 0; ///< of the driver [rad/s]
    double                            mesh_time = 0; ///< [s]
    std::vector<std::complex<double>> meshes; ///< means over the mesh cycles, from the first [um]
    std::complex<double>              amplitude; ///< mean over those that are counted [um]
    /** What drives the wave's harmonic: the part of the modal forces with that frequency, mean over
     * the counted meshes; empty where modes are not known. */
    Eigen::VectorXcd force;
    /** Over the counted meshes: largest distance of the wave with these diameters from what stands
     * in space [um], transmission error peak to peak [rad], largest force [N]. */
    double running = 0, pp_error = 0, largest_force = 0;
    /** Of each of StressWavePlaces::names() [MPa]: largest stress over all copies in the
     * equilibrium, which is the passage of one of them where nothing runs; that of the driven wave
     * alone, over its period. Von Mises stresses of probes, tensions of fillets. */
    std::vector<double> static_stress, wave_stress;
    double              energy_error = 0; ///< [-]

    /** Passes all but the forces. */
    void serialize(ByteStream &stream);
  };

  /** What samples of a driven pair say of its wave, in the order of time: the first one is one part
   * of a mesh cycle after the equilibrium. */
  class WaveRecord
  {
  public:
    WaveRecord(const WaveMeeting  &meeting,
               const Transmission &transmission,
               const WaveSchedule &schedule);

    /** Whether the next sample is of the counted meshes, of the last one. */
    bool counts() const
    {
      return sample_ >= schedule_.settling_meshes * schedule_.samples;
    }
    bool is_last_mesh() const
    {
      return sample_ >= (schedule_.n_meshes() - 1) * schedule_.samples;
    }
    /** exp(-i omega t) at the next sample: times a sample and averaged, its part of that frequency;
     * twice that for a wave without diameters, whose samples are real. */
    std::complex<double> turned() const;

    /** Adds a sample: wave of the rim [um], and where it counts transmission error [rad] and force
     * [N]. */
    void add(const std::complex<double> &rim, double error, double force);

    /** What all samples have said; forces, stresses and energy are not among it. */
    const WaveMotion &finish();

  private:
    double time() const;

    WaveSchedule schedule_;
    double       omega_;         ///< of the force in the turning axes, signed as the wave's [rad/s]
    double       amplitude_ = 1; ///< of turned()
    double       spin_;          ///< of what stands in space, in the turning axes [rad/s]
    WaveMotion   motion_;
    std::size_t  sample_      = 0;
    double       least_error_ = 0, largest_error_ = 0;
    std::vector<std::complex<double>> counted_; ///< in axes that stand in space
  };
} // namespace vfife

#endif
