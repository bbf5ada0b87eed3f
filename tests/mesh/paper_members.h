// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_tests_mesh_paper_members_h
#define vfife_tests_mesh_paper_members_h

#include "../gear/paper_pair.h"

#include <vfife/gear/spiral_bevel/gear_member.h>

/** The pair of the paper (27/79), with the ratios of roll and the turn of the pinion's convex flank
 * as derived. */
namespace paper
{
  /** A flank as cut by these settings, with a ratio of roll. */
  inline vfife::Flank
  flank(vfife::MachineSettings settings, const double ratio_of_roll, const vfife::Blank &blank)
  {
    settings.ratio_of_roll = ratio_of_roll;
    return vfife::Flank(settings, blank.pitch_angle);
  }

  inline vfife::GearMember member(const std::string              &name,
                                  const vfife::GearMemberOptions &options,
                                  const double                    pitch_angle,
                                  const std::array<double, 2>    &ratios_of_roll,
                                  const double                    turn_of_convex)
  {
    vfife::Blank blank = options.blank;
    blank.pitch_angle  = pitch_angle * degree;
    return {name,
            blank,
            flank(options.concave, ratios_of_roll[0], blank),
            flank(options.convex, ratios_of_roll[1], blank),
            0.,
            turn_of_convex};
  }

  inline vfife::GearMember gear(const double tip_chamfer = 0.)
  {
    vfife::GearMemberOptions cut = options().gear;
    cut.concave.point_radius     = 96.24;
    cut.blank.tip_chamfer        = tip_chamfer;
    return member("gear", cut, 71.131001, {{1.056331241780, 1.056331241780}}, 2. * vfife::pi / 79);
  }

  inline vfife::GearMember pinion(const double tip_chamfer = 0.)
  {
    vfife::GearMemberOptions cut = options().pinion;
    cut.blank.tip_chamfer        = tip_chamfer;
    return member("pinion", cut, 18.868999, {{3.005081151868, 3.130726290317}}, -0.038533425504);
  }
} // namespace paper

#endif
