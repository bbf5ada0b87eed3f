// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_study_stress_waves_stress_wave_places_h
#define vfife_study_stress_waves_stress_wave_places_h

#include <vfife/model/model.h>
#include <vfife/model/state.h>
#include <vfife/output/measures/root_stress.h>

#include <array>
#include <complex>
#include <functional>
#include <string>
#include <vector>

namespace vfife
{
  /** What probes like those of the model show now, in a run collective. */
  using ProbeMeasure = std::function<std::vector<ProbeValue>(const std::vector<Probe> &)>;

  /**
   * The parts of the stresses of one instant that follow the sectors of the driven body as a wave
   * with n nodal diameters: sector k has Re(w exp(i n k alpha)), alpha the angle of a sector.
   */
  struct StressWaves
  {
    using OfProbe = std::array<std::complex<double>, 6>; ///< ProbeValue::stress [MPa]
    using OfFacet = std::array<std::complex<double>, 3>; ///< strain in the axes of FacetStrain [-]

    std::vector<OfProbe>              probes;
    std::vector<std::vector<OfFacet>> fillets; ///< by fillet and facet, rows of a column together

    /** Adds other ones times @p factor. */
    void add(const StressWaves &other, const std::complex<double> &factor);
  };

  /** Where a driven body's stresses are looked at in all its sectors: its probes, and the facets of
   * its fillets. */
  class StressWavePlaces
  {
  public:
    /** @p roots: whose fillets are looked at, or nullptr; both must outlive the object. Throws
     * InputError for probes without copies in all sectors. */
    explicit StressWavePlaces(const Model &model, const RootStress *roots = nullptr);

    /** Probes by their names, then fillets ("concave fillet"). */
    const std::vector<std::string> &names() const
    {
      return names_;
    }
    std::size_t n_probes() const
    {
      return copies_.size();
    }
    const std::vector<const MemberFillet *> &fillets() const
    {
      return fillets_;
    }

    /** Without any amplitude. */
    StressWaves none() const;
    /** Those with @p n diameters now. What is not given, stresses of probes or strains of fillets,
     * has no amplitudes. */
    StressWaves
    measure(unsigned int n, const ProbeMeasure &probes, const FilletStrains *strains) const;

    /** Von Mises stress of each probe, the largest of its copies now [MPa]. */
    std::vector<double> measure_probes(const ProbeMeasure &probes) const;
    /** Tensions at the facets of one of the fillets, the largest of all teeth now [MPa]. */
    std::vector<double> measure_tensions(std::size_t fillet, const FilletStrains &strains) const;

    /** A row a sector: ProbeValue::stress of each probe's copy there [MPa], then the strains of
     * each facet of its tooth's fillets, which @p strains are of (nullptr: 0). */
    Eigen::MatrixXd read(const ProbeMeasure &probes, const FilletStrains *strains) const;
    /** Of each place of names() the largest of all sectors in what read() has, or in sums of such
     * [MPa]: von Mises stress of a probe, tension at all facets of a fillet. */
    std::vector<double> find_largest(const Eigen::MatrixXd &read) const;
    /** The same of what there is now. */
    std::vector<double> measure_largest(const ProbeMeasure  &probes,
                                        const FilletStrains *strains) const
    {
      return find_largest(read(probes, strains));
    }

    /** Of each place of names() the largest over a period of waves whose amplitudes go as exp(i
     * omega t) [MPa]: von Mises stress of a probe, tension at the facets of a fillet. */
    std::vector<double> find_largest(const StressWaves &waves) const;

  private:
    using TakeFacet =
      std::function<void(std::size_t facet, unsigned int tooth, const SurfaceTensor &strain)>;
    static void
    for_each_facet(const MemberFillet &member, const FilletStrains &strains, const TakeFacet &take);

    unsigned int                      driven_;
    const BodyStructure              &structure_;
    std::vector<std::string>          names_;
    std::vector<std::vector<Probe>>   copies_; ///< by probe
    std::vector<const MemberFillet *> fillets_;
  };
} // namespace vfife

#endif
