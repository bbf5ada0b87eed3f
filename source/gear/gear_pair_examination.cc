// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/gear/gear_pair.h>

#include <cmath>
#include <sstream>

namespace vfife
{
  namespace
  {
    constexpr double degree = pi / 180.;

    /** Printed angles have two decimals of a degree; two of them are compared. */
    constexpr double angle_tolerance = 0.02 * degree;

    /** A root angle set on the machine deviates from the blank's by less than this unless one is
     * wrong; the same holds for cones of both members that run parallel. */
    constexpr double root_angle_tolerance = 0.25 * degree;

    /** Point radii differ from the nominal cutter radius by the point width and by corrections of a
     * few per cent. */
    constexpr double cutter_tolerance = 0.05;

    /** The contact lies beside the pitch generatrix, for which the position of the cutter is
     * compared: 8 % in a proposed pair 9/33. */
    constexpr double position_tolerance = 0.1;

    /** Corrections of the machine settings change the spiral angle by less. */
    constexpr double spiral_tolerance = 4. * degree;

    /** Part of the sum of dedendum angles by which it may miss the duplex formula. */
    constexpr double duplex_tolerance = 0.15;

    /** A message made of text and numbers. */
    template <typename... Parts>
    std::string text(const Parts &...parts)
    {
      std::ostringstream message;
      (message << ... << parts);
      return message.str();
    }

    const char *hand_name(const bool left)
    {
      return left ? "left" : "right";
    }

    /** Where the cutter stands to the middle of the tooth, from its position on the cradle. */
    struct CutterPosition
    {
      double radius = 0, spiral_angle = 0;

      CutterPosition(const Blank &blank, const MachineSettings &settings)
      {
        const double S = settings.radial_distance, q = settings.cradle_angle;
        const double along =
          blank.mean_cone_distance +
          settings.machine_center_to_back * std::cos(settings.machine_root_angle) - S * std::cos(q);
        const double across = std::abs(S * std::sin(q) - settings.blank_offset);
        radius              = std::hypot(along, across);
        spiral_angle        = std::atan2(along, across);
      }
    };

    /** Findings about one flank of a member. */
    class FlankExamination
    {
    public:
      FlankExamination(const GearMemberOptions &member,
                       const MachineSettings   &settings,
                       const std::string       &member_section,
                       const std::string       &flank,
                       Findings                &findings)
        : blank_(member.blank)
        , settings_(settings)
        , is_spread_blade_(member.is_spread_blade())
        , blank_section_(member_section + "/Blank/")
        , section_(member_section + "/" + flank + "/")
        , findings_(findings)
      {
      }

      void examine_hand() const
      {
        const bool left = blank_.hand == Hand::left;
        if (left != (settings_.cradle_angle > 0.))
          findings_.add(Findings::Action::stop,
                        section_ + "cradle angle",
                        {blank_section_ + "hand of spiral"},
                        text("Cradle angle ",
                             settings_.cradle_angle / degree,
                             " deg cuts a ",
                             hand_name(!left),
                             "-hand member, the blank is ",
                             hand_name(left),
                             "-hand"));
      }

      void examine_root_angle() const
      {
        const double g = settings_.machine_root_angle, root = blank_.root_angle;
        // a tilted cutter cuts the root cone with the blank tilted against it
        if (std::abs(g - root) > root_angle_tolerance + std::abs(settings_.cutter_tilt))
          findings_.add(Findings::Action::stop,
                        section_ + "machine root angle",
                        {blank_section_ + "root angle"},
                        text("Machine root angle ",
                             g / degree,
                             " deg contradicts the blank's root angle ",
                             root / degree,
                             " deg"));
      }

      /** Radius of the cutter where it cuts the pitch cone; of a spread-blade cutter, which stands
       * in the middle of the slot, less half a slot. */
      double cutting_radius(const CutterPosition &position) const
      {
        const double half_slot = is_spread_blade_ && blank_.teeth > 0
                                   ? pi * blank_.mean_cone_distance * std::sin(blank_.pitch_angle) /
                                       (2. * blank_.teeth) * std::cos(position.spiral_angle)
                                   : 0.;
        return settings_.point_radius +
               settings_.sigma() *
                 (blank_.mean_dedendum * std::tan(settings_.blade_angle) - half_slot);
      }

      void examine_cutter_position() const
      {
        const CutterPosition position(blank_, settings_);
        if (std::abs(position.radius - cutting_radius(position)) >
            position_tolerance * position.radius)
          findings_.add(Findings::Action::stop,
                        section_ + "point radius",
                        {section_ + "radial distance",
                         section_ + "cradle angle",
                         blank_section_ + "mean cone distance"},
                        text("Point radius ",
                             settings_.point_radius,
                             " mm cuts the pitch cone with a radius of ",
                             cutting_radius(position),
                             " mm, but radial distance ",
                             settings_.radial_distance,
                             " mm and cradle angle ",
                             settings_.cradle_angle / degree,
                             " deg put the cutter ",
                             position.radius,
                             " mm away from the middle of the tooth"));
        if (blank_.spiral_angle > 0. &&
            std::abs(position.spiral_angle - blank_.spiral_angle) > spiral_tolerance)
          findings_.add(Findings::Action::stop,
                        section_ + "cradle angle",
                        {section_ + "radial distance",
                         blank_section_ + "mean spiral angle",
                         section_ + "point radius"},
                        text("radial distance ",
                             settings_.radial_distance,
                             " mm and cradle angle ",
                             settings_.cradle_angle / degree,
                             " deg give a mean spiral angle of ",
                             position.spiral_angle / degree,
                             " deg, the blank has ",
                             blank_.spiral_angle / degree,
                             " deg"));
      }

    private:
      const Blank           &blank_;
      const MachineSettings &settings_;
      bool                   is_spread_blade_;
      std::string            blank_section_, section_;
      Findings              &findings_;
    };

    void examine_cutter_diameter(const GearMemberOptions &member,
                                 const std::string       &section,
                                 Findings                &findings)
    {
      const double a = member.concave.point_radius, b = member.convex.point_radius,
                   diameter = member.cutter_diameter;
      if (diameter > 0. && std::abs(a + b - diameter) > cutter_tolerance * diameter)
        findings.add(Findings::Action::stop,
                     section + "/cutter diameter",
                     {section + "/Concave flank/point radius",
                      section + "/Convex flank/point radius"},
                     text("Cutter diameter ",
                          diameter,
                          " mm contradicts the point radii ",
                          a,
                          " and ",
                          b,
                          " mm, which sum up to ",
                          a + b,
                          " mm; radial distance and cradle angle ask for ",
                          CutterPosition(member.blank, member.concave).radius +
                            CutterPosition(member.blank, member.convex).radius,
                          " mm"));
      if (!member.is_spread_blade())
        return;
      const double edges = member.concave.edge_width() + member.convex.edge_width();
      if (a - b < edges)
        findings.add(Findings::Action::stop,
                     section + "/Concave flank/point radius",
                     {section + "/Convex flank/point radius"},
                     text("the point width ",
                          a - b,
                          " mm (outside less inside point radius) does not hold the rounded blade "
                          "edges, ",
                          edges,
                          " mm"));
    }

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
                     text("the ",
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
                   text("pinion and gear have the same hand of spiral, ", hand_name(is_left)));
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
                     text("no clearance: mean dedendum ",
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
          text("Face angle ",
               tip.face_angle / degree,
               " deg and the mating root angle ",
               root.root_angle / degree,
               " deg sum up to ",
               sum / degree,
               " deg instead of the shaft angle ",
               shaft_angle / degree,
               " deg: the clearance tapers along the face; the angles are taken as given"));
    }

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
        findings.add(
          Findings::Action::warn,
          section + "/Gear/Blank/root angle",
          {section + "/Pinion/Blank/root angle",
           section + "/Gear/Convex flank/blade angle",
           section + "/Gear/Convex flank/cradle angle",
           section + "/Gear/Convex flank/radial distance",
           section + "/Gear/Convex flank/point radius",
           section + "/Gear/Blank/pitch angle",
           section + "/Pinion/Blank/pitch angle",
           section + "/Gear/Blank/mean cone distance"},
          text("the dedendum angles sum up to ",
               sum / degree,
               " deg, the duplex formula gives ",
               duplex / degree,
               " deg for this cutter: teeth and slots do not taper alike; the root angles "
               "are taken as given"));
    }
  } // namespace

  void GearMemberOptions::examine(const std::string &section, Findings &findings) const
  {
    blank.examine(section + "/Blank", findings);
    concave.examine(section + "/Concave flank", findings);
    convex.examine(section + "/Convex flank", findings);
    examine_cutter_diameter(*this, section, findings);
    const FlankExamination flanks[] = {{*this, concave, section, "Concave flank", findings},
                                       {*this, convex, section, "Convex flank", findings}};
    for (const FlankExamination &flank : flanks)
      flank.examine_hand();

    const double g = concave.machine_root_angle;
    if (g == convex.machine_root_angle && g > 0. && concave.cutter_tilt == 0. &&
        convex.cutter_tilt == 0. && std::abs(g - blank.root_angle) > root_angle_tolerance)
      findings.add(Findings::Action::stop,
                   section + "/Blank/root angle",
                   {section + "/Concave flank/machine root angle"},
                   text("Root angle ",
                        blank.root_angle / degree,
                        " deg contradicts the machine root angle ",
                        g / degree,
                        " deg of both flanks"));
    else
      for (const FlankExamination &flank : flanks)
        flank.examine_root_angle();
    for (const FlankExamination &flank : flanks)
      flank.examine_cutter_position();
  }

  Findings GearPairOptions::examine(const std::string &section) const
  {
    Findings findings;
    if (proposal.is_given() && (pinion.blank.teeth > 0 || gear.blank.teeth > 0))
      findings.add(Findings::Action::stop,
                   section + "/Proposal/pinion teeth",
                   {},
                   "a pair is proposed, but blanks are given as well; only one of them can be");
    const GearPairOptions options = completed();
    if (proposal.is_given())
      return findings; // blanks and settings that are proposed fit each other
    const Blank      &blank1 = options.pinion.blank, &blank2 = options.gear.blank;
    const std::string pinion_section = section + "/Pinion", gear_section = section + "/Gear";
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
                   text("the mean cone distances ",
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
                   text("Backlash ", backlash, " mm is negative"));
    return findings;
  }
} // namespace vfife
