// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_gear_contact_analysis_h
#define vfife_gear_contact_analysis_h

#include <vfife/base/table.h>
#include <vfife/gear/tooth_contact.h>

#include <array>
#include <string>
#include <vector>

namespace dealii
{
  class ParameterHandler;
}

namespace vfife
{
  enum class DrivingMember
  {
    pinion,
    gear
  };

  /** Forward: the pinion turns about + its axis (apex to back), the gear about -. */
  enum class TurningDirection
  {
    forward,
    reverse
  };

  /** Section "Tooth contact analysis". */
  struct ContactAnalysisOptions
  {
    double           marking_thickness = 0.00635; ///< gap that the contact ellipse is drawn at [mm]
    unsigned int     points_per_pitch  = 20;
    DrivingMember    driving           = DrivingMember::pinion;
    TurningDirection direction         = TurningDirection::forward;

    void declare(dealii::ParameterHandler &prm);

    /** The flanks that carry the load with this driving member and direction. */
    MeshSide working_side() const;
  };

  /** "drive" or "coast". */
  std::string side_name(MeshSide side);

  /** A contact point with the contact ellipse about it. */
  struct PathPoint
  {
    double               pitches = 0; ///< pinion rotation from the mean contact, in pitches
    UnloadedContactPoint contact;
    ContactEllipse       ellipse;
    double               major_angle = 0; ///< of the major axis to the gear's lengthwise direction,
                                          ///< > 0 rises to the gear's tip at the heel [rad]
    Vector2 gear_major, gear_minor;       ///< semi-axes in the gear's (L, h) [mm]
    Vector2 pinion_major, pinion_minor;   ///< the same in the pinion's (L, h) [mm]
  };

  /**
   * The unloaded contact of one side in figures (doc/gear.md). Lag: of the gear against the exact
   * ratio, seen from the mean contact; the transmission error of the unloaded gear is minus it.
   */
  struct ContactAnalysis
  {
    MeshSide                   side = MeshSide::drive;
    PathPoint                  mean; ///< of tooth pair 0 at the reference rotation
    std::vector<PathPoint>     path; ///< of tooth pair 0, from border to border
    Vector2                    ends = Vector2::Zero(); ///< of the path [pitches]
    std::array<std::string, 2> borders; ///< what ends the path: "gear tip", "pinion toe"...
    double                     path_angle    = 0; ///< to the gear's lengthwise direction [rad]
    double                     contact_ratio = 0;

    std::array<double, 3> lag_polynomial{}; ///< of the powers 2, 3, 4 of the pitches, without
                                            ///< mounting errors; with them see lag_offset [rad]
    Vector2 lag_offset =
      Vector2::Zero();    ///< of the powers 0 and 1: nothing without mounting errors
    double fit_error = 0; ///< largest deviation of the polynomial on the path [rad]

    bool   hands_over    = false; ///< to the next pair while both are inside their flanks
    double hand_over     = 0;     ///< [pitches]
    double hand_over_lag = 0;     ///< [rad]
    double peak_to_peak  = 0;     ///< of the lag over a pitch of the touching pairs [rad]

    Vector2 pinion_curvatures, gear_curvatures; ///< principal, at the mean contact [1/mm]
  };

  /** Throws NumericalError when tooth pair 0 touches nowhere inside its flanks. */
  ContactAnalysis
  analyse_contact(const GearPair &pair, MeshSide side, const ContactAnalysisOptions &options);

  /** Lag of tooth pair 0 and its neighbours over two pitches: tca.csv. */
  Table lag_table(const GearPair                     &pair,
                  const std::vector<ContactAnalysis> &sides,
                  const ContactAnalysisOptions       &options);

  /** The paths on both flanks with contact ellipses: path.csv. */
  Table path_table(const GearPair &pair, const std::vector<ContactAnalysis> &sides);
} // namespace vfife

#endif
