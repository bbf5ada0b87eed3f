// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/parameters/parameters.h>
#include <vfife/gear/gear_pair.h>

#include <cmath>

namespace vfife
{
  bool GearMemberOptions::is_spread_blade() const
  {
    return concave.radial_distance == convex.radial_distance &&
           concave.cradle_angle == convex.cradle_angle &&
           concave.blank_offset == convex.blank_offset &&
           concave.sliding_base == convex.sliding_base &&
           concave.machine_center_to_back == convex.machine_center_to_back &&
           concave.machine_root_angle == convex.machine_root_angle &&
           concave.ratio_of_roll == convex.ratio_of_roll &&
           concave.second_order_roll == convex.second_order_roll &&
           concave.third_order_roll == convex.third_order_roll &&
           concave.cutter_tilt == convex.cutter_tilt &&
           concave.cutter_swivel == convex.cutter_swivel;
  }

  MachineSettings GearMemberOptions::no_settings()
  {
    MachineSettings none;
    none.edge_radius = 0.;
    return none;
  }

  GearMemberOptions GearMemberOptions::spread() const
  {
    GearMemberOptions member = *this;
    for (MachineSettings *flank : {&member.concave, &member.convex})
      {
        flank->take_over(both);
        if (flank->point_radius == 0. && cutter_diameter > 0. && point_width > 0.)
          flank->point_radius = (cutter_diameter + flank->sigma() * point_width) / 2;
      }
    return member;
  }

  void GearMemberOptions::examine_spread(const std::string &section, Findings &findings) const
  {
    const std::string both_section = section + "/Both flanks";
    concave.examine_shared(both, both_section, section + "/Concave flank", findings);
    convex.examine_shared(both, both_section, section + "/Convex flank", findings);
    if (point_width > 0. && cutter_diameter == 0. &&
        (concave.point_radius == 0. || convex.point_radius == 0.))
      findings.add(Findings::Action::stop,
                   both_section + "/point width",
                   {},
                   "a point width needs the cutter diameter to give point radii");
    const double width = concave.point_radius - convex.point_radius;
    if (point_width > 0. && concave.point_radius > 0. && convex.point_radius > 0. &&
        std::abs(width - point_width) > 1e-6)
      findings.add(Findings::Action::stop,
                   both_section + "/point width",
                   {section + "/Concave flank/point radius",
                    section + "/Convex flank/point radius"},
                   "the point width is not the difference of the point radii, which are given too");
  }

  void GearMemberOptions::declare(dealii::ParameterHandler &prm)
  {
    declare_quantity(prm,
                     "cutter diameter",
                     cutter_diameter,
                     "mm",
                     "Sum of the outside and the inside point radius, nominally; 0: not given",
                     Range::not_negative());
    {
      Subsection subsection(prm, "Blank");
      blank.declare(prm);
    }
    {
      Subsection subsection(prm, "Both flanks");
      declare_quantity(prm,
                       "point width",
                       point_width,
                       "mm",
                       "Outside less inside point radius, with the cutter diameter in place of "
                       "point radii; 0: not given",
                       Range::not_negative());
      both.declare_shared(prm);
    }
    {
      Subsection subsection(prm, "Concave flank");
      concave.declare(prm);
    }
    {
      Subsection subsection(prm, "Convex flank");
      convex.declare(prm);
    }
  }

  void GearPairOptions::declare(dealii::ParameterHandler &prm)
  {
    {
      Subsection subsection(prm, "Proposal");
      proposal.declare(prm);
    }
    {
      Subsection subsection(prm, "Pinion");
      pinion.declare(prm);
    }
    {
      Subsection subsection(prm, "Gear");
      gear.declare(prm);
    }
    {
      Subsection subsection(prm, "Mounting");
      declare_quantity(prm,
                       "shaft angle",
                       shaft_angle,
                       "deg",
                       "Angle between the axes of the pair as designed",
                       Range::between(20., 140.));
      declare_quantity(
        prm,
        "backlash",
        backlash,
        "mm",
        "Normal backlash at the mean point; set by the thickness of the pinion's teeth",
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
  }

  double pitch_angle_of(const double own_teeth, const double other_teeth, const double shaft_angle)
  {
    return std::atan2(std::sin(shaft_angle), other_teeth / own_teeth + std::cos(shaft_angle));
  }

  double duplex_dedendum_angles(const Blank &gear,
                                const double cutter_radius,
                                const double spiral_angle,
                                const double blade_angle)
  {
    const double A      = gear.mean_cone_distance;
    const double module = 2. * A * std::sin(gear.pitch_angle) / gear.teeth;
    return pi * module / (2. * A) * (1. - A * std::sin(spiral_angle) / cutter_radius) /
           (std::tan(blade_angle) * std::cos(spiral_angle));
  }

  double conjugate_ratio_of_roll(const Blank &blank, const MachineSettings &settings)
  {
    return std::cos(blank.pitch_angle - settings.machine_root_angle) / std::sin(blank.pitch_angle);
  }

  GearPairOptions GearPairOptions::completed() const
  {
    GearPairOptions options = *this;
    if (proposal.is_given())
      propose(proposal, options);
    options.pinion = options.pinion.spread();
    options.gear   = options.gear.spread();
    Blank &blank1 = options.pinion.blank, &blank2 = options.gear.blank;
    if (blank1.teeth > 0 && blank2.teeth > 0)
      {
        if (blank1.pitch_angle == 0.)
          blank1.pitch_angle = pitch_angle_of(blank1.teeth, blank2.teeth, shaft_angle);
        if (blank2.pitch_angle == 0.)
          blank2.pitch_angle = pitch_angle_of(blank2.teeth, blank1.teeth, shaft_angle);
      }
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
        settings->ratio_of_roll = conjugate_ratio_of_roll(blank2, *settings);
    return options;
  }

  void GearPairOptions::check(const std::string &section) const
  {
    examine(section).raise();
  }
} // namespace vfife
