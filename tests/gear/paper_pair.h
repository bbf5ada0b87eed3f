// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_tests_gear_paper_pair_h
#define vfife_tests_gear_paper_pair_h

#include <vfife/gear/spiral_bevel/gear_pair.h>

/** The pair of the paper: its Tables 1 and 2 with the contradictions settled as doc/theory/gear.md
 * says.
 */
namespace paper
{
  using vfife::degree;

  /** Settings in the order of Table 2, angles in degrees. */
  inline void set_machine(vfife::MachineSettings &settings,
                          const double            point_radius,
                          const double            radial_distance,
                          const double            cradle_angle,
                          const double            blank_offset,
                          const double            sliding_base,
                          const double            machine_center_to_back,
                          const double            machine_root_angle,
                          const double            edge_radius)
  {
    settings.point_radius           = point_radius;
    settings.blade_angle            = 20. * degree;
    settings.edge_radius            = edge_radius;
    settings.radial_distance        = radial_distance;
    settings.cradle_angle           = cradle_angle * degree;
    settings.blank_offset           = blank_offset;
    settings.sliding_base           = sliding_base;
    settings.machine_center_to_back = machine_center_to_back;
    settings.machine_root_angle     = machine_root_angle * degree;
  }

  inline vfife::Blank blank(const unsigned int teeth,
                            const vfife::Hand  hand,
                            const double       face_angle,
                            const double       root_angle,
                            const double       addendum,
                            const double       dedendum)
  {
    vfife::Blank blank;
    blank.teeth               = teeth;
    blank.hand                = hand;
    blank.face_angle          = face_angle * degree;
    blank.root_angle          = root_angle * degree;
    blank.mean_cone_distance  = 116.49;
    blank.outer_cone_distance = 131.4913;
    blank.face_width          = 30.;
    blank.mean_addendum       = addendum;
    blank.mean_dedendum       = dedendum;
    return blank;
  }

  /** Pitch angles, ratios of roll and the gear's outside point radius are left to be derived. */
  inline vfife::GearPairOptions options()
  {
    vfife::GearPairOptions options;
    options.pinion.blank = blank(27, vfife::Hand::right, 20.56, 17.90, 3.34, 1.91);
    options.gear.blank   = blank(79, vfife::Hand::left, 72.10, 69.44, 1.32, 3.94);
    set_machine(options.pinion.concave, 94.01, 104.53, -50.44, 1.41, 0.41, -1.16, 17.90, 0.5);
    set_machine(options.pinion.convex, 96.18, 108.77, -48.81, -0.62, 0.10, -0.13, 17.90, 0.5);
    set_machine(options.gear.concave, 0., 107.42, 50.16, 0., -0.50, 0., 69.44, 0.8);
    set_machine(options.gear.convex, 94.26, 107.42, 50.16, 0., -0.50, 0., 69.44, 0.8);
    options.gear.cutter_diameter = 190.5;
    return options;
  }
} // namespace paper

#endif
