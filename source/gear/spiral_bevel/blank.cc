// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/gear/findings.h>
#include <vfife/gear/spiral_bevel/blank.h>

#include <cmath>
#include <sstream>

namespace vfife
{
  namespace
  {
    /** The mean cone distance is printed with two decimals, the outer one often from the module. */
    constexpr double cone_distance_tolerance = 0.005;

    /** Of bevel gears, and that up to which the customary factors of proposals hold. */
    constexpr double largest_bevel_ratio = 10.;

    /** Numbers with units, for messages. */
    std::string degrees(const double angle)
    {
      std::ostringstream text;
      text << angle * 180. / pi << " deg";
      return text.str();
    }

    std::string millimetres(const double length)
    {
      std::ostringstream text;
      text << length << " mm";
      return text.str();
    }
  } // namespace

  const Choices<Hand> &hand_choices()
  {
    static const Choices<Hand> choices = {{"right", Hand::right}, {"left", Hand::left}};
    return choices;
  }

  const Choices<Hand> &hand_choices_or_auto()
  {
    static const Choices<Hand> choices = {{"auto", Hand::automatic},
                                          {"right", Hand::right},
                                          {"left", Hand::left}};
    return choices;
  }

  std::string name_of(const Hand hand)
  {
    return word_of(hand, hand_choices_or_auto());
  }

  Hand opposite(const Hand hand)
  {
    return hand == Hand::left ? Hand::right : Hand::left;
  }

  void Blank::declare(dealii::ParameterHandler &prm)
  {
    declare_integer(prm, "number of teeth", teeth, "Number of teeth; 0: not given");
    declare_choice(prm,
                   "hand of spiral",
                   hand,
                   hand_choices_or_auto(),
                   "Hand of spiral; auto: opposite to the hand of the mating member");
    const auto declare_angle =
      [&](const char *name, double &angle, const char *meaning, const char *open = "not given") {
        declare_quantity(prm, name, angle, "deg", meaning, Range::between(0., 90.).or_word(open));
      };
    declare_angle("pitch angle",
                  pitch_angle,
                  "Angle of the pitch cone to the axis; auto: derived from the numbers of teeth",
                  "auto");
    declare_angle("face angle", face_angle, "Angle of the tip cone to the axis");
    declare_angle("root angle", root_angle, "Angle of the root cone to the axis");
    const auto declare_length = [&](const char *name, double &length, const char *meaning) {
      declare_quantity(prm, name, length, "mm", meaning, Range::positive().or_word("not given"));
    };
    declare_length("mean cone distance",
                   mean_cone_distance,
                   "Pitch apex to mid-face along the pitch cone");
    declare_length("outer cone distance",
                   outer_cone_distance,
                   "Pitch apex to the heel along the pitch cone");
    declare_length("face width", face_width, "Face width along the pitch cone");
    declare_length("mean addendum",
                   mean_addendum,
                   "Tip over the pitch cone at the mean cone distance");
    declare_length("mean dedendum",
                   mean_dedendum,
                   "Root under the pitch cone at the mean cone distance");
    declare_angle("mean spiral angle",
                  spiral_angle,
                  "Mean spiral angle, compared with the one that the machine settings generate");
  }

  void Blank::examine(const std::string &section, Findings &findings) const
  {
    // what is missing says nothing about the rest
    const auto require = [&](const std::string &name, const double value) {
      if (!(value > 0.))
        findings.add_missing(section, name);
    };
    require("number of teeth", teeth);
    require("face angle", face_angle);
    require("root angle", root_angle);
    require("mean cone distance", mean_cone_distance);
    require("outer cone distance", outer_cone_distance);
    require("face width", face_width);
    require("mean addendum", mean_addendum);
    require("mean dedendum", mean_dedendum);

    const auto refuse_if = [&](const bool                      wrong,
                               const std::string              &name,
                               const std::vector<std::string> &others,
                               const std::string              &message) {
      std::vector<std::string> involved;
      for (const std::string &other : others)
        involved.push_back(section + "/" + other);
      if (wrong)
        findings.add(Findings::Action::stop, section + "/" + name, involved, message);
    };
    // surest findings first: numbers of teeth, then order of the cones, lengths, heights at the toe
    refuse_if(teeth < 5,
              "number of teeth",
              {},
              "Number of teeth " + std::to_string(teeth) + " is below 5");
    refuse_if(pitch_angle >= pi / 2,
              "pitch angle",
              {},
              "Pitch angle " + degrees(pitch_angle) + " is not below 90 deg");
    refuse_if(pitch_angle > 0. && root_angle >= pitch_angle,
              "root angle",
              {"pitch angle", "number of teeth"},
              "Root angle " + degrees(root_angle) + " is not below the pitch angle " +
                degrees(pitch_angle) + (root_angle > pitch_angle ? "; is it the face angle?" : ""));
    refuse_if(pitch_angle > 0. && face_angle <= pitch_angle,
              "face angle",
              {"pitch angle", "number of teeth"},
              "Face angle " + degrees(face_angle) + " is not above the pitch angle " +
                degrees(pitch_angle) + (face_angle < pitch_angle ? "; is it the root angle?" : ""));
    refuse_if(face_angle > pi / 2,
              "face angle",
              {},
              "Face angle " + degrees(face_angle) + " exceeds 90 deg");
    refuse_if(face_width >= outer_cone_distance,
              "face width",
              {"outer cone distance"},
              "Face width " + millimetres(face_width) + " is not below the outer cone distance " +
                millimetres(outer_cone_distance));
    const double middle = outer_cone_distance - face_width / 2;
    refuse_if(std::abs(mean_cone_distance - middle) > cone_distance_tolerance * face_width,
              "mean cone distance",
              {"outer cone distance", "face width"},
              "Mean cone distance " + millimetres(mean_cone_distance) +
                " contradicts outer cone distance less half the face width, " +
                millimetres(middle));
    const double inner = inner_cone_distance();
    refuse_if(addendum(inner) <= 0.,
              "mean addendum",
              {"face angle", "pitch angle", "number of teeth", "face width"},
              "Mean addendum " + millimetres(mean_addendum) + " with the face angle " +
                degrees(face_angle) + " leaves no addendum at the toe");
    refuse_if(dedendum(inner) <= 0.,
              "mean dedendum",
              {"root angle", "pitch angle", "number of teeth", "face width"},
              "Mean dedendum " + millimetres(mean_dedendum) + " with the root angle " +
                degrees(root_angle) + " leaves no dedendum at the toe");
  }

  void Blank::check_tip_chamfer(const std::string &section) const
  {
    const double most = addendum(inner_cone_distance());
    if (tip_chamfer != 0. && !(tip_chamfer > 0. && tip_chamfer < most))
      throw InputError(section + "/tip chamfer",
                       "expected less than the addendum at the toe, " + millimetres(most) +
                         ", got " + millimetres(tip_chamfer));
  }

  double pitch_angle_of(const double own_teeth, const double other_teeth, const double shaft_angle)
  {
    return std::atan2(std::sin(shaft_angle), other_teeth / own_teeth + std::cos(shaft_angle));
  }

  double
  equivalent_ratio(const double pinion_teeth, const double gear_teeth, const double shaft_angle)
  {
    const double pinion = pitch_angle_of(pinion_teeth, gear_teeth, shaft_angle);
    const double gear   = pitch_angle_of(gear_teeth, pinion_teeth, shaft_angle);
    return std::sqrt(gear_teeth * std::cos(pinion) / (pinion_teeth * std::cos(gear)));
  }

  std::string find_ratio_fault(const unsigned int pinion_teeth,
                               const unsigned int gear_teeth,
                               const double       shaft_angle,
                               std::string       &entry)
  {
    const auto fits = [&](const double angle) {
      return equivalent_ratio(pinion_teeth, gear_teeth, angle) <= largest_bevel_ratio + 1e-9;
    };
    const double      ratio = static_cast<double>(gear_teeth) / pinion_teeth;
    const std::string teeth = std::to_string(pinion_teeth) + "/" + std::to_string(gear_teeth);
    if (ratio > largest_bevel_ratio)
      {
        entry = "gear teeth";
        return text_of("the ratio of ",
                       teeth,
                       " teeth is ",
                       ratio,
                       ", above ",
                       largest_bevel_ratio,
                       ", the largest of bevel gears: at most ",
                       largest_bevel_ratio * pinion_teeth,
                       " teeth go with ",
                       pinion_teeth,
                       "; a larger ratio takes a second stage");
      }
    if (fits(shaft_angle))
      return {};
    entry = "shaft angle";
    // Down in whole degrees to an angle that does.
    double angle = std::floor(shaft_angle / degree);
    while (!fits(angle * degree))
      angle -= 1.;
    const double pitch_angle = pitch_angle_of(gear_teeth, pinion_teeth, shaft_angle);
    return text_of("a shaft angle of ",
                   degrees(shaft_angle),
                   " is too wide for ",
                   teeth,
                   " teeth: the gear's pitch angle would be ",
                   degrees(pitch_angle),
                   ", ",
                   pitch_angle > pi / 2 + 1e-9   ? "that of an internal gear (beyond 90 deg)"
                   : pitch_angle > pi / 2 - 1e-9 ? "that of a crown gear"
                                                 : "nearly that of a crown gear (90 deg)",
                   "; give at most ",
                   angle,
                   " deg, or fewer teeth of the gear");
  }

  double duplex_dedendum_angles(const Blank &gear,
                                const double cutter_radius,
                                const double spiral_angle,
                                const double blade_angle)
  {
    // Spread blades cut slots of constant width at the bottom; they taper in depth by so much that
    // the width at the pitch cone tapers as the circular pitch does.
    const double A      = gear.mean_cone_distance;
    const double module = 2. * A * std::sin(gear.pitch_angle) / gear.teeth;
    return pi * module / (2. * A) * (1. - A * std::sin(spiral_angle) / cutter_radius) /
           (std::tan(blade_angle) * std::cos(spiral_angle));
  }
} // namespace vfife
