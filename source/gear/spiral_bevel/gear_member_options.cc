// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/parameters/parameters.h>
#include <vfife/gear/findings.h>
#include <vfife/gear/spiral_bevel/gear_member_options.h>

#include <cmath>

namespace vfife
{
  namespace
  {
    /** Point radii differ from the nominal cutter radius by the point width and by corrections of a
     * few per cent. */
    constexpr double cutter_tolerance = 0.05;

    /** The contact lies beside the pitch generatrix, for which the position of the cutter is
     * compared: 8 % in a proposed pair 9/33. */
    constexpr double position_tolerance = 0.1;

    /** Corrections of the machine settings change the spiral angle by less. */
    constexpr double spiral_tolerance = 4. * degree;

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

      /** A positive cradle angle cuts a left-hand member. */
      void examine_hand() const
      {
        const bool left = blank_.hand == Hand::left;
        if (blank_.hand != Hand::automatic && left != (settings_.cradle_angle > 0.))
          findings_.add(Findings::Action::stop,
                        section_ + "cradle angle",
                        {blank_section_ + "hand of spiral"},
                        text_of("Cradle angle ",
                                settings_.cradle_angle / degree,
                                " deg cuts a ",
                                name_of(opposite(blank_.hand)),
                                "-hand member, the blank is ",
                                name_of(blank_.hand),
                                "-hand"));
      }

      /** The machine is set to the root cone. */
      void examine_root_angle() const
      {
        const double g = settings_.machine_root_angle, root = blank_.root_angle;
        // a tilted cutter cuts the root cone with the blank tilted against it
        if (std::abs(g - root) > root_angle_tolerance + std::abs(settings_.cutter_tilt))
          findings_.add(Findings::Action::stop,
                        section_ + "machine root angle",
                        {blank_section_ + "root angle"},
                        text_of("Machine root angle ",
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

      /** Radius and spiral angle in the middle of the tooth, from the cutter's place on the cradle,
       * against the cutter's size and the blank's spiral angle. */
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
                        text_of("Point radius ",
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
                        text_of("radial distance ",
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

    /** Nominal cutter diameter against the point radii, and these against the blade edges. */
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
                     text_of("Cutter diameter ",
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
        findings.add(
          Findings::Action::stop,
          section + "/Concave flank/point radius",
          {section + "/Convex flank/point radius"},
          text_of("the point width ",
                  a - b,
                  " mm (outside less inside point radius) does not hold the rounded blade "
                  "edges, ",
                  edges,
                  " mm"));
    }
  } // namespace

  bool GearMemberOptions::is_spread_blade() const
  {
    return concave.radial_distance == convex.radial_distance &&
           concave.cradle_angle == convex.cradle_angle &&
           concave.blank_offset == convex.blank_offset &&
           concave.sliding_base == convex.sliding_base &&
           concave.machine_center_to_back == convex.machine_center_to_back &&
           concave.machine_root_angle == convex.machine_root_angle &&
           concave.ratio_of_roll == convex.ratio_of_roll &&
           concave.second_order_roll == convex.second_order_roll &&
           concave.third_order_roll == convex.third_order_roll &&
           concave.cutter_tilt == convex.cutter_tilt &&
           concave.cutter_swivel == convex.cutter_swivel;
  }

  MachineSettings GearMemberOptions::no_settings()
  {
    MachineSettings none;
    none.edge_radius = 0.; // the only entry whose default is a value
    return none;
  }

  GearMemberOptions GearMemberOptions::spread() const
  {
    // r = (diameter +- width) / 2, + for the outside blade
    GearMemberOptions member = *this;
    for (MachineSettings *flank : {&member.concave, &member.convex})
      {
        flank->take_over(both);
        if (flank->point_radius == 0. && cutter_diameter > 0. && point_width > 0.)
          flank->point_radius = (cutter_diameter + flank->sigma() * point_width) / 2;
      }
    return member;
  }

  void GearMemberOptions::examine_spread(const std::string &section, Findings &findings) const
  {
    const std::string both_section = section + "/Both flanks";
    // an entry for both flanks and a different one for one flank
    concave.examine_shared(both, both_section, section + "/Concave flank", findings);
    convex.examine_shared(both, both_section, section + "/Convex flank", findings);
    if (point_width > 0. && cutter_diameter == 0. &&
        (concave.point_radius == 0. || convex.point_radius == 0.))
      findings.add(Findings::Action::stop,
                   both_section + "/point width",
                   {},
                   "a point width needs the cutter diameter to give point radii");
    // a point width and point radii that do not fit it
    const double width = concave.point_radius - convex.point_radius;
    if (point_width > 0. && concave.point_radius > 0. && convex.point_radius > 0. &&
        std::abs(width - point_width) > 1e-6)
      findings.add(Findings::Action::stop,
                   both_section + "/point width",
                   {section + "/Concave flank/point radius",
                    section + "/Convex flank/point radius"},
                   "the point width is not the difference of the point radii, which are given too");
  }

  void GearMemberOptions::declare(dealii::ParameterHandler &prm)
  {
    declare_quantity(prm,
                     "cutter diameter",
                     cutter_diameter,
                     "mm",
                     "Nominal sum of outside and inside point radius",
                     Range::positive().or_word("not given"));
    declare_quantity(prm,
                     "tip chamfer",
                     blank.tip_chamfer,
                     "mm",
                     "Chamfer between flanks and top land: height, normal to the pitch cone, by "
                     "which the flanks end below the tip, and width of the top land that it takes "
                     "on either side; 0: sharp edges",
                     Range::not_negative());
    declare_section(prm, "Blank", blank);
    {
      Subsection subsection(prm, "Both flanks");
      declare_quantity(prm,
                       "point width",
                       point_width,
                       "mm",
                       "Point width: outside minus inside point radius, given together with the "
                       "cutter diameter instead of point radii",
                       Range::positive().or_word("not given"));
      both.declare_shared(prm);
    }
    declare_section(prm, "Concave flank", concave);
    declare_section(prm, "Convex flank", convex);
  }

  const char *section_of(const FlankSide side)
  {
    return side == FlankSide::concave ? "Concave flank" : "Convex flank";
  }

  CutterPosition::CutterPosition(const Blank &blank, const MachineSettings &settings)
  {
    // from the cutter's axis to the middle of the tooth: along and across the pitch generatrix
    const double S = settings.radial_distance, q = settings.cradle_angle;
    const double along = blank.mean_cone_distance +
                         settings.machine_center_to_back * std::cos(settings.machine_root_angle) -
                         S * std::cos(q);
    const double across = std::abs(S * std::sin(q) - settings.blank_offset);
    radius              = std::hypot(along, across);
    spiral_angle        = std::atan2(along, across);
  }

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

    // Where both flanks are cut at one machine root angle, the blank's root angle is the odd one.
    const double g = concave.machine_root_angle;
    if (g == convex.machine_root_angle && g > 0. && concave.cutter_tilt == 0. &&
        convex.cutter_tilt == 0. && std::abs(g - blank.root_angle) > root_angle_tolerance)
      findings.add(Findings::Action::stop,
                   section + "/Blank/root angle",
                   {section + "/Concave flank/machine root angle"},
                   text_of("Root angle ",
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
} // namespace vfife
