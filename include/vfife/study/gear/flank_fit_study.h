// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_study_gear_flank_fit_study_h
#define vfife_study_gear_flank_fit_study_h

#include <vfife/gear/driving.h>
#include <vfife/gear/measurement/measuring_grid.h>
#include <vfife/study/study_kind.h>

#include <memory>
#include <string>
#include <vector>

namespace vfife
{
  /** Section Flank fit. */
  struct FlankFitOptions
  {
    DrivingMember            member = DrivingMember::pinion;
    FlankSide                side   = FlankSide::concave;
    std::string              measured; ///< file; empty: grids alone are written
    std::vector<std::string> settings = {"point radius",
                                         "blade angle",
                                         "radial distance",
                                         "blank offset",
                                         "sliding base",
                                         "machine center to back",
                                         "machine root angle",
                                         "ratio of roll"};
    std::string              largest_changes;  ///< one for each setting; empty: no limits
    bool                     free_turn = true; ///< the flank's place about the axis is found too
    double                   threshold = 1e-3; ///< of singular values, part of the largest
    MeasuringGrid            grid;

    void declare(dealii::ParameterHandler &prm);
    /** The largest changes [internal units]; throws InputError (@p section: of the entries) where
     * they are no positive quantities of the settings. */
    std::vector<double> limits(const std::string &section) const;
  };

  /**
   * Study kind `flank fit`: writes the measuring grids of all flanks of a pair
   * (grid_MEMBER_FLANK.csv) and, where a measured flank is given, finds the machine settings that
   * cut it (flank_fit.csv, flank_fit.json, fitted_pair.prm).
   */
  std::unique_ptr<StudyKind> make_flank_fit_study();
} // namespace vfife

#endif
