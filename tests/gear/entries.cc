// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// Entries of a pair that its files hardly ever set: pitch and spiral angles, settings for both
// flanks, modified roll and tilted cutter, the data of a proposal; what follows from each.
#include "../read_entries.h"
#include "../tests.h"
#include "paper_pair.h"

#include <vfife/base/errors.h>
#include <vfife/gear/unloaded_contact/contact_analysis.h>

using namespace vfife;

namespace
{
  GearPairOptions read(GearPairOptions options, const std::string &text)
  {
    read_entries(options, text);
    return options;
  }

  std::string in_section(const std::string &path, const std::string &lines)
  {
    const std::size_t end = path.find('/');
    return "subsection " + path.substr(0, end) + "\n" +
           (end == std::string::npos ? lines : in_section(path.substr(end + 1), lines)) + "end\n";
  }

  bool is_stopped(const GearPairOptions &options, const std::string &entry)
  {
    const Findings findings = options.examine();
    for (const Findings::Cause &cause : findings.causes())
      if (cause.action == Findings::Action::stop && cause.entry == "Gear pair/" + entry)
        return true;
    return false;
  }

  void blanks()
  {
    // 27 and 79 teeth at 75 deg: tan d1 = sin 75/(79/27 + cos 75); both add up to 75 deg.
    const GearPairOptions skew =
      read(paper::options(), "subsection Mounting\n set shaft angle = 75 deg\nend\n").completed();
    const double pinion = std::atan2(std::sin(75 * degree), 79. / 27 + std::cos(75 * degree));
    check_close("shaft angle: pinion's pitch angle", skew.pinion.blank.pitch_angle, pinion, 1e-15);
    check_close("shaft angle: both pitch angles",
                (skew.pinion.blank.pitch_angle + skew.gear.blank.pitch_angle) / degree,
                75.,
                1e-13);

    const std::string angle = "subsection Pinion\n subsection Blank\n  set pitch angle = ";
    check("pitch angle as by the teeth",
          !is_stopped(read(paper::options(), angle + "18.868999 deg\n end\nend\n"),
                      "Pinion/Blank/pitch angle"));
    check("another pitch angle",
          is_stopped(read(paper::options(), angle + "19 deg\n end\nend\n"),
                     "Pinion/Blank/pitch angle"));

    // The cutter's position says the spiral angle: S^2 = A^2 + r^2 - 2 A r sin b.
    const double A = 116.49, r = 95.25, S = 107.42;
    const double spiral = std::asin((A * A + r * r - S * S) / (2 * A * r)) / degree;
    const auto   stated = [](const double value) {
      return read(paper::options(),
                  in_section("Gear/Blank",
                             "set mean spiral angle = " + std::to_string(value) + " deg\n"));
    };
    check("mean spiral angle as the cutter stands",
          !is_stopped(stated(spiral), "Gear/Convex flank/cradle angle"));
    check("mean spiral angle five degrees off",
          is_stopped(stated(spiral + 5), "Gear/Convex flank/cradle angle"));
  }

  void check_settings(const std::string &name, const MachineSettings &cut)
  {
    check(name + ": blank offset, machine center to back [mm]",
          cut.blank_offset == 1. && cut.machine_center_to_back == -2.);
    const double phi = .1;
    check_close(name + ": rotation of the blank, Ra (phi - C phi^2 - D phi^3)",
                cut.blank_rotation(phi),
                3 * (.1 - .2 * .01 + .5 * .001),
                1e-15);
    check_close(name + ": its rate", cut.roll_rate(phi), 3 * (1 - .4 * .1 + 1.5 * .01), 1e-15);
    const double tilted = cut.cradle_angle - 20 * degree;
    check_below(name + ": direction of the tilt",
                (cut.tilt_direction() - Vector3(std::cos(tilted), std::sin(tilted), 0.)).norm(),
                1e-15);
    check_close(name + ": tilt [deg]", cut.cutter_tilt / degree, 10., 1e-14);
  }

  void flanks()
  {
    // The gear's blade and position stay; what both flanks share goes into each of them.
    const auto settings = [](const std::string &member, const std::string &flank) {
      return "subsection " + member + "\n subsection " + flank + R"(
    set blank offset = 1 mm
    set machine center to back = -2 mm
    set ratio of roll = 3
    set modified roll second order = 0.2
    set modified roll third order = -0.5
    set cutter tilt = 10 deg
    set cutter swivel = -20 deg
  end
end
)";
    };
    const GearPairOptions both =
      read(paper::options(), settings("Gear", "Both flanks")).completed();
    check_settings("both flanks, concave", both.gear.concave);
    check_settings("both flanks, convex", both.gear.convex);
    check("both flanks: the pinion's are left", both.pinion.concave.cutter_tilt == 0.);
    const GearPairOptions one = read(paper::options(), settings("Pinion", "Convex flank"));
    check_settings("one flank", one.pinion.convex);
    check("one flank: the other is left", one.pinion.concave.second_order_roll == 0.);
  }

  /** 17/43 teeth, module 4, and more of the section Proposal. */
  GearPairOptions propose(const std::string &more)
  {
    return read({}, R"(
subsection Proposal
  set pinion teeth = 17
  set gear teeth = 43
  set module = 4 mm
end
)" + more);
  }

  void basic_data()
  {
    const GearPairOptions plain = propose("").completed();
    const double          outer = 4 * 17 / (2 * std::sin(std::atan2(17., 43.)));
    check_close("outer cone distance [mm]", plain.gear.blank.outer_cone_distance, outer, 1e-12);
    check_close("face width: 0.3 of it [mm]", plain.gear.blank.face_width, .3 * outer, 1e-12);
    const double mean = .85 * outer;
    check_close("mean radius of the cutter: 0.82 of the mean cone distance [mm]",
                (plain.gear.concave.point_radius + plain.gear.convex.point_radius) / 2,
                .82 * mean,
                1e-9);
    check("hands", plain.pinion.blank.hand == Hand::left && plain.gear.blank.hand == Hand::right);

    const GearPairOptions right =
      propose("subsection Proposal\n set pinion hand = right\nend\n").completed();
    check("right hand",
          right.pinion.blank.hand == Hand::right && right.gear.blank.hand == Hand::left);
    check("right hand: cradle angles change sign",
          right.pinion.concave.cradle_angle < 0 && plain.pinion.concave.cradle_angle > 0);
    const GearPairOptions narrow =
      propose("subsection Proposal\n set face width = 0.02 m\nend\n").completed();
    check("face width [mm]",
          narrow.gear.blank.face_width == 20. && narrow.pinion.blank.face_width == 20.);

    const GearPairOptions cut = propose(R"(
subsection Proposal
  set face width = 20 mm
  set spiral angle = 30 deg
  set pressure angle = 22.5 deg
  set cutter radius = 70
end
)")
                                  .completed();
    const MachineSettings &gear = cut.gear.convex;
    check_close("cutter radius [mm]",
                (cut.gear.concave.point_radius + gear.point_radius) / 2,
                70.,
                1e-9);
    check_close("pressure angle: of the blades [deg]", gear.blade_angle / degree, 22.5, 1e-13);
    // Basic position on the root plane through the mean point, where a spread blade stands.
    const double A = cut.gear.blank.mean_cone_distance, S = gear.radial_distance;
    check_close("spiral angle by the cutter's place [deg]",
                std::asin((A * A + 4900 - S * S) / (2 * A * 70)) / degree,
                30.,
                .2);
  }

  void contact_of_a_proposal()
  {
    const GearPair        pair(propose(R"(
subsection Proposal
  set transmission error at half pitch = 6 arcsec
  set path direction = 30 deg
  set contact ellipse ratio = 0.3
end
)"));
    const ContactAnalysis a = analyse_contact(pair, MeshSide::drive, ContactAnalysisOptions());
    // as in tests/gear/pair_proposal
    check_close("lag at half a pitch [arcsec]", a.lag_polynomial[0] / 4. / arcsecond, 6., .03);
    check_close("path angle [deg]", std::abs(a.path_angle) / degree, 30., .05);
    check_close("ellipse length over face width",
                2 * a.mean.ellipse.semi_axes[0] / pair.gear().blank().face_width,
                .3,
                1e-7);
  }

  void analysis()
  {
    // As the section Operation says: the coast side works when the gear drives
    // forward.
    const auto read_analysis = [](const std::string &text) {
      ContactAnalysisOptions options;
      read_entries(options, text);
      return options;
    };
    const auto side = [&](const std::string &text) { return read_analysis(text).working_side(); };
    check("the pinion drives forward", side("") == MeshSide::drive);
    check("the pinion drives in reverse",
          side("subsection Operation\n set direction of rotation = reverse\nend\n") ==
            MeshSide::coast);
    check("the gear drives forward",
          side("subsection Operation\n set driving member = gear\nend\n") == MeshSide::coast);
    check("the gear drives in reverse",
          side("subsection Operation\n set driving member = gear\n"
               " set direction of rotation = reverse\nend\n") == MeshSide::drive);

    const GearPair pair(paper::options());
    const auto     coarse =
      read_analysis("subsection Tooth contact analysis\n set points per pitch = 8\nend\n");
    const auto fine =
      read_analysis("subsection Tooth contact analysis\n set points per pitch = 40\nend\n");
    const auto a = analyse_contact(pair, MeshSide::drive, coarse),
               b = analyse_contact(pair, MeshSide::drive, fine);
    // Points stand at whole parts of a pitch within the path, which is the same.
    const double length = b.path.back().pitches - b.path.front().pitches;
    check_close("points per pitch: 8", a.path.size() / length, 8., 1.5);
    check_close("points per pitch: 40", b.path.size() / length, 40., 1.5);
    check_close("the contact ratio is the same", a.contact_ratio / b.contact_ratio, 1., 1e-3);
  }
} // namespace

int main()
{
  blanks();
  flanks();
  basic_data();
  contact_of_a_proposal();
  analysis();
  return 0;
}
