// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/gear/findings.h>
#include <vfife/gear/spiral_bevel/contact_search.h>
#include <vfife/gear/spiral_bevel/mean_contact.h>

#include <cmath>

namespace vfife
{
  namespace
  {
    /** Throws InputError where the mean contact @p point of @p flank is not on the tooth of
     * @p section. */
    void check_inside(const Flank          &flank,
                      const GeneratedPoint &point,
                      const Blank          &blank,
                      const std::string    &section)
    {
      const Vector2     L_h   = flank.cone_coordinates(point.position);
      const std::string entry = section + "/" + section_of(flank.side());
      if (!is_on_tooth(blank, L_h))
        throw InputError("Gear pair/" + entry,
                         text_of(entry,
                                 ": the contact nearest to the middle of the teeth, at L = ",
                                 L_h[0],
                                 " mm, h = ",
                                 L_h[1],
                                 " mm, lies outside the tooth (L ",
                                 blank.inner_cone_distance(),
                                 " to ",
                                 blank.outer_cone_distance,
                                 " mm, h ",
                                 -blank.dedendum(L_h[0]),
                                 " to ",
                                 blank.flank_tip(L_h[0]),
                                 " mm): the settings of the two flanks do not fit"));
      if (!flank.is_left(point))
        throw InputError("Gear pair/" + entry,
                         text_of(entry,
                                 ": the tooth is undercut at the mean contact point, L = ",
                                 L_h[0],
                                 " mm, h = ",
                                 L_h[1],
                                 " mm: later positions of the cutter take that point away"));
    }
  } // namespace

  FlankContact::Unknowns MeanContact::unknowns() const
  {
    FlankContact::Unknowns x;
    x << pinion.t, pinion.phi, rot1, gear.t, gear.phi, rot2;
    return x;
  }

  double MeanContact::lag(const MeshSide side,
                          const double   speed_ratio,
                          const double   rotation1,
                          const double   rotation2) const
  {
    const double deviation = rotation2 - rot2 + speed_ratio * (rotation1 - rot1);
    return side == MeshSide::drive ? deviation : -deviation;
  }

  MeanContact find_mean_contact(const GearPairOptions &options,
                                const MeshSide         side,
                                const FlankSide        pinion_side,
                                const FlankSide        gear_side)
  {
    const MachineSettings &settings = options.pinion.settings(pinion_side);
    const Flank gear_flank(options.gear.settings(gear_side), options.gear.blank.pitch_angle);
    const std::optional<ContactSearchResult> found = search_contact(settings, options, gear_flank);
    if (!found)
      throw InputError(
        std::string("Gear pair/Pinion/") + section_of(pinion_side) + "/ratio of roll",
        std::string("the pinion's ") + (side == MeshSide::drive ? "drive" : "coast") +
          " flank has no contact with the flank of the gear at the speed ratio of the teeth, "
          "neither on the teeth nor beyond them" +
          (settings.ratio_of_roll > 0. ? ". Check the ratio of roll" : ", for any ratio of roll"));

    // Points on both flanks and their common normal in the fixed frame.
    const FlankContact           &contact = found->contact;
    const FlankContact::Unknowns &x       = found->unknowns;
    MeanContact                   mean;
    mean.rot1          = x[FlankContact::rot1];
    mean.rot2          = x[FlankContact::rot2];
    mean.pinion        = contact.pinion().evaluate(x[FlankContact::t1], x[FlankContact::phi1]);
    mean.gear          = contact.gear().evaluate(x[FlankContact::t2], x[FlankContact::phi2]);
    mean.pinion_L_h    = contact.pinion().cone_coordinates(mean.pinion.position);
    mean.gear_L_h      = contact.gear().cone_coordinates(mean.gear.position);
    mean.ratio_of_roll = found->ratio_of_roll;

    const Matrix3 R = turned_frame(gear_frame(), mean.rot2).rotation;
    mean.position   = R * mean.gear.position;
    mean.normal     = -R * mean.gear.normal;
    mean.arm        = std::abs(mean.position.cross(mean.normal)[2]);
    check_inside(contact.pinion(), mean.pinion, options.pinion.blank, "Pinion");
    check_inside(contact.gear(), mean.gear, options.gear.blank, "Gear");
    return mean;
  }
} // namespace vfife
