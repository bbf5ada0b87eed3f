// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_study_conventional_loaded_pattern_h
#define vfife_study_conventional_loaded_pattern_h

#include <vfife/output/files/figures.h>
#include <vfife/output/measures/contact_pattern.h>

#include <string>
#include <vector>

namespace vfife
{
  class GearPair;
  struct BlankOutline;
  struct PairEquilibriumResult;

  /** Where a point of a flank at radius and height @p r_z [mm] of its body frame is: along the face
   * from the mean cone distance, > 0 to the heel, and along the profile from the pitch cone, > 0 to
   * the tip [mm]. */
  Vector2 place_on_flank(const BlankOutline &blank, const Vector2 &r_z);

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
    NamedFigures figures(const GearPair &pair, const std::string &side) const;

  private:
    const Model        &model_;
    ContactPattern      pattern_;
    std::vector<double> forces_; ///< of a position, by node of the model [N]
  };
} // namespace vfife

#endif
