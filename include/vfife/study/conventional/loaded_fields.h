// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_study_conventional_loaded_fields_h
#define vfife_study_conventional_loaded_fields_h

#include <vfife/element/stress.h>
#include <vfife/model/state.h>
#include <vfife/output/observers/field_writer.h>

#include <vector>

namespace vfife
{
  class FemSpace;
  class PairEquilibrium;
  struct PairEquilibriumResult;

  /** Fields of a loaded gear pair in positions of its teeth, as those of a run. The first rank
   * writes them. */
  class LoadedFields
  {
  public:
    /** At the first position, then every so many mesh cycles as @p output says; 0: none. */
    LoadedFields(const OutputFolder &folder, const Model &model, const OutputOptions &output);

    /** After solve() of the equilibrium. @p position in mesh cycles stands for the time; @p
     * stresses by node of the model, axes of time zero. Collective. */
    void add_position(double                       position,
                      const FemSpace              &space,
                      const PairEquilibrium       &equilibrium,
                      const PairEquilibriumResult &result,
                      const std::vector<Stress>   &stresses);

  private:
    const Model &model_;
    FieldWriter  writer_;
    double       every_, next_; ///< [mesh cycles]
    State        state_;
  };
} // namespace vfife

#endif
