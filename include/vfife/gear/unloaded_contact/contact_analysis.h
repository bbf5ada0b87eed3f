// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_gear_unloaded_contact_contact_analysis_h
#define vfife_gear_unloaded_contact_contact_analysis_h

#include <vfife/base/parameter_handler.h>
#include <vfife/base/text/table.h>
#include <vfife/gear/driving.h>
#include <vfife/gear/unloaded_contact/edge_contact.h>

#include <array>
#include <string>
#include <vector>

namespace vfife
{
  /** Section "Tooth contact analysis", and what section "Operation" says of the drive. */
  struct ContactAnalysisOptions
  {
    double marking_thickness =
      vfife::marking_thickness; ///< gap that the contact ellipse is drawn at [mm]
    unsigned int     points_per_pitch = 20;
    unsigned int     meshes           = 0; ///< followed where teeth differ; 0: a turn of the gear
    DrivingMember    driving          = DrivingMember::pinion;
    TurningDirection direction        = TurningDirection::forward;

    void declare(dealii::ParameterHandler &prm);

    MeshSide working_side() const
    {
      return vfife::working_side(driving, direction);
    }
  };

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

  /** Where the path of contact ends, and what touches beyond it. */
  struct PathEnd
  {
    std::string border;          ///< "gear tip", "pinion toe"...
    bool        is_edge = false; ///< an edge takes over there; no edge at a fillet
    double      place   = 0;     ///< [pitches]
    double      lag     = 0;     ///< there [rad]
    double      reach   = 0;     ///< how far the edge stays on the other flank [pitches]

    /** What this pair's lag exceeds that of the touching pair by: turn of the gear, by bending of
     * teeth, until this border carries [rad]. Negative where the pair itself touches. */
    double approach = 0;
  };

  /**
   * The unloaded contact of one side in figures (doc/theory/gear.md). Lag: of the gear against the
   * exact ratio, seen from the mean contact; the transmission error of the unloaded gear is minus
   * it.
   */
  struct ContactAnalysis
  {
    MeshSide               side = MeshSide::drive;
    PathPoint              mean;              ///< of tooth pair 0 at the reference rotation
    std::vector<PathPoint> path;              ///< of tooth pair 0, from border to border
    std::array<PathEnd, 2> ends;              ///< of the path, at its first and last rotation
    double                 path_angle    = 0; ///< to the gear's lengthwise direction [rad]
    double                 contact_ratio = 0;

    std::array<double, 3> lag_polynomial{}; ///< of the powers 2, 3, 4 of the pitches, without
                                            ///< mounting errors; with them see lag_offset [rad]
    Vector2 lag_offset =
      Vector2::Zero();    ///< of the powers 0 and 1: nothing without mounting errors
    double fit_error = 0; ///< largest deviation of the polynomial on the path [rad]

    bool   hands_over    = false; ///< to the next pair
    bool   over_an_edge  = false; ///< an edge carries at the hand-over; else both are on flanks
    double hand_over     = 0;     ///< [pitches]
    double hand_over_lag = 0;     ///< [rad]
    double peak_to_peak  = 0;     ///< of the lag over a pitch of the touching pairs [rad]

    Vector2 pinion_curvatures, gear_curvatures; ///< principal, at the mean contact [1/mm]
  };

  /** Throws NumericalError when tooth pair 0 touches nowhere inside its flanks. */
  ContactAnalysis
  analyse_contact(const GearPair &pair, MeshSide side, const ContactAnalysisOptions &options);

  /** Lag of tooth pair 0 and its neighbours over two pitches, on flanks, edges, and a little of
   * the flanks' continuation: tca.csv. */
  Table lag_table(const GearPair                     &pair,
                  const std::vector<ContactAnalysis> &sides,
                  const ContactAnalysisOptions       &options);

  /**
   * Transmission error of the driven member, at its own axis, over two pitches of the driver, in
   * the direction of rotation: transmission.csv. With the gear driving, the pinion's is the gear's
   * lag times z2/z1 and the driver's angle holds the lag.
   */
  Table transmission_table(const GearPair &pair, const ContactAnalysisOptions &options);

  /** The paths on both flanks with contact ellipses: path.csv. */
  Table path_table(const GearPair &pair, const std::vector<ContactAnalysis> &sides);
} // namespace vfife

#endif
