// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/gear/spiral_bevel/gear_member.h>

#include <cmath>
#include <sstream>

namespace vfife
{
  namespace
  {
    /** The point on another tooth, or on tooth 0 as generated. */
    SurfacePoint turned(SurfacePoint point, const double angle)
    {
      const Matrix3 rotation = rotation_about(Vector3::UnitZ(), angle);
      point.position         = rotation * point.position;
      point.normal           = rotation * point.normal;
      return point;
    }

    /** A deviation of tooth 0 seen by the generated flank, which is turned by @p turn onto it. */
    FlankDeviation seen_by_generated(FlankDeviation deviation, const double turn)
    {
      deviation.shift = deviation.shift.seen_turned(turn);
      return deviation;
    }
  } // namespace

  GearMember::GearMember(std::string  name,
                         const Blank &blank,
                         const Flank &concave,
                         const Flank &convex,
                         const double concave_turn,
                         const double convex_turn)
    : name_(std::move(name))
    , blank_(blank)
    , concave_(concave)
    , convex_(convex)
    , concave_turn_(concave_turn)
    , convex_turn_(convex_turn)
  {
    // One flank must have its metal above it, the other below: the first is the lower one.
    const double       L             = blank.mean_cone_distance;
    const SurfacePoint concave_point = flank_point(FlankSide::concave, L, 0.);
    const SurfacePoint convex_point  = flank_point(FlankSide::convex, L, 0.);
    if (is_on_lower_flank(concave_point) == is_on_lower_flank(convex_point))
      throw InputError("the " + name_ + "'s concave and convex flank face the same way");
    lower_side_ = is_on_lower_flank(concave_point) ? FlankSide::concave : FlankSide::convex;

    // What is left of the pitch between them must be a tooth and a slot.
    const double sign  = lower_side_ == FlankSide::concave ? 1. : -1.;
    const double width = sign * std::remainder(polar_angle(convex_point.position) -
                                                 polar_angle(concave_point.position),
                                               2. * pi);
    if (width <= 0. || width >= pitch())
      {
        std::ostringstream message;
        message << "the " << name_ << "'s tooth is " << width * 180. / pi
                << " deg wide at its mean point, the pitch " << pitch() * 180. / pi << " deg";
        throw InputError(message.str());
      }
  }

  std::unique_ptr<GearGeometry> GearMember::clone() const
  {
    return std::make_unique<GearMember>(*this);
  }

  const std::string &GearMember::name() const
  {
    return name_;
  }

  const Blank &GearMember::blank() const
  {
    return blank_;
  }

  const Flank &GearMember::generated_flank(const FlankSide side) const
  {
    return side == FlankSide::concave ? concave_ : convex_;
  }

  double GearMember::turn(const FlankSide side) const
  {
    return side == FlankSide::concave ? concave_turn_ : convex_turn_;
  }

  FlankSide GearMember::lower_side() const
  {
    return lower_side_;
  }

  SurfacePoint GearMember::flank_point(const FlankSide side, const double L, const double h) const
  {
    return turned(generated_flank(side).point_at(L, h), turn(side));
  }

  SurfacePoint
  GearMember::fillet_point(const FlankSide side, const double L, const double lambda) const
  {
    return turned(generated_flank(side).fillet_at(L, lambda), turn(side));
  }

  double GearMember::fillet_end(const FlankSide side) const
  {
    return pi / 2 - generated_flank(side).settings().blade_angle;
  }

  bool GearMember::has_deviations() const
  {
    return errors_.any();
  }

  bool GearMember::has_equal_teeth() const
  {
    return errors_.equal_teeth();
  }

  double GearMember::deviation(const FlankSide     side,
                               const unsigned int  tooth,
                               const SurfacePoint &point) const
  {
    return errors_.any() ? errors_.value(side, tooth, point, blank_.coordinates_of(point.position))
                         : 0.;
  }

  void GearMember::set_errors(const MemberErrors &errors)
  {
    errors_ = errors;
  }

  const MemberErrors &GearMember::errors() const
  {
    return errors_;
  }

  Flank GearMember::flank_of_tooth(const FlankSide side, const unsigned int tooth) const
  {
    const Flank &flank = generated_flank(side);
    return errors_.any()
             ? flank.with_deviation(seen_by_generated(errors_.of_tooth(side, tooth), turn(side)))
             : flank;
  }

  Flank GearMember::shared_flank(const FlankSide side) const
  {
    const Flank &flank = generated_flank(side);
    return errors_.any() ? flank.with_deviation(errors_.shared(side)) : flank;
  }
} // namespace vfife
