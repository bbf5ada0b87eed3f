// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/parameters/parameters.h>
#include <vfife/base/parameters/section_of_options.h>
#include <vfife/gear/spiral_bevel/gear_pair_options.h>

namespace vfife
{
  void GearPairOptions::declare(dealii::ParameterHandler &prm)
  {
    declare_section(prm, "Proposal", proposal);
    declare_section(prm, "Pinion", pinion);
    declare_section(prm, "Gear", gear);
    {
      Subsection subsection(prm, "Mounting");
      declare_quantity(
        prm, "shaft angle", shaft_angle, "deg", "Nominal shaft angle", Range::between(20., 140.));
      declare_quantity(prm,
                       "backlash",
                       backlash,
                       "mm",
                       "Normal backlash at the mean point; the program adjusts the pinion's tooth "
                       "thickness to it",
                       Range::not_negative());
      declare_quantity(prm,
                       "pinion axial shift",
                       pinion_axial_shift,
                       "mm",
                       "Mounting error of the pinion along its axis, positive away from the apex");
      declare_quantity(prm,
                       "gear axial shift",
                       gear_axial_shift,
                       "mm",
                       "Mounting error of the gear along its axis, positive away from the apex");
      declare_quantity(
        prm,
        "offset",
        offset,
        "mm",
        "Mounting error of the pinion axis along +y of the fixed frame (gear axis x pinion axis)");
      declare_quantity(prm,
                       "shaft angle error",
                       shaft_angle_error,
                       "deg",
                       "Mounting error of the shaft angle, positive opens it",
                       Range::between(-1., 1.));
    }
    const Subsection subsection(prm, "Errors");
    declare_section(prm, "Pinion", pinion_errors);
    declare_section(prm, "Gear", gear_errors);
  }

  GearPairOptions GearPairOptions::completed() const
  {
    GearPairOptions options = *this;
    if (proposal.is_given())
      propose(proposal, shaft_angle, options.pinion, options.gear);
    // what one section says for both flanks
    options.pinion = options.pinion.spread();
    options.gear   = options.gear.spread();
    Blank &blank1 = options.pinion.blank, &blank2 = options.gear.blank;
    if (blank2.hand == Hand::automatic && blank1.hand != Hand::automatic)
      blank2.hand = opposite(blank1.hand);
    else if (blank1.hand == Hand::automatic && blank2.hand != Hand::automatic)
      blank1.hand = opposite(blank2.hand);
    if (blank1.teeth > 0 && blank2.teeth > 0)
      {
        // pitch angles from the numbers of teeth
        if (blank1.pitch_angle == 0.)
          blank1.pitch_angle = pitch_angle_of(blank1.teeth, blank2.teeth, shaft_angle);
        if (blank2.pitch_angle == 0.)
          blank2.pitch_angle = pitch_angle_of(blank2.teeth, blank1.teeth, shaft_angle);
      }
    // the gear's spread-blade cutter: the other point radius, and the ratio of roll of both flanks
    MachineSettings &concave = options.gear.concave, &convex = options.gear.convex;
    const double     diameter = options.gear.cutter_diameter;
    if (options.gear.is_spread_blade() && diameter > 0.)
      {
        if (concave.point_radius == 0. && convex.point_radius > 0.)
          concave.point_radius = diameter - convex.point_radius;
        else if (convex.point_radius == 0. && concave.point_radius > 0.)
          convex.point_radius = diameter - concave.point_radius;
      }
    for (MachineSettings *settings : {&concave, &convex})
      if (settings->ratio_of_roll == 0. && blank2.pitch_angle > 0.)
        settings->ratio_of_roll = settings->conjugate_ratio_of_roll(blank2.pitch_angle);
    return options;
  }

  void GearPairOptions::check(const std::string &section) const
  {
    examine(section).raise();
    const GearPairOptions options = completed();
    pinion_errors.check(section + "/Errors/Pinion", options.pinion.blank.teeth);
    gear_errors.check(section + "/Errors/Gear", options.gear.blank.teeth);
  }
} // namespace vfife
