// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_study_waves_driven_wave_h
#define vfife_study_waves_driven_wave_h

#include <vfife/model/model.h>
#include <vfife/output/measures/root_stress.h>
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
    /** Of each of WaveDriver::places() [MPa]: largest stress over all copies in the equilibrium,
     * which is the passage of one of them where nothing runs; that of the driven wave alone, over
     * its period. Von Mises stresses of probes, tensions of fillets. */
    std::vector<double> static_stress, wave_stress;
    double              energy_error = 0; ///< [-]
  };

  /** Drives waves of a pair's driven body. */
  class WaveDriver
  {
  public:
    /** All must outlive the object. @p roots: whose fillets of the driven body are looked at, with
     * the readings of list_fillet_readings(), or nullptr. */
    WaveDriver(const Model &model, ReducedPair &pair, const RootStress *roots = nullptr);

    /** Starts from the equilibrium at the schedule's speed. Throws NumericalError. */
    WaveMotion drive(const WaveMeeting &meeting, const WaveSchedule &schedule);

    /** Amplitudes of the rim's axial wave with @p diameters [um] of unit coordinates of its
     * harmonic. */
    Eigen::RowVectorXcd rim_gains(unsigned int diameters) const;
    /** Place of the harmonic among those of the body. */
    std::size_t find_harmonic(unsigned int diameters) const;

    /** Where stresses are looked at, on all copies: probes of the driven body by their names, then
     * its fillets. */
    const std::vector<std::string> &places() const
    {
      return places_;
    }
    /** How many of them are probes. */
    std::size_t n_probes() const
    {
      return copies_.size();
    }

  private:
    const ReducedBody   &body() const;
    std::complex<double> read_rim(unsigned int diameters);
    std::vector<double>  read_stresses() const;

    /** Complex amplitudes of waves of stress, of the components of Stress of probes [MPa] and of
     * strain of the facets of each fillet. */
    struct WaveStresses
    {
      std::vector<std::array<std::complex<double>, 6>>              probes;
      std::vector<std::vector<std::array<std::complex<double>, 3>>> fillets;
    };
    WaveStresses no_stresses() const;
    /** Adds the part of all copies' stresses that follows the sectors as a wave with @p n
     * diameters, times @p turned. */
    void
    add_wave_stresses(unsigned int n, const std::complex<double> &turned, WaveStresses &sums) const;
    /** Largest over a period, by place. */
    std::vector<double> find_largest(const WaveStresses &stresses) const;
    /** Strains of a facet of a fillet's teeth. */
    using FacetStrains = std::function<
      void(std::size_t fillet, std::size_t facet, unsigned int tooth, const SurfaceTensor &)>;
    void read_fillets(const FacetStrains &take) const;

    const Model                      &model_;
    ReducedPair                      &pair_;
    std::vector<std::string>          places_;
    std::vector<std::vector<Probe>>   copies_;  ///< by probe
    std::vector<const MemberFillet *> fillets_; ///< of the driven body
  };
} // namespace vfife

#endif
