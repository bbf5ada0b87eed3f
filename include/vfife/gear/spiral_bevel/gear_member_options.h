// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_gear_spiral_bevel_gear_member_options_h
#define vfife_gear_spiral_bevel_gear_member_options_h

#include <vfife/gear/spiral_bevel/blank.h>
#include <vfife/gear/spiral_bevel/flank.h>
#include <vfife/gear/spiral_bevel/machine_settings.h>

#include <string>

namespace vfife
{
  /** What the user gives of one member: content of "Gear pair/Pinion" and "Gear pair/Gear". */
  struct GearMemberOptions
  {
    double          cutter_diameter = 0; ///< twice the mean of the point radii; 0: not given [mm]
    double          point_width     = 0; ///< outside less inside point radius; 0: not given [mm]
    Blank           blank;               ///< with the tip chamfer, which no proposal sets
    MachineSettings both{no_settings()}; ///< holds for both flanks where it is not 0
    MachineSettings concave{Blade::outside};
    MachineSettings convex{Blade::inside};

    /** The settings of a flank. */
    const MachineSettings &settings(FlankSide side) const
    {
      return side == FlankSide::concave ? concave : convex;
    }
    MachineSettings &settings(FlankSide side)
    {
      return side == FlankSide::concave ? concave : convex;
    }

    void declare(dealii::ParameterHandler &prm);
    /** With the settings of both flanks, and point radii from diameter and width, in each flank. */
    GearMemberOptions spread() const;
    /** Whether one cutter in one position cuts both flanks of a slot at once. */
    bool is_spread_blade() const;
    /** Adds what is wrong with the member alone (@p section: path of its entries). */
    void examine(const std::string &section, Findings &findings) const;
    /** Adds contradictions between "Both flanks" and the sections of the flanks, as given. */
    void examine_spread(const std::string &section, Findings &findings) const;

  private:
    static MachineSettings no_settings();
  };

  /** A root angle set on the machine deviates from the blank's by less than this unless one is
   * wrong; the same holds for cones of both members that run parallel [rad]. */
  constexpr double root_angle_tolerance = 0.25 * (pi / 180.);

  /** Where the cutter stands to the middle of the tooth, from its position on the cradle. */
  struct CutterPosition
  {
    double radius       = 0; ///< cutter axis to the middle of the tooth [mm]
    double spiral_angle = 0; ///< of a tooth that this cutter cuts there [rad]

    CutterPosition(const Blank &blank, const MachineSettings &settings);
  };

  /** Name of the subsection with the settings of a flank. */
  const char *section_of(FlankSide side);
} // namespace vfife

#endif
