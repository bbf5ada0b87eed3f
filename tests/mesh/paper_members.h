// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_tests_mesh_paper_members_h
#define vfife_tests_mesh_paper_members_h

#include <vfife/gear/spiral_bevel/gear_member.h>

/** The pair of the paper (27/79), with the ratios of roll and the turn of the pinion's convex flank
 * as derived. */
namespace paper
{
  constexpr double degree = vfife::pi / 180.;

  inline vfife::MachineSettings settings(const vfife::Blade blade,
                                         const double       point_radius,
                                         const double       edge_radius,
                                         const double       radial_distance,
                                         const double       cradle_angle,
                                         const double       machine_root_angle,
                                         const double       ratio_of_roll)
  {
    vfife::MachineSettings s(blade);
    s.point_radius       = point_radius;
    s.blade_angle        = 20. * degree;
    s.edge_radius        = edge_radius;
    s.radial_distance    = radial_distance;
    s.cradle_angle       = cradle_angle * degree;
    s.machine_root_angle = machine_root_angle * degree;
    s.ratio_of_roll      = ratio_of_roll;
    return s;
  }

  inline vfife::Blank blank(const unsigned int teeth,
                            const vfife::Hand  hand,
                            const double       pitch_angle,
                            const double       face_angle,
                            const double       root_angle,
                            const double       addendum,
                            const double       dedendum)
  {
    vfife::Blank b;
    b.teeth               = teeth;
    b.hand                = hand;
    b.pitch_angle         = pitch_angle * degree;
    b.face_angle          = face_angle * degree;
    b.root_angle          = root_angle * degree;
    b.mean_cone_distance  = 116.49;
    b.outer_cone_distance = 131.4913;
    b.face_width          = 30.;
    b.mean_addendum       = addendum;
    b.mean_dedendum       = dedendum;
    return b;
  }

  inline vfife::GearMember gear()
  {
    const auto b = blank(79, vfife::Hand::left, 71.131001, 72.10, 69.44, 1.32, 3.94);
    auto       concave =
      settings(vfife::Blade::outside, 96.24, 0.8, 107.42, 50.16, 69.44, 1.056331241780);
    auto convex = settings(vfife::Blade::inside, 94.26, 0.8, 107.42, 50.16, 69.44, 1.056331241780);
    concave.sliding_base = convex.sliding_base = -0.50;
    return {"gear",
            b,
            vfife::Flank(concave, b.pitch_angle),
            vfife::Flank(convex, b.pitch_angle),
            0.,
            2. * vfife::pi / 79};
  }

  inline vfife::GearMember pinion()
  {
    const auto b = blank(27, vfife::Hand::right, 18.868999, 20.56, 17.90, 3.34, 1.91);
    auto       concave =
      settings(vfife::Blade::outside, 94.01, 0.5, 104.53, -50.44, 17.90, 3.005081151868);
    auto convex = settings(vfife::Blade::inside, 96.18, 0.5, 108.77, -48.81, 17.90, 3.130726290317);
    concave.blank_offset           = 1.41;
    concave.sliding_base           = 0.41;
    concave.machine_center_to_back = -1.16;
    convex.blank_offset            = -0.62;
    convex.sliding_base            = 0.10;
    convex.machine_center_to_back  = -0.13;
    return {"pinion",
            b,
            vfife::Flank(concave, b.pitch_angle),
            vfife::Flank(convex, b.pitch_angle),
            0.,
            -0.038533425504};
  }
} // namespace paper

#endif
