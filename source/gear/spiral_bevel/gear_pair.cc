// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/gear/spiral_bevel/gear_pair.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace vfife
{
  namespace
  {
    /** The pinion's frame with the mounting errors; the shaft angle opens about y through the apex.
     */
    RigidMotion mounted_pinion_frame(const GearPairOptions &options)
    {
      // tilt about y through the apex, shift along the tilted axis, offset along y
      RigidMotion   frame = pinion_frame(options.shaft_angle);
      const Matrix3 tilt  = rotation_about(Vector3::UnitY(), options.shaft_angle_error);
      frame.rotation      = tilt * frame.rotation;
      frame.translation =
        options.pinion_axial_shift * frame.rotation.col(2) + options.offset * Vector3::UnitY();
      return frame;
    }

    /**
     * The equations of the mean contact have more than one solution. Throws InputError when that of
     * a proposed pair is not the one it was designed for: another lag or another contact ellipse.
     * @p contact has the flanks without errors of mounting.
     */
    void check_proposed_contact(const PairProposal &proposal,
                                const double        shaft_angle,
                                const Blank        &gear,
                                const MeshSide      side,
                                const MeanContact  &mean,
                                const FlankContact &contact)
    {
      const double ratio = static_cast<double>(proposal.pinion_teeth) / proposal.gear_teeth;
      const double step  = 0.1 * 2. * pi / proposal.pinion_teeth;

      // lag = lag'' phi^2 / 2 by second differences over a tenth of a pitch
      const auto follow = [&](const double turn) {
        FlankContact::Unknowns x = mean.unknowns();
        if (!contact.follow(mean.rot1 + turn, x))
          refuse_proposal(proposal,
                          shaft_angle,
                          "the flanks of the " + side_name(side) +
                            " side do not touch next to the mean contact");
        return x;
      };
      const auto lag_at = [&](const double turn) {
        const FlankContact::Unknowns x = follow(turn);
        return mean.lag(side, ratio, x[FlankContact::rot1], x[FlankContact::rot2]);
      };
      const double second     = lag_at(step) + lag_at(-step) - 2. * lag_at(0.);
      const double lag        = second / 2. * 25.; // half a pitch is five steps
      const double axis       = contact.ellipse(follow(0.), marking_thickness).semi_axes[0];
      const double asked_axis = proposal.ellipse_length * gear.face_width / 2.;

      // A wrong solution misses by factors or by the sign.
      constexpr double largest_factor = 2.;
      const auto       is_like        = [&](const double value, const double target) {
        return value > target / largest_factor && value < target * largest_factor;
      };
      if (is_like(lag, proposal.lag) && is_like(axis, asked_axis))
        return;
      std::ostringstream message;
      message << "the " << side_name(side)
              << " side does not touch as designed: lag at half a pitch " << lag / arcsecond
              << " arcsec instead of " << proposal.lag / arcsecond
              << ", major semi-axis of the ellipse " << axis << " mm instead of " << asked_axis;
      refuse_proposal(proposal, shaft_angle, message.str());
    }

    /** Throws InputError where the chamfers of a tooth leave less than a fifth of its top land. */
    void check_top_land(const GearMember &member, const std::string &section)
    {
      constexpr double largest_part = .8;
      const Blank     &blank        = member.blank();
      if (!(blank.tip_chamfer > 0.))
        return;
      for (const double L : {blank.inner_cone_distance(), blank.outer_cone_distance})
        {
          const double width = member.tooth_thickness(L, blank.addendum(L));
          const double most  = std::max(0., largest_part * width / 2.);
          if (blank.tip_chamfer > most)
            throw InputError(section + "/tip chamfer",
                             text_of("expected at most ",
                                     std::floor(100. * most) / 100.,
                                     " mm, because the top land without chamfers is ",
                                     width,
                                     " mm wide at cone distance ",
                                     L,
                                     " mm, got ",
                                     blank.tip_chamfer,
                                     " mm"));
        }
    }
  } // namespace

  Flank GearPair::Design::gear_flank(const FlankSide side) const
  {
    return Flank(options.gear.settings(side), options.gear.blank.pitch_angle);
  }

  GearPair::Design GearPair::derive(const GearPairOptions &options)
  {
    // 1. What the user gave, completed; contradictions stop here.
    options.check();
    Design design;
    design.options      = options.completed();
    const Blank &blank1 = design.options.pinion.blank, &blank2 = design.options.gear.blank;

    // 2. Which flanks meet. The pinion pushes with the flank that leads when it turns about + its
    // axis: the upper one; the gear, turning about -, is pushed on its upper one.
    design.gear_upper =
      is_on_lower_flank(
        design.gear_flank(FlankSide::concave).point_at(blank2.mean_cone_distance, 0.))
        ? FlankSide::convex
        : FlankSide::concave;
    design.pinion_upper = opposite(design.gear_upper);

    // 3. The mean contact of both sides, whose errors are told together; each may give the pinion
    // flank its ratio of roll.
    std::vector<InputError> errors;
    for (const MeshSide side : {MeshSide::drive, MeshSide::coast})
      try
        {
          const bool      drive       = side == MeshSide::drive;
          const FlankSide pinion_side = drive ? design.pinion_upper : opposite(design.pinion_upper);
          const FlankSide gear_side   = drive ? design.gear_upper : opposite(design.gear_upper);
          const MeanContact mean = find_mean_contact(design.options, side, pinion_side, gear_side);
          design.options.pinion.settings(pinion_side).ratio_of_roll = mean.ratio_of_roll;
          design.mean_contact[static_cast<unsigned int>(side)]      = mean;
        }
      catch (const InputError &error)
        {
          errors.push_back(error);
        }
    if (!errors.empty() && options.proposal.is_given())
      refuse_proposal(options.proposal, options.shaft_angle, errors.front().what());
    if (errors.size() == 1)
      throw errors.front();
    if (!errors.empty())
      throw InputErrors(errors);

    // 4. Backlash: at the rotation ratio the gear stands at rot2 + rot1 z1/z2 with each side's
    // contact; what these differ by, and the angle of the normal backlash, the pinion's lower flank
    // is turned back by (DELTA of doc/theory/gear.md).
    const MeanContact &drive = design.mean_contact[0], &coast = design.mean_contact[1];
    const double       ratio = static_cast<double>(blank1.teeth) / blank2.teeth;
    design.backlash_angle    = design.options.backlash / ((drive.arm + coast.arm) / 2);
    design.thickness_turn = ((coast.rot2 + coast.rot1 * ratio) - (drive.rot2 + drive.rot1 * ratio) +
                             design.backlash_angle) /
                            ratio;
    return design;
  }

  GearMember GearPair::make_pinion(const Design &design)
  {
    // the upper flank stays as generated, the lower one is turned
    const GearMemberOptions &own = design.options.pinion;
    const Flank              concave(own.concave, own.blank.pitch_angle),
      convex(own.convex, own.blank.pitch_angle);
    const bool is_concave = design.pinion_upper == FlankSide::concave;
    const auto turned     = [&](const double angle) {
      const double concave_turn = is_concave ? 0. : angle, convex_turn = is_concave ? angle : 0.;
      return GearMember("pinion", own.blank, concave, convex, concave_turn, convex_turn);
    };
    try
      {
        return turned(design.thickness_turn);
      }
    catch (const InputError &error)
      {
        if (design.options.proposal.is_given())
          refuse_proposal(design.options.proposal, design.options.shaft_angle, error.what());
        // Throws where no tooth is left without backlash either: then something else is wrong.
        const double taken =
          design.backlash_angle * design.options.gear.blank.teeth / own.blank.teeth;
        turned(design.thickness_turn - taken);
        std::ostringstream text;
        text << error.what() << "; a backlash of " << design.options.backlash << " mm takes "
             << taken * 180. / pi << " deg of it";
        throw InputError("Gear pair/Mounting/backlash", text.str());
      }
  }

  GearPair::GearPair(const GearPairOptions &options)
    : design_(derive(options))
    , pinion_frame_(pinion_frame(options.shaft_angle))
    , gear_frame_(gear_frame())
    , pinion_(make_pinion(design_))
    // the two flanks of one cut bound a slot; the tooth below it has the slot's lower flank as its
    // upper one
    , gear_("gear",
            design_.options.gear.blank,
            design_.gear_flank(FlankSide::concave),
            design_.gear_flank(FlankSide::convex),
            design_.gear_upper == FlankSide::concave ? 0.
                                                     : -2. * pi / design_.options.gear.blank.teeth,
            design_.gear_upper == FlankSide::concave ? -2. * pi / design_.options.gear.blank.teeth
                                                     : 0.)
  {
    check_top_land(pinion_, "Gear pair/Pinion");
    check_top_land(gear_, "Gear pair/Gear");
    // A proposal is checked as designed, before the errors of mounting.
    if (design_.options.proposal.is_given())
      for (const MeshSide side : {MeshSide::drive, MeshSide::coast})
        check_proposed_contact(design_.options.proposal,
                               options.shaft_angle,
                               gear_.blank(),
                               side,
                               mean_contact(side),
                               flank_contact(side));
    pinion_frame_ = mounted_pinion_frame(options);
    // the gear's only mounting error
    gear_frame_.translation[2] = options.gear_axial_shift;
    // Errors come last: they belong to the designed teeth.
    pinion_.set_errors(MemberErrors(options.pinion_errors, pinion_, "Gear pair/Errors/Pinion"));
    gear_.set_errors(MemberErrors(options.gear_errors, gear_, "Gear pair/Errors/Gear"));
  }

  const GearPairOptions &GearPair::options() const
  {
    return design_.options;
  }

  const GearMember &GearPair::pinion() const
  {
    return pinion_;
  }

  const GearMember &GearPair::gear() const
  {
    return gear_;
  }

  FlankSide GearPair::pinion_side(const MeshSide side) const
  {
    return side == MeshSide::drive ? design_.pinion_upper : opposite(design_.pinion_upper);
  }

  FlankSide GearPair::gear_side(const MeshSide side) const
  {
    return side == MeshSide::drive ? design_.gear_upper : opposite(design_.gear_upper);
  }

  double GearPair::speed_ratio() const
  {
    return static_cast<double>(pinion_.blank().teeth) / gear_.blank().teeth;
  }

  const MeanContact &GearPair::mean_contact(const MeshSide side) const
  {
    return design_.mean_contact[static_cast<unsigned int>(side)];
  }

  double GearPair::rot1_reference() const
  {
    return mean_contact(MeshSide::drive).rot1;
  }

  double GearPair::rot2_reference() const
  {
    return mean_contact(MeshSide::drive).rot2;
  }

  double GearPair::thickness_turn() const
  {
    return design_.thickness_turn;
  }

  double GearPair::backlash_angle() const
  {
    return design_.backlash_angle;
  }

  RigidMotion GearPair::pinion_placement(const double rotation) const
  {
    return turned_frame(pinion_frame_, rotation);
  }

  RigidMotion GearPair::gear_placement(const double rotation) const
  {
    return turned_frame(gear_frame_, rotation);
  }

  FlankContact GearPair::flank_contact(const MeshSide side) const
  {
    return contact_of(pinion_.shared_flank(pinion_side(side)), gear_.shared_flank(gear_side(side)));
  }

  FlankContact GearPair::flank_contact(const MeshSide     side,
                                       const unsigned int pinion_tooth,
                                       const unsigned int gear_tooth) const
  {
    return contact_of(pinion_.flank_of_tooth(pinion_side(side), pinion_tooth),
                      gear_.flank_of_tooth(gear_side(side), gear_tooth));
  }

  FlankContact GearPair::contact_of(const Flank &pinion, const Flank &gear) const
  {
    return FlankContact(
      pinion, gear, pinion_frame_, gear_frame_, speed_ratio(), gear_.blank().mean_cone_distance);
  }
} // namespace vfife
