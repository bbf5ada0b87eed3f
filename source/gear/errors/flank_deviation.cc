// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/gear/errors/flank_deviation.h>

namespace vfife
{
  double EaseOffTerms::value(const Vector2 &u_v) const
  {
    const double s = 2. * u_v[0] - 1., t = 2. * u_v[1] - 1.;
    return pressure_angle * t / 2 + spiral_angle * s / 2 - profile_crowning * t * t -
           lengthwise_crowning * s * s + bias * s * t / 4;
  }

  Vector2 EaseOffTerms::gradient(const Vector2 &u_v) const
  {
    // ds/du = dt/dv = 2
    const double s = 2. * u_v[0] - 1., t = 2. * u_v[1] - 1.;
    return {spiral_angle - 4. * lengthwise_crowning * s + bias * t / 2,
            pressure_angle - 4. * profile_crowning * t + bias * s / 2};
  }

  double FlankForm::value(const Vector2 &L_h) const
  {
    double sum = terms.value(area.place_of(L_h));
    if (topography)
      {
        const Vector2 u_v = topography->area.place_of(L_h);
        sum += topography->grid.value(u_v[0], u_v[1]);
      }
    return sum;
  }

  Vector2 FlankForm::slope(const Vector2 &L_h) const
  {
    const Vector2 place = area.place_of(L_h);
    Vector2       sum   = area.slope_of(place, terms.gradient(place));
    if (topography)
      {
        const Vector2 u_v = topography->area.place_of(L_h);
        sum += topography->area.slope_of(u_v, topography->grid.gradient(u_v[0], u_v[1]));
      }
    return sum;
  }

  FlankShift FlankShift::seen_turned(const double angle) const
  {
    const Matrix3 back = rotation_about(Vector3::UnitZ(), -angle);
    return {back * translation, back * rotation};
  }
} // namespace vfife
