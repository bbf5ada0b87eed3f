// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_study_conventional_loaded_pattern_h
#define vfife_study_conventional_loaded_pattern_h

#include <vfife/gear/blank_outline.h>
#include <vfife/output/files/figures.h>
#include <vfife/output/measures/contact_pattern.h>

#include <array>
#include <string>
#include <vector>

namespace vfife
{
  struct PairEquilibriumResult;

  /** The contact pattern over the positions of a loaded tooth contact analysis. */
  class LoadedPattern
  {
  public:
    /** The model must outlive this. */
    explicit LoadedPattern(const Model &model);

    void add_position(const PairEquilibriumResult &result);

    /** Rows of pattern.csv, as of a run. */
    Table table() const;

    /** Of the flanks of @p side (ContactPair::side) of both members of the model's pair where the
     * pattern's centre lies, as place_on_flank(). */
    NamedFigures figures(const std::array<BlankOutline, 2> &outlines,
                         const std::string                 &side) const;

  private:
    const Model        &model_;
    ContactPattern      pattern_;
    std::vector<double> forces_; ///< of a position, by node of the model [N]
  };
} // namespace vfife

#endif
