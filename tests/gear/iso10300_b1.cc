// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// Nominal stresses of ISO 10300 method B1: every intermediate value of sample 1 of
// ISO/TR 10300-30:2024, and the pair of the paper as its flanks are.
#include "../refusal.h"
#include "../tests.h"
#include "paper_pair.h"

#include <vfife/gear/rating/iso10300_b1.h>

using namespace vfife;

/** Sample 1, 14/39 teeth. The thickness is that of its modification coefficients x_sm. */
RatedPair sample()
{
  RatedPair pair;
  pair.normal_module  = 3.213;
  pair.spiral_angle   = 35. * degree;
  pair.pressure_angle = 20. * degree;
  pair.face_width     = 25.4;
  pair.modulus        = 210000. / (2 * (1. - 0.3 * 0.3));
  pair.members[0]     = {14., 19.747 * degree, 4.837, 2.393, 0., 0.8};
  pair.members[1]     = {39., 70.253 * degree, 1.590, 5.640, 0., 1.2};

  const double shifts[] = {0.505, -0.505}, thickness[] = {0.036, -0.055};
  for (unsigned int i = 0; i < 2; ++i)
    pair.members[i].tooth_thickness =
      pair.normal_module * (pi / 2 + 2 * (shifts[i] * std::tan(20. * degree) + thickness[i]));
  return pair;
}

void check_sample()
{
  const BevelRating rating = iso10300_b1(sample(), 300e3);
  // Printed with three digits behind the point: half a unit, and 4e-4 of the value from the rounded
  // module (3.213) that all lengths grow with.
  const auto check_printed = [](const std::string &name, const double value, const double printed) {
    check_close(name, value, printed, 5e-4 + 4e-4 * printed);
  };
  check_printed("transverse contact ratio", rating.transverse_contact_ratio, 1.165);
  check_printed("face contact ratio", rating.face_contact_ratio, 1.227);
  check_printed("middle contact line [mm]", rating.contact_line, 22.442);
  check_printed("relative radius of curvature [mm]", rating.curvature_radius, 12.459);
  check_printed("Z_M-B", rating.mid_zone, 0.916);
  check_printed("Z_E", rating.elasticity, 191.646);
  check_printed("Y_BS", rating.spiral_angle_factor, 1.054);
  // The outer lines of contact depend on a small difference of two lengths, 9.49 and 11.34 mm.
  check_close("Z_LS", rating.load_sharing, 0.935, 1.5e-3);
  check_close("sigma_H0 [MPa]", rating.contact_stress, 1168.5, 1168.5 * 1e-3);

  // The rounded x_sm (0.036) moves the root chord by up to 3.2e-3 mm, 4.3e-4 of it, and Y_Fa by
  // twice that.
  const auto check_form = [](const std::string &name, const double value, const double printed) {
    check_close(name, value, printed, 5e-4 + (4e-4 + 9e-4) * printed);
  };
  const RatedTooth &pinion = rating.teeth[0], &gear = rating.teeth[1];
  check_form("s_Fn [mm]", pinion.root_thickness, 7.423);
  check_form("rho_F [mm]", pinion.fillet_radius, 1.023);
  check_form("h_Fa [mm]", pinion.bending_arm, 6.405);
  check_form("alpha_Fan [deg]", pinion.load_angle / degree, 31.534);
  check_form("Y_Fa of the pinion", pinion.form_factor, 2.033);
  check_form("Y_Sa of the pinion", pinion.stress_correction, 2.022);
  check_form("Y_Fa of the wheel", gear.form_factor, 2.480);
  check_form("Y_Sa of the wheel", gear.stress_correction, 1.706);
  check_close("sigma_F0 of the pinion [MPa]", pinion.root_stress, 316.5, 316.5 * 2e-3);
  check_close("sigma_F0 of the wheel [MPa]", gear.root_stress, 325.9, 325.9 * 2e-3);
}

/** Stresses by scaling: contact stress with the root of the torque, root stress with the torque. */
void check_scaling()
{
  const BevelRating one = iso10300_b1(sample(), 300e3), four = iso10300_b1(sample(), 1200e3);
  check_close("sigma_H0 at four times the torque",
              four.contact_stress,
              2 * one.contact_stress,
              1e-9 * one.contact_stress);
  check_close("sigma_F0 at four times the torque",
              four.teeth[0].root_stress,
              4 * one.teeth[0].root_stress,
              1e-9 * one.teeth[0].root_stress);
}

void check_paper_pair()
{
  const GearPair  pair(paper::options());
  const RatedPair rated = rated_pair(pair, MeshSide::drive, 115385.);
  check_close("spiral angle [deg]", rated.spiral_angle / degree, 30., 0.5);
  check_close("pressure angle [deg]", rated.pressure_angle / degree, 20., 1.);
  // Both teeth fill the pitch but for the backlash, 0.12 mm normal to the flanks.
  check_close("normal thickness of both teeth [mm]",
              rated.members[0].tooth_thickness + rated.members[1].tooth_thickness,
              pi * rated.normal_module - 0.12 / std::cos(rated.pressure_angle),
              0.02);
}

void check_refusals()
{
  RatedPair straight    = sample();
  straight.spiral_angle = 10. * degree;
  print_refusal([&] { iso10300_b1(straight, 300e3); });
}

int main()
{
  check_sample();
  check_scaling();
  check_paper_pair();
  check_refusals();
  return 0;
}
