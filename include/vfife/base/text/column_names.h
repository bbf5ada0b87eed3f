// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_base_text_column_names_h
#define vfife_base_text_column_names_h

#include <array>
#include <string>

/**
 * Names of columns of result files that more than one place spells: writers, and those who read
 * results again. One name means the same in all tables. Which table has which columns, in which
 * units, is in doc/columns.json, which a test compares with what is written
 * (doc/reference/files.md).
 */
namespace vfife
{
  namespace column
  {
    // Samples of a run.
    constexpr char time[]    = "time";
    constexpr char dte[]     = "dte";     ///< transmission error of the driven member's bore
    constexpr char rim_dte[] = "rim dte"; ///< that of its rim
    constexpr char contact_force_total[] = "contact force total";
    constexpr char teeth_in_contact[]    = "teeth in contact";
    constexpr char energy_error[]        = "energy error";

    // Tooth pairs in contact.
    constexpr char side[]             = "side"; ///< "drive" or "coast"
    constexpr char force[]            = "force";
    constexpr char torque[]           = "torque";
    constexpr char largest_pressure[] = "largest pressure";
    constexpr char area[]             = "area";

    // Probes.
    constexpr char probe[]        = "probe"; ///< its name
    constexpr char displacement[] = "displacement";
    constexpr char stress[]       = "stress";
    constexpr char von_mises[]    = "von mises";
    /** Of a probe, a tooth or a tooth pair: mesh cycles since it was at the mean contact. */
    constexpr char after_mean_contact[] = "position after the mean contact";

    // Root stresses.
    constexpr char fillet[]      = "fillet"; ///< "concave" or "convex"
    constexpr char tension[]     = "tension";
    constexpr char compression[] = "compression";

    // Bearings, and how the members of a pair stand to each other: changes of the mounting.
    constexpr char bearing[]            = "bearing"; ///< its name
    constexpr char offset[]             = "offset";
    constexpr char pinion_axial_shift[] = "pinion axial shift";
    constexpr char gear_axial_shift[]   = "gear axial shift";
    constexpr char shaft_angle_error[]  = "shaft angle error";

    // Positions of a loaded tooth contact analysis.
    constexpr char position[]                    = "position";
    constexpr char transmission_error[]          = "transmission error";
    constexpr char unloaded_transmission_error[] = "unloaded transmission error";
    constexpr char tangent_stiffness[]           = "tangent stiffness";

    // Natural vibrations.
    constexpr char speed[]                    = "speed";
    constexpr char mesh_frequency[]           = "mesh frequency";
    constexpr char frequency[]                = "frequency";
    constexpr char axes[]                     = "axes"; ///< in which they are seen, axes_of_modes
    constexpr char share_of_static_rotation[] = "share of the static rotation";
    constexpr char damping_ratio[]            = "damping ratio";

    // Responses of the lumped model, also as figures of lumped.json.
    constexpr char direction[]            = "direction"; ///< of a sweep: "up" or "down"
    constexpr char mean_dte[]             = "mean dte";
    constexpr char peak_to_peak_dte[]     = "peak to peak dte";
    constexpr char mean_force[]           = "mean force";
    constexpr char peak_to_peak_force[]   = "peak to peak force";
    constexpr char largest_force[]        = "largest force";
    constexpr char time_without_contact[] = "time without contact";

    // Stresses of a sweep over speed.
    constexpr char place[]         = "place"; ///< a probe or a fillet of the driven body
    constexpr char amplification[] = "amplification";

    using Axes = std::array<const char *, 3>;

    constexpr Axes fixed_axes       = {{"x", "y", "z"}};
    constexpr Axes cylindrical_axes = {{"r", "theta", "z"}}; ///< of a body

    /** "displacement r", "displacement theta"... */
    std::array<std::string, 3> displacements(const Axes &axes);

    /** "stress r", "stress theta", "stress z", "stress r theta", "stress theta z", "stress z r":
     * the order of Stress. */
    std::array<std::string, 6> stresses(const Axes &axes);

    /** "pinion angle" */
    std::string angle_of(const std::string &body);

    /** "pinion tooth" */
    std::string tooth_of(const std::string &body);

    /** "contact torque on the gear" */
    std::string contact_torque_on(const std::string &body);
  } // namespace column

  /** What the column `axes` of coupled modes says. */
  namespace axes_of_modes
  {
    constexpr char rotating[] = "rotating";
    constexpr char fixed[]    = "fixed"; ///< as those of the load
  }                                      // namespace axes_of_modes
} // namespace vfife

#endif
