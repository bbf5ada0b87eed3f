// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_gear_measurement_settings_fit_h
#define vfife_gear_measurement_settings_fit_h

#include <vfife/base/text/table.h>
#include <vfife/gear/spiral_bevel/gear_member.h>

#include <string>
#include <vector>

namespace vfife
{
  /** A machine setting that can be changed. */
  struct FittedSetting
  {
    std::string name; ///< of its entry
    double MachineSettings::*value = nullptr;
    double      scale = 1; ///< change that counts as much as that of the others (mm, rad, -)
    std::string unit;      ///< of its entry
  };

  /** All of them: everything but the rounding of the blade, which cuts no flank. */
  const std::vector<FittedSetting> &fitted_settings();

  /** What was found. */
  struct SettingsFitResult
  {
    MachineSettings     settings;
    double              turn = 0; ///< of the flank about the axis against the given place [rad]
    unsigned int        iterations = 0;
    unsigned int        directions = 0; ///< independent changes of the settings that points tell
    std::vector<double> before, after;  ///< of the points out of the flank, > 0 is metal [mm]
    /** Settings that stand at their largest change. */
    std::vector<std::string> at_limit;
    /** Why the search ended before it came to rest: the settings are the best that it met. Empty
     * where it came to rest. */
    std::string unfinished;
  };

  /** Deviations of the points before and after [um], in their order: flank_fit.csv. */
  Table fit_table(const SettingsFitResult &found);

  /**
   * Finds settings of a member's flank with which it goes through measured points, in the sense of
   * least squares of their distances along the normals (doc/theory/errors.md). Of settings whose
   * changes the points cannot tell apart the ones nearest to the given settings are found, measured
   * in their scales.
   */
  class SettingsFit
  {
  public:
    /**
     * @p free: names of settings; @p free_turn: the flank's position about the axis is found too;
     * @p threshold: changes of the flank below this part of those that the best seen combination
     * of settings makes are not told; @p largest_changes: of the settings, in the order of
     * @p free [internal units]; empty: without limit. Throws InputError for unknown names and fewer
     * points than unknowns.
     */
    SettingsFit(const GearMember               &member,
                FlankSide                       side,
                const std::vector<std::string> &free,
                bool                            free_turn,
                double                          threshold,
                std::vector<Vector3>            points,
                const std::vector<double>      &largest_changes = {});

    /** The best settings that the search meets. Throws InputError where points do not lie near the
     * flank. */
    SettingsFitResult solve() const;

  private:
    /** Changes over scales, the last one of the turn if it is free. */
    using Unknowns = Eigen::VectorXd;

    MachineSettings settings_of(const Unknowns &x) const;
    double          turn_of(const Unknowns &x) const;
    /** Distances of the points out of the flank [mm]. */
    Eigen::VectorXd distances(const Unknowns &x) const;
    Eigen::MatrixXd slopes(const Unknowns &x) const;
    /** The step of Gauss and Newton from @p x with distances @p r that keeps within the limits;
     * @p directions: independent changes. */
    Unknowns limited_step(const Eigen::MatrixXd &slopes,
                          const Unknowns        &x,
                          const Eigen::VectorXd &r,
                          unsigned int          &directions) const;
    /** Goes along @p step as far as the sum of squares falls; false where it does not. */
    bool go_along(const Unknowns &step, Unknowns &x, Eigen::VectorXd &r) const;

    MachineSettings            given_;
    double                     pitch_angle_, own_turn_, turn_scale_, threshold_;
    std::vector<FittedSetting> free_;
    bool                       free_turn_;
    std::vector<Vector3>       points_;
    Unknowns                   limits_; ///< largest changes over scales
  };
} // namespace vfife

#endif
