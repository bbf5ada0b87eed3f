// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/parameters/parameters.h>
#include <vfife/gear/errors/flank_area.h>

namespace vfife
{
  void FlankMargins::declare(dealii::ParameterHandler &prm)
  {
    declare_number(prm,
                   "lengthwise margin",
                   lengthwise,
                   "Margin of the grid at toe and heel, as a part of the face width",
                   Range::between(0., 0.4));
    declare_number(prm,
                   "profile margin",
                   profile,
                   "Margin of the grid at tip and start of the flank, as a part of the flank's "
                   "height",
                   Range::between(0., 0.4));
  }

  FlankArea::FlankArea(const GearGeometry &gear, const FlankSide side, const FlankMargins &margins)
  {
    const BlankOutline &blank = gear.blank();
    toe_                      = blank.inner_cone_distance() + margins.lengthwise * blank.face_width;
    length_                   = (1. - 2. * margins.lengthwise) * blank.face_width;
    for (const unsigned int end : {0u, 1u})
      {
        const double  L     = toe_ + end * length_;
        const Vector3 start = gear.fillet_point(side, L, gear.fillet_end(side)).position;
        const double  low = blank.coordinates_of(start)[1], tip = blank.flank_tip(L);
        low_[end]  = low + margins.profile * (tip - low);
        high_[end] = tip - margins.profile * (tip - low);
      }
  }

  Vector2 FlankArea::place_of(const Vector2 &L_h) const
  {
    const double u    = (L_h[0] - toe_) / length_;
    const double low  = low_[0] + u * (low_[1] - low_[0]),
                 high = high_[0] + u * (high_[1] - high_[0]);
    return {u, (L_h[1] - low) / (high - low)};
  }

  Vector2 FlankArea::point_at(const Vector2 &u_v) const
  {
    const double u    = u_v[0];
    const double low  = low_[0] + u * (low_[1] - low_[0]),
                 high = high_[0] + u * (high_[1] - high_[0]);
    return {toe_ + u * length_, low + u_v[1] * (high - low)};
  }

  Vector2 FlankArea::slope_of(const Vector2 &u_v, const Vector2 &slope) const
  {
    // v = (h - low(u))/(high(u) - low(u)):
    //   dv/dh = 1/(high - low),   dv/du = -(low' + v (high' - low'))/(high - low)
    const double low_slope = low_[1] - low_[0], high_slope = high_[1] - high_[0];
    const double height = high_[0] - low_[0] + u_v[0] * (high_slope - low_slope);
    const double v_u    = -(low_slope + u_v[1] * (high_slope - low_slope)) / height;
    return {(slope[0] + slope[1] * v_u) / length_, slope[1] / height};
  }
} // namespace vfife
