// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// Bodies whose sizes are left open: those of the reference pair come out as they are, and proposed
// pairs of any size get bodies that fit.
#include "../refusal.h"
#include "../tests.h"
#include "paper_members.h"

#include <vfife/gear/spiral_bevel/gear_pair_options.h>
#include <vfife/mesh/gear/gear_body_check.h>
#include <vfife/mesh/gear/gear_body_sizes.h>

#include <deal.II/base/parameter_handler.h>

#include <cmath>

using namespace vfife;

namespace
{
  GearBodyOptions open(GearBodyOptions options, const BlankOutline &blank)
  {
    options.leave_sizes_open();
    return with_open_sizes(options, blank);
  }

  void reference_pair()
  {
    const GearBodyOptions asked, gear = open(asked, paper::gear().blank());
    check("reference gear: its own sizes",
          gear.web_thickness == asked.web_thickness && gear.rim_thickness == asked.rim_thickness &&
            gear.hub_radius == asked.hub_radius && gear.hub_length == asked.hub_length &&
            gear.bore_radius == asked.bore_radius);
    check("reference pinion: its own bore",
          open(pinion_body_defaults(), paper::pinion().blank()).bore_radius ==
            pinion_body_defaults().bore_radius);
    GearBodyOptions given;
    given.leave_sizes_open();
    given.hub_radius    = 48;
    given.web_thickness = 4;
    given               = with_open_sizes(given, paper::gear().blank());
    check("given sizes stay, the bore follows the hub",
          given.hub_radius == 48 && given.web_thickness == 4 && given.bore_radius == 40);
  }

  /** The word of a pair's section for both bodies, beside an element size of the gear's own. */
  void fineness()
  {
    const auto sizes =
      [](const std::string &word, const double of_gear, const bool has_numbers = false) {
        GearBodyOptions          pinion, gear;
        dealii::ParameterHandler prm;
        GearBodyOptions::declare_fineness(prm, pinion, gear, has_numbers);
        prm.set("mesh", word);
        gear.element_size = of_gear;
        return Vector2(with_open_sizes(pinion, paper::pinion().blank()).element_size,
                       with_open_sizes(gear, paper::gear().blank()).element_size);
      };
    // 79 teeth on a pitch diameter of 249 mm
    const double module = 2. * paper::gear().blank().outer_cone_distance *
                          std::sin(paper::gear().blank().pitch_angle) / 79.;
    check("coarse, medium, fine: 2/3, 0.45, 0.3 modules",
          (sizes("coarse", 0) - 2. / 3. * module * Vector2::Ones()).norm() < 1e-3 * module &&
            (sizes("medium", 0) - .675 * sizes("coarse", 0)).norm() < 1e-12 &&
            (sizes("fine", 0) - .45 * sizes("coarse", 0)).norm() < 1e-12);
    check("auto: numbers of cells hold where there are some, otherwise coarse",
          sizes("auto", 0, true).norm() == 0. && sizes("auto", 0) == sizes("coarse", 0));
    check("by members: numbers of cells hold", sizes("by members", 0).norm() == 0.);
    check("a member's own size holds", sizes("medium", 1.5)[1] == 1.5);
  }

  /** Whether both bodies of a proposed pair fit; else why not. */
  std::string
  fit(const unsigned int pinion, const unsigned int gear, const double module, const double angle)
  {
    GearPairOptions asked;
    asked.proposal.pinion_teeth = pinion;
    asked.proposal.gear_teeth   = gear;
    asked.proposal.module       = module;
    const GearPairOptions pair  = asked.completed();
    GearBodyOptions       body;
    body.web_angle            = angle * pi / 180;
    const std::string message = message_of([&] {
      check_gear_body("pinion", open(pinion_body_defaults(), pair.pinion.blank), pair.pinion.blank);
      check_gear_body("gear", open(body, pair.gear.blank), pair.gear.blank);
    });
    return message.empty() ? "fits" : message;
  }

  void proposed_pairs()
  {
    for (const double module : {0.8, 4., 12.})
      {
        std::cout << "17/43, module " << module << ": " << fit(17, 43, module, 60) << std::endl;
        std::cout << "27/79, module " << module << ": " << fit(27, 79, module, 70) << std::endl;
        std::cout << "9/33, module " << module << ": " << fit(9, 33, module, 70) << std::endl;
        std::cout << "25/25, module " << module << ": " << fit(25, 25, module, 70) << std::endl;
      }
  }
  /** Default bodies fit all pairs from 30 to 120 deg, whose gears are nearly cylindrical to nearly
   * flat, and of any number of teeth. */
  void shaft_angles()
  {
    std::string misfit;
    for (const unsigned int pinion : {6, 9, 12, 17, 19, 25})
      for (const double ratio : {1., 1.5, 2.26, 4., 10.})
        for (double angle = 30.; angle <= 120.; angle += 15.)
          {
            GearPairOptions asked;
            asked.proposal.pinion_teeth = pinion;
            asked.proposal.gear_teeth   = std::lround(ratio * pinion);
            asked.proposal.module       = 4.5;
            asked.shaft_angle           = angle * degree;
            GearPairOptions pair;
            if (!message_of([&]() { pair = asked.completed(); }).empty())
              continue; // no such pair
            const std::string message = message_of([&]() {
              check_gear_body("pinion",
                              open(pinion_body_defaults(), pair.pinion.blank),
                              pair.pinion.blank);
              check_gear_body("gear", open(GearBodyOptions(), pair.gear.blank), pair.gear.blank);
            });
            if (!message.empty())
              misfit = std::to_string(pinion) + "/" + std::to_string(asked.proposal.gear_teeth) +
                       " at " + std::to_string(angle) + " deg: " + message;
          }
    check("default bodies of pairs from 30 to 120 deg fit" + misfit, misfit.empty());

    GearPairOptions asked;
    asked.proposal.pinion_teeth = 19;
    asked.proposal.gear_teeth   = 43;
    asked.proposal.module       = 4.5;
    asked.shaft_angle           = 45. * degree;
    const BlankOutline blank    = asked.completed().gear.blank;
    GearBodyOptions    back     = open(GearBodyOptions(), blank);
    check("at 45 deg the web goes towards the apex", back.web_direction == WebDirection::apex);
    back.web_direction = WebDirection::back;
    std::cout << message_of([&]() { check_gear_body("gear", back, blank); }) << std::endl;
    back.web_angle = 74. * degree;
    check("an angle that the message names fits",
          message_of([&]() { check_gear_body("gear", back, blank); }).empty());
  }
} // namespace

int main()
{
  reference_pair();
  fineness();
  proposed_pairs();
  shaft_angles();
  return 0;
}
