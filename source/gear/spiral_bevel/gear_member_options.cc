// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/parameters/parameters.h>
#include <vfife/base/parameters/section_of_options.h>
#include <vfife/gear/findings.h>
#include <vfife/gear/spiral_bevel/gear_member_options.h>

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
    none.edge_radius = 0.; // the only entry whose default is a value
    return none;
  }

  GearMemberOptions GearMemberOptions::spread() const
  {
    // r = (diameter +- width) / 2, + for the outside blade
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
    // an entry for both flanks and a different one for one flank
    concave.examine_shared(both, both_section, section + "/Concave flank", findings);
    convex.examine_shared(both, both_section, section + "/Convex flank", findings);
    if (point_width > 0. && cutter_diameter == 0. &&
        (concave.point_radius == 0. || convex.point_radius == 0.))
      findings.add(Findings::Action::stop,
                   both_section + "/point width",
                   {},
                   "a point width needs the cutter diameter to give point radii");
    // a point width and point radii that do not fit it
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
                     "Nominal sum of outside and inside point radius; 0: not given",
                     Range::not_negative());
    declare_section(prm, "Blank", blank);
    {
      Subsection subsection(prm, "Both flanks");
      declare_quantity(prm,
                       "point width",
                       point_width,
                       "mm",
                       "Point width: outside minus inside point radius, given together with the "
                       "cutter diameter instead of point radii; 0: not given",
                       Range::not_negative());
      both.declare_shared(prm);
    }
    declare_section(prm, "Concave flank", concave);
    declare_section(prm, "Convex flank", convex);
  }

  const char *section_of(const FlankSide side)
  {
    return side == FlankSide::concave ? "Concave flank" : "Convex flank";
  }
} // namespace vfife
