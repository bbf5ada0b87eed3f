// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/parameters.h>
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
     * wrong. */
    constexpr double root_angle_tolerance = 0.25 * degree;

    /** Point radii differ from the nominal cutter radius by the point width and by corrections of a
     * few per cent. */
    constexpr double cutter_tolerance = 0.05;

    /** A message made of text and numbers. */
    template <typename... Parts>
    std::string text(const Parts &...parts)
    {
      std::ostringstream message;
      (message << ... << parts);
      return message.str();
    }

    void check_flank(const GearMemberOptions &member,
                     const MachineSettings   &settings,
                     const std::string       &section)
    {
      settings.check(section);
      const double g = settings.machine_root_angle, root = member.blank.root_angle;
      if (std::abs(g - root) > root_angle_tolerance)
        throw InputError(section + "/machine root angle",
                         text("Machine root angle ",
                              g / degree,
                              " deg contradicts the blank's root angle ",
                              root / degree,
                              " deg"));
      const bool left = member.blank.hand == Hand::left;
      if (left != (settings.cradle_angle > 0.))
        throw InputError(section + "/cradle angle",
                         text("Cradle angle ",
                              settings.cradle_angle / degree,
                              " deg cuts a ",
                              left ? "right" : "left",
                              "-hand member, the blank is ",
                              left ? "left" : "right",
                              "-hand"));
    }

    /** Both flanks of a slot are cut at once by one cutter in one position. */
    bool is_spread_blade(const GearMemberOptions &member)
    {
      const MachineSettings &a = member.concave, &b = member.convex;
      return a.radial_distance == b.radial_distance && a.cradle_angle == b.cradle_angle &&
             a.blank_offset == b.blank_offset && a.sliding_base == b.sliding_base &&
             a.machine_center_to_back == b.machine_center_to_back &&
             a.machine_root_angle == b.machine_root_angle && a.ratio_of_roll == b.ratio_of_roll;
    }
  } // namespace

  void GearMemberOptions::declare(dealii::ParameterHandler &prm)
  {
    declare_quantity(prm,
                     "cutter diameter",
                     cutter_diameter,
                     "mm",
                     "Sum of the outside and the inside point radius, nominally; 0: not given",
                     Range::not_negative());
    {
      Subsection subsection(prm, "Blank");
      blank.declare(prm);
    }
    {
      Subsection subsection(prm, "Concave flank");
      concave.declare(prm);
    }
    {
      Subsection subsection(prm, "Convex flank");
      convex.declare(prm);
    }
  }

  void GearMemberOptions::check(const std::string &section) const
  {
    blank.check(section + "/Blank");
    check_flank(*this, concave, section + "/Concave flank");
    check_flank(*this, convex, section + "/Convex flank");

    const double mean_diameter = concave.point_radius + convex.point_radius;
    if (cutter_diameter > 0. &&
        std::abs(mean_diameter - cutter_diameter) > cutter_tolerance * cutter_diameter)
      throw InputError(section + "/cutter diameter",
                       text("Cutter diameter ",
                            cutter_diameter,
                            " mm contradicts the point radii ",
                            concave.point_radius,
                            " and ",
                            convex.point_radius,
                            " mm, which sum up to ",
                            mean_diameter,
                            " mm"));
    if (is_spread_blade(*this))
      {
        const double point_width = concave.point_radius - convex.point_radius;
        const double edges       = concave.edge_width() + convex.edge_width();
        if (point_width < edges)
          throw InputError(
            section + "/Concave flank/point radius",
            text("the point width ",
                 point_width,
                 " mm (outside less inside point radius) does not hold the rounded blade edges, ",
                 edges,
                 " mm"));
      }
  }

  void GearPairOptions::declare(dealii::ParameterHandler &prm)
  {
    {
      Subsection subsection(prm, "Pinion");
      pinion.declare(prm);
    }
    {
      Subsection subsection(prm, "Gear");
      gear.declare(prm);
    }
    {
      Subsection subsection(prm, "Mounting");
      declare_quantity(
        prm,
        "backlash",
        backlash,
        "mm",
        "Normal backlash at the mean point; set by the thickness of the pinion's teeth",
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
  }

  GearPairOptions GearPairOptions::completed() const
  {
    GearPairOptions options = *this;
    Blank          &blank1 = options.pinion.blank, &blank2 = options.gear.blank;
    if (blank1.teeth > 0 && blank2.teeth > 0)
      {
        const double ratio = static_cast<double>(blank1.teeth) / blank2.teeth;
        if (blank1.pitch_angle == 0.)
          blank1.pitch_angle = std::atan(ratio);
        if (blank2.pitch_angle == 0.)
          blank2.pitch_angle = std::atan(1. / ratio);
      }
    MachineSettings &concave = options.gear.concave, &convex = options.gear.convex;
    const double     diameter = options.gear.cutter_diameter;
    if (is_spread_blade(options.gear) && diameter > 0.)
      {
        if (concave.point_radius == 0. && convex.point_radius > 0.)
          concave.point_radius = diameter - convex.point_radius;
        else if (convex.point_radius == 0. && concave.point_radius > 0.)
          convex.point_radius = diameter - concave.point_radius;
      }
    // Cradle and blank share the velocity along the pitch generatrix: the cradle's axis is normal
    // to the root cone.
    for (MachineSettings *settings : {&concave, &convex})
      if (settings->ratio_of_roll == 0. && blank2.pitch_angle > 0.)
        settings->ratio_of_roll = std::cos(blank2.pitch_angle - settings->machine_root_angle) /
                                  std::sin(blank2.pitch_angle);
    return options;
  }

  void GearPairOptions::check(const std::string &section) const
  {
    const GearPairOptions options = completed();
    const Blank          &blank1 = options.pinion.blank, &blank2 = options.gear.blank;
    options.pinion.check(section + "/Pinion");
    options.gear.check(section + "/Gear");

    if (std::abs(blank1.pitch_angle + blank2.pitch_angle - pi / 2) > angle_tolerance)
      throw InputError(section + "/Gear/Blank/pitch angle",
                       text("the pitch angles ",
                            blank1.pitch_angle / degree,
                            " and ",
                            blank2.pitch_angle / degree,
                            " deg do not sum up to a shaft angle of 90 deg"));
    const double ratio = static_cast<double>(blank1.teeth) / blank2.teeth;
    if (std::abs(std::atan(ratio) - blank1.pitch_angle) > angle_tolerance)
      throw InputError(section + "/Pinion/Blank/pitch angle",
                       text("the pinion's pitch angle ",
                            blank1.pitch_angle / degree,
                            " deg contradicts the numbers of teeth ",
                            blank1.teeth,
                            "/",
                            blank2.teeth,
                            ", which give ",
                            std::atan(ratio) / degree,
                            " deg"));
    if (blank1.hand == blank2.hand)
      throw InputError(section + "/Gear/Blank/hand of spiral",
                       "pinion and gear have the same hand of spiral");
    if (std::abs(blank1.mean_cone_distance - blank2.mean_cone_distance) > 0.005 * blank2.face_width)
      throw InputError(section + "/Pinion/Blank/mean cone distance",
                       text("the mean cone distances ",
                            blank1.mean_cone_distance,
                            " mm of the pinion and ",
                            blank2.mean_cone_distance,
                            " mm of the gear differ"));
    const auto check_clearance =
      [&](const Blank &tip, const Blank &root, const char *tip_name, const char *root_name) {
        if (root.mean_dedendum <= tip.mean_addendum)
          throw InputError(section + "/" + root_name + "/Blank/mean dedendum",
                           text("no clearance: mean dedendum ",
                                root.mean_dedendum,
                                " mm of the ",
                                root_name,
                                " against mean addendum ",
                                tip.mean_addendum,
                                " mm of the ",
                                tip_name));
      };
    check_clearance(blank1, blank2, "Pinion", "Gear");
    check_clearance(blank2, blank1, "Gear", "Pinion");
    if (!(backlash >= 0.))
      throw InputError(section + "/Mounting/backlash",
                       text("Backlash ", backlash, " mm is negative"));
  }
} // namespace vfife
