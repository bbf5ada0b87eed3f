// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// Reading a pair from parameters, and what is said about missing and contradictory entries.
#include "../read_entries.h"
#include "../tests.h"
#include "paper_pair.h"

#include <vfife/base/errors.h>

#include <functional>

using namespace vfife;

/** Changes the paper's pair; the message must be about @p entry and hold all @p words. */
void expect(const std::string                            &name,
            const std::function<void(GearPairOptions &)> &change,
            const std::string                            &entry,
            const std::vector<std::string>               &words)
{
  GearPairOptions options = paper::options();
  change(options);
  std::string message = "accepted";
  bool        found   = false;
  try
    {
      const GearPair pair(options);
    }
  catch (const InputError &error)
    {
      message = error.entry() + ": " + error.what();
      found   = error.entry() == "Gear pair/" + entry;
      for (const std::string &word : words)
        found = found && has_text(std::string(error.what()), word);
    }
  check(name + (found ? "" : " (" + message + ")"), found);
}

void check_missing_entries()
{
  using Options = GearPairOptions;
  expect("nothing given",
         [](Options &o) { o = Options(); },
         "Proposal",
         {"expected a gear pair", "set pinion teeth"});
  expect("missing face width",
         [](Options &o) { o.gear.blank.face_width = 0; },
         "Gear/Blank/face width",
         {"missing"});
  expect("missing radial distance",
         [](Options &o) { o.pinion.convex.radial_distance = 0; },
         "Pinion/Convex flank/radial distance",
         {"missing"});
  expect("missing point radius",
         [](Options &o) { o.gear.cutter_diameter = 0; },
         "Gear/Concave flank/point radius",
         {"missing"});
}

void check_printed_contradictions()
{
  using Options = GearPairOptions;
  // the contradictions of the printed tables
  expect("printed gear root angle",
         [&](Options &o) { o.gear.blank.root_angle = 72.1 * degree; },
         "Gear/Blank/root angle",
         {"72.1 deg", "71.131 deg", "face angle?"});
  expect("printed pinion cutter diameter",
         [](Options &o) { o.pinion.cutter_diameter = 152.4; },
         "Pinion/cutter diameter",
         {"152.4", "94.01", "96.18"});
  expect("one gear point radius",
         [](Options &o) { o.gear.concave.point_radius = 94.26; },
         "Gear/Concave flank/point radius",
         {"point width 0 mm"});
}

void check_other_contradictions()
{
  using Options = GearPairOptions;
  // further ones
  expect("face angle below the pitch angle",
         [&](Options &o) { o.pinion.blank.face_angle = 18. * degree; },
         "Pinion/Blank/face angle",
         {"18 deg", "18.869 deg"});
  expect("mean cone distance",
         [](Options &o) { o.pinion.blank.mean_cone_distance = 120.; },
         "Pinion/Blank/mean cone distance",
         {"120 mm", "116.491 mm"});
  expect("face width",
         [](Options &o) { o.gear.blank.face_width = 140.; },
         "Gear/Blank/face width",
         {"140", "131.491"});
  expect("pitch angles and teeth",
         [&](Options &o) {
           o.pinion.blank.pitch_angle = 19. * degree;
           o.gear.blank.pitch_angle   = 71. * degree;
         },
         "Pinion/Blank/pitch angle",
         {"19 deg", "27/79", "18.869 deg"});
  expect("shaft angle",
         [&](Options &o) { o.gear.blank.pitch_angle = 71. * degree; },
         "Gear/Blank/pitch angle",
         {"90 deg"});
  expect("machine root angle",
         [&](Options &o) { o.pinion.convex.machine_root_angle = 19. * degree; },
         "Pinion/Convex flank/machine root angle",
         {"19 deg", "17.9 deg"});
  expect("hand against cradle angle",
         [&](Options &o) { o.pinion.convex.cradle_angle *= -1.; },
         "Pinion/Convex flank/cradle angle",
         {"48.81", "left-hand", "right-hand"});
  expect("equal hands",
         [&](Options &o) {
           o.pinion.blank.hand = Hand::left;
           o.pinion.concave.cradle_angle *= -1.;
           o.pinion.convex.cradle_angle *= -1.;
         },
         "Gear/Blank/hand of spiral",
         {"same hand"});
  expect("no hand",
         [](Options &o) { o.pinion.blank.hand = o.gear.blank.hand = Hand::automatic; },
         "Gear/Blank/hand of spiral",
         {"Set it for the pinion or the gear"});
  expect("no clearance",
         [](Options &o) { o.gear.blank.mean_dedendum = 3.; },
         "Gear/Blank/mean dedendum",
         {"3 mm", "3.34 mm"});
  expect("edge radius",
         [](Options &o) { o.gear.convex.edge_radius = 3.; },
         "Gear/Concave flank/point radius",
         {"edges"});
  expect("backlash", [](Options &o) { o.backlash = -0.1; }, "Mounting/backlash", {"negative"});
  expect("no tooth left",
         [](Options &o) { o.backlash = 8.; },
         "Mounting/backlash",
         {"-6.4", "8 mm takes"});
}

/** The entries that are named as causes, in their order. */
std::string causes(const GearPairOptions &options, const Findings::Action action)
{
  std::string    list;
  const Findings findings = options.examine("");
  for (const Findings::Cause &cause : findings.causes())
    if (cause.action == action)
      list += (list.empty() ? "" : ", ") + cause.entry;
  return list;
}

/** Several contradictions come together; what follows from one is no cause of its own. */
void check_causes()
{
  GearPairOptions printed        = paper::options();
  printed.gear.blank.root_angle  = 72.1 * degree;
  printed.pinion.cutter_diameter = 152.4;
  std::cout << "printed tables: " << causes(printed, Findings::Action::stop) << std::endl;
  std::string message;
  try
    {
      printed.check();
    }
  catch (const InputErrors &errors)
    {
      message = errors.errors().size() == 2 ? errors.what() : "";
    }
  check("both in one message, consequences below",
        message.find("152.4") < message.find("72.1 deg is not below") &&
          message.find("72.1 deg is not below") < message.find("hence: Root angle 72.1 deg"));

  GearPairOptions several          = paper::options();
  several.pinion.blank.face_angle  = 0.;
  several.gear.convex.point_radius = 120.;
  several.pinion.convex.cradle_angle *= -1.;
  several.gear.blank.outer_cone_distance = 140.;
  several.backlash                       = -0.1;
  std::cout << "several: " << causes(several, Findings::Action::stop) << std::endl;

  GearPairOptions hand   = paper::options();
  hand.pinion.blank.hand = Hand::left;
  std::cout << "wrong hand: " << causes(hand, Findings::Action::stop) << std::endl;

  GearPairOptions cutter                = paper::options();
  cutter.pinion.concave.radial_distance = 130.;
  std::cout << "cutter position: " << causes(cutter, Findings::Action::stop) << std::endl;
  GearPairOptions spiral         = paper::options();
  spiral.gear.blank.spiral_angle = 35. * degree;
  std::cout << "spiral angle: " << causes(spiral, Findings::Action::stop) << std::endl;

  GearPairOptions taper         = paper::options();
  taper.pinion.blank.face_angle = 21. * degree;
  std::cout << "taper of the clearance, warning: " << causes(taper, Findings::Action::warn)
            << causes(taper, Findings::Action::stop) << std::endl;
  GearPairOptions duplex = paper::options();
  for (MachineSettings *settings : {&duplex.pinion.concave, &duplex.pinion.convex})
    settings->machine_root_angle = 17. * degree;
  duplex.pinion.blank.root_angle = 17. * degree;
  duplex.gear.blank.face_angle   = 73. * degree;
  std::cout << "duplex taper, warning: " << causes(duplex, Findings::Action::warn)
            << causes(duplex, Findings::Action::stop) << std::endl;
}

void check_reading()
{
  // what the file says arrives, with units
  GearPairOptions options = paper::options();
  read_entries(options,
               "subsection Pinion\n"
               "  subsection Blank\n"
               "    set number of teeth = 29\n"
               "    set hand of spiral = left\n"
               "    set face angle = 20.5 deg\n"
               "  end\n"
               "  subsection Concave flank\n"
               "    set ratio of roll = 3.1\n"
               "  end\n"
               "end\n"
               "subsection Gear\n"
               "  set cutter diameter = 152.4\n"
               "  subsection Convex flank\n"
               "    set point radius = 0.0943 m\n"
               "  end\n"
               "end\n"
               "subsection Mounting\n"
               "  set backlash = 150 um\n"
               "  set gear axial shift = -100 um\n"
               "  set shaft angle error = 0.5\n"
               "end\n");
  GearPairOptions other = paper::options();
  other.gear.blank.hand = Hand::automatic;
  check("the gear's hand follows from the pinion's",
        other.completed().gear.blank.hand == Hand::left);
  check("words arrive",
        options.pinion.blank.teeth == 29 && options.pinion.blank.hand == Hand::left);
  check_close("angle", options.pinion.blank.face_angle, 20.5 * degree, 1e-15);
  check_close("ratio of roll", options.pinion.concave.ratio_of_roll, 3.1, 0.);
  check_close("length in m", options.gear.convex.point_radius, 94.3, 1e-12);
  check_close("bare length", options.gear.cutter_diameter, 152.4, 0.);
  check_close("backlash in um", options.backlash, 0.15, 1e-15);
  check_close("gear axial shift in um", options.gear_axial_shift, -0.1, 1e-15);
  check_close("shaft angle error in degrees", options.shaft_angle_error, 0.5 * degree, 1e-15);
  check_close("what is not in the file stays", options.pinion.convex.radial_distance, 108.77, 0.);
}

/** A spread-blade gear given in one section is the same as one given for each flank. */
void check_both_flanks()
{
  GearPairOptions        options = paper::options(), shared = options;
  const MachineSettings &gear = options.gear.convex;
  shared.gear.concave         = MachineSettings(Blade::outside);
  shared.gear.convex          = MachineSettings(Blade::inside);
  const auto parse            = [&](GearPairOptions &target, const std::string &more) {
    read_entries(target,
                 "subsection Gear\n"
                            "  subsection Both flanks\n"
                            "    set point width = 1.98 mm\n"
                            "    set blade angle = 20 deg\n"
                            "    set blade edge radius = 0.8 mm\n"
                            "    set radial distance = 107.42 mm\n"
                            "    set cradle angle = 50.16 deg\n"
                            "    set sliding base = -0.5 mm\n"
                            "    set machine root angle = 69.44 deg\n"
                            "  end\n" +
                   more + "end\n");
  };
  parse(shared, "");
  const GearPairOptions completed = shared.completed();
  check_close("both flanks: inside point radius", completed.gear.convex.point_radius, 94.26, 1e-12);
  check_close("both flanks: outside point radius",
              completed.gear.concave.point_radius,
              96.24,
              1e-12);
  check("both flanks: settings arrive in each flank",
        completed.gear.convex.radial_distance == gear.radial_distance &&
          completed.gear.concave.sliding_base == gear.sliding_base &&
          completed.gear.convex.edge_radius == 0.8 && completed.gear.is_spread_blade());
  shared.check();
  completed.check();
  parse(shared, "  subsection Convex flank\n    set cradle angle = 50.2 deg\n  end\n");
  const auto causes = shared.examine().causes();
  check("both flanks: a flank that says otherwise is refused",
        causes.size() == 1 && causes.front().entry == "Gear pair/Gear/Convex flank/cradle angle");
}

int main()
{
  check_both_flanks();
  paper::options().check();
  check("the paper's pair is accepted", true);
  check_missing_entries();
  check_printed_contradictions();
  check_other_contradictions();
  check_causes();
  check_reading();
  return 0;
}
