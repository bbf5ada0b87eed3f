// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// Pairs proposed from basic data have the contact that was asked for.
#include "../refusal.h"
#include "../tests.h"

#include <vfife/gear/unloaded_contact/contact_analysis.h>
#include <vfife/gear/unloaded_contact/tooth_form.h>

using namespace vfife;

void check_pair(const std::string &name, const GearPairOptions &options)
{
  const GearPair      pair(options);
  const PairProposal &asked = options.proposal;
  for (const MeshSide side : {MeshSide::drive, MeshSide::coast})
    {
      const std::string     what = name + " " + side_name(side) + ": ";
      const ContactAnalysis a    = analyse_contact(pair, side, ContactAnalysisOptions());
      // the fit over the path mixes higher powers into the second one: 0.5 %
      check_close(what + "lag [arcsec]",
                  a.lag_polynomial[0] / 4. / arcsecond,
                  asked.lag / arcsecond,
                  0.005 * asked.lag / arcsecond);
      // a difference over 0.02 pitches on a curved path
      check_close(what + "path [deg]",
                  std::abs(a.path_angle) * 180. / pi,
                  asked.path_angle * 180. / pi,
                  0.05);
      check_close(what + "ellipse [mm]",
                  a.mean.ellipse.semi_axes[0],
                  asked.ellipse_length * pair.gear().blank().face_width / 2,
                  1e-6);
      check(what + "the next pair takes over inside the flanks",
            a.hands_over && a.contact_ratio > 1.2);
    }
  const ToothForms forms = measure_tooth_forms(pair);
  check(name + ": teeth can be cut and run", forms.findings.causes().empty());
}

/** At the mean contact itself, of pairs whose teeth are undercut or whose path is too short for
 * what check_pair() asks for: its direction and the ellipse are those of one contact only. */
void check_mean_contact(const std::string &name, const GearPairOptions &options)
{
  const GearPair pair(options);
  for (const MeshSide side : {MeshSide::drive, MeshSide::coast})
    {
      const std::string     what = name + " " + side_name(side) + ": ";
      const ContactAnalysis a    = analyse_contact(pair, side, ContactAnalysisOptions());
      check_close(what + "path [deg]",
                  std::abs(a.path_angle) * 180. / pi,
                  options.proposal.path_angle * 180. / pi,
                  0.05);
      check_close(what + "ellipse [mm]",
                  a.mean.ellipse.semi_axes[0],
                  options.proposal.ellipse_length * pair.gear().blank().face_width / 2,
                  1e-6);
      check_close(what + "mean cone distance [mm]",
                  a.mean.contact.gear_L_h[0],
                  pair.gear().blank().mean_cone_distance,
                  1e-6);
    }
}

GearPairOptions basic(const unsigned int pinion, const unsigned int gear, const double module)
{
  GearPairOptions options;
  options.proposal.pinion_teeth = pinion;
  options.proposal.gear_teeth   = gear;
  options.proposal.module       = module;
  return options;
}

/** What a user reads about @p options, empty where a pair is found. */
std::string refusal(const GearPairOptions &options)
{
  return message_of([&]() { const GearPair pair(options); });
}

/** Teeth that make no external bevel pair with the shaft angle, and ratios that none has. */
void check_ratios()
{
  const auto at = [](const unsigned int pinion, const unsigned int gear, const double angle) {
    GearPairOptions options = basic(pinion, gear, 4.);
    options.shaft_angle     = angle * degree;
    return refusal(options);
  };
  std::cout << at(17, 43, 120.) << std::endl;
  std::cout << at(6, 12, 120.) << std::endl;
  std::cout << at(19, 43, 116.) << std::endl;
  check("19/43 at 115 deg: the pitch angle of the gear is 88.8 deg", at(19, 43, 115.).empty());
  std::cout << at(19, 430, 90.) << std::endl;
  std::cout << at(6, 80, 90.) << std::endl;
}

/** Blanks and settings that are set by the user and by the proposal are refused by name. */
void check_given()
{
  GearPairOptions options                = basic(17, 43, 4.);
  options.gear.blank.face_width          = 20.;
  options.pinion.concave.cradle_angle    = .9;
  options.gear.both.edge_radius          = .5;
  options.pinion.convex.blank_offset     = 1.;
  options.gear.cutter_diameter           = 150.;
  options.gear.concave.second_order_roll = .1;
  print_refused_entry([&] { options.check(); });
}

int main()
{
  check_given();
  check_ratios();
  check_pair("25/25", basic(25, 25, 4.));
  check_pair("9/33", basic(9, 33, 5.5));
  check_pair("17/43", basic(17, 43, 4.));
  // Newton's method comes to a point beyond the teeth from the middle of these.
  check_pair("25/50", basic(25, 50, 4.));
  check_pair("27/79", basic(27, 79, 3.15));
  check_pair("22/66", basic(22, 66, 4.));
  // It comes to another point of the teeth.
  check_mean_contact("12/24", basic(12, 24, 2.));
  // Contacts of the same settings that are nearer to where Newton's method starts.
  check_mean_contact("8/16", basic(8, 16, 4.));
  GearPairOptions flat     = basic(9, 33, 5.5);
  flat.proposal.path_angle = 15. * pi / 180.;
  check_mean_contact("9/33 with a path at 15 deg", flat);
  GearPairOptions steep     = basic(9, 33, 5.5);
  steep.proposal.path_angle = 40. * pi / 180.;
  check_mean_contact("9/33 with a path at 40 deg", steep);
  GearPairOptions right      = basic(17, 43, 4.);
  right.proposal.pinion_hand = Hand::right;
  check_pair("17/43 right hand", right);
  GearPairOptions skew = basic(17, 43, 4.);
  skew.shaft_angle     = 75. * pi / 180.;
  check_pair("17/43 at 75 deg", skew);
  GearPairOptions nothing = basic(17, 43, 0.);
  print_refused_entry([&] { nothing.check(); });
  return 0;
}
