// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_study_conventional_loaded_fillets_h
#define vfife_study_conventional_loaded_fillets_h

#include <vfife/output/files/figures.h>
#include <vfife/output/measures/root_stress.h>
#include <vfife/study/conventional/fillet_faces.h>

#include <memory>

namespace vfife
{
  class Log;
  class OutputFolder;
  struct PairEquilibriumResult;

  /** Root stresses and gauges of a loaded tooth contact analysis: root_stress.csv, gauges.csv,
   * fillet_envelope.csv, root_sections.csv. */
  class LoadedFillets
  {
  public:
    /** As RootStress. */
    LoadedFillets(const Model &model, const FilletOptions &options);

    /** At a position [mesh cycles]; all of one space. */
    void add_position(const FemSpace &space, double position, const PairEquilibriumResult &result);

    /** Says the largest stresses and writes what there is. */
    void write(const OutputFolder &folder, Log &log) const;

    NamedFigures list_figures() const;

  private:
    const Model                    &model_;
    SampleColumns<RootStressSample> stress_columns_;
    SampleColumns<GaugeSample>      gauge_columns_;
    RootStress                      stress_;
    std::unique_ptr<FilletFaces>    faces_; ///< of the space of the first position
    Table                           stresses_, gauges_;
  };
} // namespace vfife

#endif
