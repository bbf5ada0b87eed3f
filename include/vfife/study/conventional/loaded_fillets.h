// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_study_conventional_loaded_fillets_h
#define vfife_study_conventional_loaded_fillets_h

#include <vfife/output/files/figures.h>
#include <vfife/output/measures/root_stress.h>
#include <vfife/study/fillets/fillet_faces.h>
#include <vfife/study/fillets/root_submodels.h>

#include <map>
#include <memory>
#include <string>

namespace vfife
{
  class Log;
  class OutputFolder;
  class PairEquilibrium;
  struct PairEquilibriumResult;
  struct ToothPressure;

  /** Root stresses and gauges of a loaded tooth contact analysis: root_stress.csv, gauges.csv,
   * fillet_envelope.csv, root_sections.csv. */
  class LoadedFillets
  {
  public:
    /** As RootStress. @p submodels: of the model; without them the model's own elements are read.
     * @p spins: whether displacements have centrifugal parts. */
    LoadedFillets(const Model                         &model,
                  const FilletOptions                 &options,
                  std::unique_ptr<const RootSubmodels> submodels,
                  bool                                 spins);

    /** At the last position of @p equilibrium [mesh cycles]; all of one space. @p pressures: on
     * grids of their own, by which the flanks of submodels are loaded; empty: by the nodal forces.
     */
    void add_position(const FemSpace                   &space,
                      double                            position,
                      const PairEquilibrium            &equilibrium,
                      const PairEquilibriumResult      &result,
                      const std::vector<ToothPressure> &pressures);

    /** Says the largest stresses and writes what there is. */
    void write(const OutputFolder &folder, Log &log) const;

    NamedFigures list_figures() const;

  private:
    FilletStrains follow(const FemSpace                   &space,
                         const PairEquilibrium            &equilibrium,
                         const PairEquilibriumResult      &result,
                         const std::vector<ToothPressure> &pressures) const;

    const Model                         &model_;
    SampleColumns<RootStressSample>      stress_columns_;
    SampleColumns<GaugeSample>           gauge_columns_;
    std::unique_ptr<const RootSubmodels> submodels_;
    bool                                 spins_;
    RootStress                           stress_;
    std::unique_ptr<FilletFaces>         faces_; ///< of the space of the first position
    Table                                stresses_, gauges_;
    std::map<std::string, RootExtreme>   largest_; ///< root tension by body
  };
} // namespace vfife

#endif
