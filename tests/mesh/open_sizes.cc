// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// Bodies whose sizes are left open: those of the reference pair come out as they are, and proposed
// pairs of any size get bodies that fit.
#include "../tests.h"
#include "paper_members.h"

#include <vfife/base/errors.h>
#include <vfife/gear/spiral_bevel/gear_pair_options.h>
#include <vfife/mesh/gear/gear_body_options.h>

using namespace vfife;

namespace
{
  GearBodyOptions open(GearBodyOptions options, const BlankOutline &blank)
  {
    options.leave_sizes_open();
    return options.with_open_sizes(blank);
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
    given               = given.with_open_sizes(paper::gear().blank());
    check("given sizes stay, the bore follows the hub",
          given.hub_radius == 48 && given.web_thickness == 4 && given.bore_radius == 40);
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
    body.web_angle = angle * pi / 180;
    try
      {
        open(pinion_body_defaults(), pair.pinion.blank).check("pinion", pair.pinion.blank);
        open(body, pair.gear.blank).check("gear", pair.gear.blank);
      }
    catch (const InputError &error)
      {
        return error.what();
      }
    return "fits";
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
} // namespace

int main()
{
  reference_pair();
  proposed_pairs();
}
