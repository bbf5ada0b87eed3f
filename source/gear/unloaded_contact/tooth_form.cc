// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/gear/unloaded_contact/contact_analysis.h>
#include <vfife/gear/unloaded_contact/tooth_form.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace vfife
{
  namespace
  {
    /** Size of the surface element N . (X_t x X_phi): it vanishes where the flank turns back. */
    double surface_element(const Flank &flank, const GeneratedPoint &point)
    {
      const SurfaceDerivatives d = flank.derivatives(point.t, point.phi);
      return d.point.normal.dot(d.position_t.cross(d.position_phi));
    }

    /** Height h at which the fillet ends and the flank starts. */
    double fillet_end_height(const GearMember &member, const FlankSide side, const double L)
    {
      const SurfacePoint end = member.fillet_point(side, L, member.fillet_end(side));
      return member.generated_flank(side).cone_coordinates(end.position)[1];
    }

    /** Measures sections of one member; what is wrong with it goes to the findings. */
    class MemberMeasurement
    {
    public:
      MemberMeasurement(const GearMember  &member,
                        const Blank       &mate,
                        const std::string &section,
                        Findings          &findings)
        : member_(member)
        , mate_(mate)
        , section_(section)
        , findings_(findings)
      {
      }

      ToothSection measure(const std::string &place, const double L) const
      {
        ToothSection section;
        section.place         = place;
        section.cone_distance = L;
        // least over both flanks
        section.root_clearance  = std::numeric_limits<double>::infinity();
        section.fillet_distance = std::numeric_limits<double>::infinity();
        section.regularity      = std::numeric_limits<double>::infinity();
        bool reaches            = true;
        for (const FlankSide side : {FlankSide::concave, FlankSide::convex})
          reaches = measure_flank(side, section) && reaches;
        if (!reaches)
          return section;

        // The tip land is measured normal to the teeth: transverse thickness times cos b.
        const double tip   = member_.blank().addendum(L);
        section.thickness  = member_.tooth_thickness(L, 0.);
        const Flank &flank = member_.generated_flank(FlankSide::concave);
        section.tip_land   = (member_.tooth_thickness(L, tip) - 2. * member_.blank().tip_chamfer) *
                           std::cos(flank.spiral_angle(flank.point_at(L, tip)));
        if (section.tip_land <= 0.)
          findings_.add(Findings::Action::stop,
                        section_ + "/Blank/mean addendum",
                        {section_ + "/Blank/face angle"},
                        text_of("the flanks cross below the tip at the ",
                                place,
                                ": the tooth would be ",
                                section.tip_land,
                                " mm thick there"));
        return section;
      }

    private:
      /** Returns whether the flank reaches from root to tip. */
      bool measure_flank(const FlankSide side, ToothSection &section) const
      {
        const double      L     = section.cone_distance;
        const Flank      &flank = member_.generated_flank(side);
        const std::string place = " at the " + section.place;
        const std::string entry = section_ + "/" + section_of(side);
        const char       *edge  = "tip";
        try
          {
            const double reference =
              surface_element(flank, flank.point_at(L, member_.blank().flank_tip(L)));
            edge                      = "root";
            const GeneratedPoint end  = flank.fillet_at(L, member_.fillet_end(side));
            const double         root = flank.cone_coordinates(flank.fillet_at(L, 0.).position)[1];
            section.regularity =
              std::min(section.regularity, surface_element(flank, end) / reference);
            section.root_clearance = std::min(section.root_clearance, -mate_.addendum(L) - root);
          }
        catch (const InputError &error)
          {
            findings_.add(
              Findings::Action::stop,
              entry,
              {},
              text_of("the flank does not reach the ", edge, place, ": ", error.what()));
            return false;
          }
        if (section.regularity <= 0.)
          findings_.add(Findings::Action::warn,
                        entry + "/machine root angle",
                        {},
                        text_of("the flank is undercut", place, "; the generated flank is used"));
        if (section.root_clearance <= 0.)
          findings_.add(Findings::Action::warn,
                        entry + "/sliding base",
                        {},
                        text_of("the mating tip interferes with the root",
                                place,
                                ", clearance ",
                                section.root_clearance,
                                " mm"));
        return true;
      }

      const GearMember &member_;
      const Blank      &mate_;
      std::string       section_;
      Findings         &findings_;
    };
  } // namespace

  namespace
  {
    /** How far the mating tip stays away from the fillets on a side, at one cone distance. */
    void measure_fillet_distances(const GearPair &pair,
                                  const MeshSide  side,
                                  const double    L,
                                  ToothSection   &pinion,
                                  ToothSection   &gear)
    {
      const GearMember &one = pair.pinion(), &two = pair.gear();
      // the gear's tip touches the pinion here, were it not relieved
      const EaseOffPoint tip = measure_ease_off(pair, side, {L, two.blank().flank_tip(L)});
      if (tip.exists)
        pinion.fillet_distance =
          std::min(pinion.fillet_distance,
                   tip.pinion_L_h[1] -
                     fillet_end_height(one, pair.pinion_side(side), tip.pinion_L_h[0]));
      // the end of the gear's fillet would touch the pinion here: over its tip, it is hoped
      const EaseOffPoint end =
        measure_ease_off(pair, side, {L, fillet_end_height(two, pair.gear_side(side), L)});
      if (end.exists)
        gear.fillet_distance =
          std::min(gear.fillet_distance,
                   end.pinion_L_h[1] - one.blank().flank_tip(end.pinion_L_h[0]));
    }

    /** Warns where the mating tip meets the fillet. */
    void examine_fillet(const ToothSection &section, const std::string &member, Findings &findings)
    {
      if (section.fillet_distance < 0.)
        findings.add(Findings::Action::warn,
                     member + "/Concave flank/blade edge radius",
                     {},
                     text_of("the mating tip reaches ",
                             -section.fillet_distance,
                             " mm into the fillet at the ",
                             section.place,
                             ". Choose a smaller blade edge radius for more flank"));
    }
  } // namespace

  ToothForms measure_tooth_forms(const GearPair &pair)
  {
    // Three sections of both members, at the cone distances of the gear's toe, middle and heel.
    ToothForms              forms;
    const Blank            &gear = pair.gear().blank();
    const MemberMeasurement one(pair.pinion(), gear, "Pinion", forms.findings);
    const MemberMeasurement two(pair.gear(), pair.pinion().blank(), "Gear", forms.findings);
    const char             *places[]  = {"toe", "middle", "heel"};
    const double            lengths[] = {gear.inner_cone_distance(),
                                         gear.mean_cone_distance,
                                         gear.outer_cone_distance};
    for (unsigned int i = 0; i < 3; ++i)
      {
        forms.pinion[i] = one.measure(places[i], lengths[i]);
        forms.gear[i]   = two.measure(places[i], lengths[i]);
      }
    // Where the mating tips come to on flanks that reach from root to tip.
    if (forms.findings.causes().empty())
      for (unsigned int i = 0; i < 3; ++i)
        {
          for (const MeshSide side : {MeshSide::drive, MeshSide::coast})
            measure_fillet_distances(pair, side, lengths[i], forms.pinion[i], forms.gear[i]);
          examine_fillet(forms.pinion[i], "Pinion", forms.findings);
          examine_fillet(forms.gear[i], "Gear", forms.findings);
        }
    for (auto *member : {&forms.pinion, &forms.gear})
      for (ToothSection &section : *member)
        if (std::isinf(section.fillet_distance))
          section.fillet_distance = not_known;
    // Play: the gear's rotations on both sides, pinion held; the arm makes a length of it.
    const UnloadedContact drive(pair, MeshSide::drive), coast(pair, MeshSide::coast);
    const double          rot1 = pair.rot1_reference();
    try
      {
        forms.play = drive.touching(rot1).rot2 - coast.touching(rot1).rot2;
      }
    catch (const NumericalError &)
      {
        // As it is mounted, edges alone stop the gear on one side.
        forms.play = not_known;
      }
    forms.backlash =
      forms.play *
      (pair.mean_contact(MeshSide::drive).arm + pair.mean_contact(MeshSide::coast).arm) / 2;
    return forms;
  }

  EaseOffPoint measure_ease_off(const GearPair &pair, const MeshSide side, const Vector2 &gear_L_h)
  {
    const FlankContact   contact = pair.flank_contact(side);
    const MeanContact   &mean    = pair.mean_contact(side);
    const double         ratio   = pair.speed_ratio();
    const GeneratedPoint gear    = contact.gear().point_at(gear_L_h[0], gear_L_h[1]);

    // The gear turned to where its point satisfies the equation of meshing.
    EaseOffPoint result;
    double       rot2 = mean.rot2;
    result.exists =
      find_meshing_rotation(gear, contact.pinion_frame(), contact.gear_frame(), ratio, rot2);
    if (!result.exists)
      return result;
    // the pinion that runs with the exact ratio, and the point of it that would touch here
    const double      rot1      = mean.rot1 - (rot2 - mean.rot2) / ratio;
    const RigidMotion one       = turned_frame(contact.pinion_frame(), rot1);
    const Vector3     P         = turned_frame(contact.gear_frame(), rot2)(gear.position);
    const Vector3     conjugate = one.rotation.transpose() * (P - one.translation);
    result.pitches              = (rot1 - mean.rot1) / pair.pinion().pitch();
    result.pinion_L_h           = contact.pinion().cone_coordinates(conjugate);

    GeneratedPoint actual;
    try
      {
        actual = contact.pinion().point_at(result.pinion_L_h[0], result.pinion_L_h[1]);
      }
    catch (const InputError &)
      {
        // Beyond what the cutter leaves of the pinion's flank.
        result.ease_off = not_known;
        return result;
      }
    // the body's rotations repeat: bring both to the same one
    const double turn =
      std::remainder(polar_angle(conjugate) - polar_angle(actual.position), 2. * pi);
    const double r = std::hypot(conjugate[0], conjugate[1]);
    // ease-off = (arc between both about the axis) . n, > 0 where metal is missing
    // actual less conjugate about the axis, then along the normal into the metal
    const Vector3 tangential = Vector3(-conjugate[1], conjugate[0], 0.) / r;
    const Vector3 normal     = rotation_about(Vector3::UnitZ(), turn) * actual.normal;
    result.ease_off          = -turn * r * tangential.dot(normal);
    return result;
  }

  Table ease_off_table(const GearPair &pair)
  {
    constexpr unsigned int n_length = 24, n_height = 10;
    Table                  table;
    table.add_text_column("side");
    for (const char *column : {"gear L", "gear h", "pinion L", "pinion h"})
      table.add_column(column, "mm");
    table.add_column("pitches", "-");
    table.add_column("ease-off", "um");
    table.add_column("on pinion", "-");
    const Blank &one = pair.pinion().blank(), &two = pair.gear().blank();
    for (const MeshSide side : {MeshSide::drive, MeshSide::coast})
      for (unsigned int i = 0; i <= n_length; ++i)
        for (unsigned int j = 0; j <= n_height; ++j)
          {
            const double       L     = two.inner_cone_distance() + i * two.face_width / n_length;
            const double       low   = fillet_end_height(pair.gear(), pair.gear_side(side), L);
            const double       h     = low + j * (two.flank_tip(L) - low) / n_height;
            const EaseOffPoint point = measure_ease_off(pair, side, {L, h});
            if (!point.exists || std::isnan(point.ease_off))
              continue;
            const double L1 = point.pinion_L_h[0], h1 = point.pinion_L_h[1];
            const auto   edges = edge_distances(one, point.pinion_L_h);
            const bool   on_pinion =
              *std::min_element(edges.begin(), edges.end()) >= 0. &&
              h1 >= fillet_end_height(pair.pinion(), pair.pinion_side(side), L1);
            table.add_row({side_name(side),
                           L,
                           h,
                           L1,
                           h1,
                           point.pitches,
                           1e3 * point.ease_off,
                           on_pinion ? 1 : 0});
          }
    return table;
  }
} // namespace vfife
