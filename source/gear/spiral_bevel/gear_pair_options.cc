// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/parameters/declared_section.h>
#include <vfife/base/parameters/parameters.h>
#include <vfife/gear/spiral_bevel/gear_pair_options.h>

#include <deal.II/base/parameter_handler.h>

#include <algorithm>
#include <cmath>

namespace vfife
{
  namespace
  {
    /** Printed angles have two decimals of a degree; two of them are compared. */
    constexpr double angle_tolerance = 0.02 * degree;

    /** Part of the sum of dedendum angles by which it may miss the duplex formula. */
    constexpr double duplex_tolerance = 0.15;

    /** Adds the paths of the entries of a member that have another value than their default. The
     * tip chamfer is none of those that make a pair. */
    void
    add_given(GearMemberOptions member, const std::string &section, std::vector<std::string> &paths)
    {
      member.blank.tip_chamfer = 0.;
      GearMemberOptions        nothing;
      dealii::ParameterHandler given, defaults;
      member.declare(given);
      nothing.declare(defaults);
      const auto values = find_declared(given).list_texts(&DeclaredSection::Entry::value, section);
      const auto others =
        find_declared(defaults).list_texts(&DeclaredSection::Entry::value, section);
      for (std::size_t i = 0; i < values.size(); ++i)
        if (values[i] != others[i])
          paths.push_back(values[i].first);
    }

    /** Blanks and settings beside a proposal, which sets them all. */
    void
    examine_proposal(const GearPairOptions &options, const std::string &section, Findings &findings)
    {
      std::vector<std::string> given;
      add_given(options.pinion, section + "/Pinion", given);
      add_given(options.gear, section + "/Gear", given);
      if (given.empty())
        return;
      constexpr std::size_t named = 5;
      std::string           others;
      for (std::size_t i = 1; i < std::min(given.size(), named); ++i)
        others += (i == 1 ? "; also given: " : ", ") + given[i].substr(section.size() + 1);
      if (given.size() > named)
        others += text_of(" and ", given.size() - named, " more");
      findings.add(Findings::Action::stop,
                   given[0],
                   {},
                   text_of("section ",
                           section,
                           "/Proposal sets blanks and machine settings. To change one of them, "
                           "start from pair.prm of a tooth contact analysis of the proposal",
                           others));
    }

    /** Whether numbers of teeth and shaft angle make an external pair; if not, says so. */
    bool
    examine_ratio(const GearPairOptions &options, const std::string &section, Findings &findings)
    {
      const unsigned int z1 = options.pinion.blank.teeth, z2 = options.gear.blank.teeth;
      if (z1 == 0 || z2 == 0 || pitch_angle_of(z2, z1, options.shaft_angle) < pi / 2)
        return true; // what is missing is reported as such
      std::string       entry;
      const std::string fault = find_ratio_fault(z1, z2, options.shaft_angle, entry);
      findings.add(Findings::Action::stop,
                   section + (entry == "shaft angle" ? "/Mounting/shaft angle"
                                                     : "/Gear/Blank/number of teeth"),
                   {},
                   fault);
      return false;
    }

    /** A pitch angle that is given against the one that teeth and shaft angle ask for. */
    void examine_pitch_angle(const Blank       &own,
                             const Blank       &other,
                             const double       shaft_angle,
                             const std::string &member,
                             const std::string &section,
                             Findings          &findings)
    {
      if (own.teeth == 0 || other.teeth == 0)
        return; // reported as missing
      const double expected = pitch_angle_of(own.teeth, other.teeth, shaft_angle);
      if (std::abs(expected - own.pitch_angle) > angle_tolerance)
        findings.add(Findings::Action::stop,
                     section + "/Blank/pitch angle",
                     {},
                     text_of("the ",
                             member,
                             "'s pitch angle ",
                             own.pitch_angle / degree,
                             " deg contradicts the numbers of teeth ",
                             own.teeth,
                             "/",
                             other.teeth,
                             " at a shaft angle of ",
                             shaft_angle / degree,
                             " deg, which give ",
                             expected / degree,
                             " deg"));
    }

    /** Blames the member whose cradle angle does not cut its hand either. */
    void
    examine_hands(const GearPairOptions &options, const std::string &section, Findings &findings)
    {
      const Hand hand = options.pinion.blank.hand;
      if (hand != options.gear.blank.hand || options.pinion.blank.teeth == 0)
        return; // without anything given the hand is a default
      const bool is_left     = hand == Hand::left;
      const bool pinion_fits = (options.pinion.concave.cradle_angle > 0.) == is_left;
      findings.add(Findings::Action::stop,
                   section + (pinion_fits ? "/Gear" : "/Pinion") + "/Blank/hand of spiral",
                   {},
                   hand == Hand::automatic
                     ? "is missing. Set it for the pinion or the gear"
                     : text_of("pinion and gear have the same hand of spiral, ", name_of(hand)));
    }

    /** Tip of one member against root of the other: clearance, and whether it is the same along the
     * face. */
    void examine_clearance(const Blank       &tip,
                           const Blank       &root,
                           const double       shaft_angle,
                           const std::string &tip_section,
                           const std::string &root_section,
                           Findings          &findings)
    {
      if (root.mean_dedendum <= tip.mean_addendum)
        findings.add(Findings::Action::stop,
                     root_section + "/Blank/mean dedendum",
                     {tip_section + "/Blank/mean addendum"},
                     text_of("no clearance: mean dedendum ",
                             root.mean_dedendum,
                             " mm against mean addendum ",
                             tip.mean_addendum,
                             " mm of the mating member"));
      const double sum = tip.face_angle + root.root_angle;
      if (std::abs(sum - shaft_angle) > root_angle_tolerance)
        findings.add(
          Findings::Action::warn,
          tip_section + "/Blank/face angle",
          {root_section + "/Blank/root angle",
           tip_section + "/Blank/pitch angle",
           root_section + "/Blank/pitch angle"},
          text_of("Face angle ",
                  tip.face_angle / degree,
                  " deg and the mating root angle ",
                  root.root_angle / degree,
                  " deg sum up to ",
                  sum / degree,
                  " deg instead of the shaft angle ",
                  shaft_angle / degree,
                  " deg: the clearance tapers along the face; the program uses the given angles"));
    }

    /** Taper of the depth against what a spread-blade gear cutter needs (duplex taper). */
    void
    examine_duplex(const GearPairOptions &options, const std::string &section, Findings &findings)
    {
      const Blank           &blank1 = options.pinion.blank, &blank2 = options.gear.blank;
      const MachineSettings &cut = options.gear.convex;
      if (!options.gear.is_spread_blade() || blank2.teeth == 0 || cut.radial_distance == 0.)
        return;
      const CutterPosition position(blank2, cut);
      const double         duplex =
        duplex_dedendum_angles(blank2, position.radius, position.spiral_angle, cut.blade_angle);
      const double sum =
        blank1.pitch_angle - blank1.root_angle + blank2.pitch_angle - blank2.root_angle;
      if (std::abs(sum - duplex) > duplex_tolerance * std::abs(duplex))
        findings.add(Findings::Action::warn,
                     section + "/Gear/Blank/root angle",
                     {section + "/Pinion/Blank/root angle",
                      section + "/Gear/Convex flank/blade angle",
                      section + "/Gear/Convex flank/cradle angle",
                      section + "/Gear/Convex flank/radial distance",
                      section + "/Gear/Convex flank/point radius",
                      section + "/Gear/Blank/pitch angle",
                      section + "/Pinion/Blank/pitch angle",
                      section + "/Gear/Blank/mean cone distance"},
                     text_of("the dedendum angles sum up to ",
                             sum / degree,
                             " deg, the duplex formula gives ",
                             duplex / degree,
                             " deg for this cutter: teeth and slots taper differently; the program "
                             "uses the given root angles"));
    }
  } // namespace

  void GearPairOptions::declare(dealii::ParameterHandler &prm)
  {
    declare_section(prm, "Proposal", proposal);
    declare_section(prm, "Pinion", pinion);
    declare_section(prm, "Gear", gear);
    {
      Subsection subsection(prm, "Mounting");
      declare_quantity(
        prm, "shaft angle", shaft_angle, "deg", "Nominal shaft angle", Range::between(20., 140.));
      declare_quantity(prm,
                       "backlash",
                       backlash,
                       "mm",
                       "Normal backlash at the mean point; the program adjusts the pinion's tooth "
                       "thickness to it",
                       Range::not_negative());
      declare_quantity(prm,
                       "pinion axial shift",
                       pinion_axial_shift,
                       "mm",
                       "Mounting error of the pinion along its axis, positive away from the apex");
      declare_quantity(prm,
                       "gear axial shift",
                       gear_axial_shift,
                       "mm",
                       "Mounting error of the gear along its axis, positive away from the apex");
      declare_quantity(
        prm,
        "offset",
        offset,
        "mm",
        "Mounting error of the pinion axis along +y of the fixed frame (gear axis x pinion axis)");
      declare_quantity(prm,
                       "shaft angle error",
                       shaft_angle_error,
                       "deg",
                       "Mounting error of the shaft angle, positive opens it",
                       Range::between(-1., 1.));
    }
    const Subsection subsection(prm, "Errors");
    declare_section(prm, "Pinion", pinion_errors);
    declare_section(prm, "Gear", gear_errors);
  }

  GearPairOptions GearPairOptions::completed() const
  {
    GearPairOptions options = *this;
    if (proposal.is_given())
      propose(proposal, shaft_angle, options.pinion, options.gear);
    // what one section says for both flanks
    options.pinion = options.pinion.spread();
    options.gear   = options.gear.spread();
    Blank &blank1 = options.pinion.blank, &blank2 = options.gear.blank;
    if (blank2.hand == Hand::automatic && blank1.hand != Hand::automatic)
      blank2.hand = opposite(blank1.hand);
    else if (blank1.hand == Hand::automatic && blank2.hand != Hand::automatic)
      blank1.hand = opposite(blank2.hand);
    if (blank1.teeth > 0 && blank2.teeth > 0)
      {
        // pitch angles from the numbers of teeth
        if (blank1.pitch_angle == 0.)
          blank1.pitch_angle = pitch_angle_of(blank1.teeth, blank2.teeth, shaft_angle);
        if (blank2.pitch_angle == 0.)
          blank2.pitch_angle = pitch_angle_of(blank2.teeth, blank1.teeth, shaft_angle);
      }
    // the gear's spread-blade cutter: the other point radius, and the ratio of roll of both flanks
    MachineSettings &concave = options.gear.concave, &convex = options.gear.convex;
    const double     diameter = options.gear.cutter_diameter;
    if (options.gear.is_spread_blade() && diameter > 0.)
      {
        if (concave.point_radius == 0. && convex.point_radius > 0.)
          concave.point_radius = diameter - convex.point_radius;
        else if (convex.point_radius == 0. && concave.point_radius > 0.)
          convex.point_radius = diameter - concave.point_radius;
      }
    for (MachineSettings *settings : {&concave, &convex})
      if (settings->ratio_of_roll == 0. && blank2.pitch_angle > 0.)
        settings->ratio_of_roll = settings->conjugate_ratio_of_roll(blank2.pitch_angle);
    return options;
  }

  void GearPairOptions::check(const std::string &section) const
  {
    examine(section).raise();
    const GearPairOptions options = completed();
    options.pinion.blank.check_tip_chamfer(section + "/Pinion");
    options.gear.blank.check_tip_chamfer(section + "/Gear");
    pinion_errors.check(section + "/Errors/Pinion", options.pinion.blank.teeth);
    gear_errors.check(section + "/Errors/Gear", options.gear.blank.teeth);
  }

  Findings GearPairOptions::examine(const std::string &section) const
  {
    Findings findings;
    if (proposal.is_given())
      {
        // what is proposed fits each other
        examine_proposal(*this, section, findings);
        return findings;
      }
    std::vector<std::string> given;
    add_given(pinion, "", given);
    add_given(gear, "", given);
    if (given.empty())
      {
        findings.add(Findings::Action::stop,
                     section + "/Proposal",
                     {},
                     "expected a gear pair, got none. Set blanks and machine settings (sections "
                     "Pinion and Gear), or basic data in section Proposal, such as\n"
                     "subsection Gear pair\n"
                     "  subsection Proposal\n"
                     "    set pinion teeth = 17\n"
                     "    set gear teeth   = 43\n"
                     "    set module       = 4.5 mm\n"
                     "  end\n"
                     "end");
        return findings;
      }
    const GearPairOptions options = completed();
    const Blank          &blank1 = options.pinion.blank, &blank2 = options.gear.blank;
    const std::string     pinion_section = section + "/Pinion", gear_section = section + "/Gear";
    // the ratio, from which all else follows; then each member alone, then one against the other
    if (!examine_ratio(options, section, findings))
      return findings;
    examine_pitch_angle(blank1, blank2, shaft_angle, "pinion", pinion_section, findings);
    examine_pitch_angle(blank2, blank1, shaft_angle, "gear", gear_section, findings);
    examine_hands(options, section, findings);
    pinion.examine_spread(pinion_section, findings);
    gear.examine_spread(gear_section, findings);
    options.pinion.examine(pinion_section, findings);
    options.gear.examine(gear_section, findings);

    if (std::abs(blank1.mean_cone_distance - blank2.mean_cone_distance) > 0.005 * blank2.face_width)
      findings.add(Findings::Action::stop,
                   pinion_section + "/Blank/mean cone distance",
                   {gear_section + "/Blank/mean cone distance"},
                   text_of("the mean cone distances ",
                           blank1.mean_cone_distance,
                           " mm of the pinion and ",
                           blank2.mean_cone_distance,
                           " mm of the gear differ"));
    examine_clearance(blank1, blank2, shaft_angle, pinion_section, gear_section, findings);
    examine_clearance(blank2, blank1, shaft_angle, gear_section, pinion_section, findings);
    examine_duplex(options, section, findings);
    if (!(backlash >= 0.))
      findings.add(Findings::Action::stop,
                   section + "/Mounting/backlash",
                   {},
                   text_of("Backlash ", backlash, " mm is negative"));
    return findings;
  }
} // namespace vfife
