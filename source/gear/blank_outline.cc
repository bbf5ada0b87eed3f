// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/gear/blank_outline.h>

#include <cmath>

namespace vfife
{
  double BlankOutline::addendum(const double cone_distance) const
  {
    return mean_addendum +
           (cone_distance - mean_cone_distance) * std::tan(face_angle - pitch_angle);
  }

  double BlankOutline::flank_tip(const double cone_distance) const
  {
    return addendum(cone_distance) - tip_chamfer;
  }

  double BlankOutline::dedendum(const double cone_distance) const
  {
    return mean_dedendum +
           (cone_distance - mean_cone_distance) * std::tan(pitch_angle - root_angle);
  }

  double BlankOutline::pitch() const
  {
    return 2. * pi / teeth;
  }

  double BlankOutline::circular_pitch(const double cone_distance) const
  {
    // radius of the pitch line at L: r_0 + L sin d
    return pitch() * cone_distance * std::sin(pitch_angle) + pitch() * origin[0];
  }

  double BlankOutline::mean_module() const
  {
    return 2. * mean_cone_distance * std::sin(pitch_angle) / teeth + 2. * origin[0] / teeth;
  }

  double BlankOutline::outer_module() const
  {
    return circular_pitch(outer_cone_distance) / pi;
  }

  Vector2 BlankOutline::cone_coordinates(const Vector2 &r_z) const
  {
    return cone_direction(r_z - origin);
  }

  Vector2 BlankOutline::coordinates_of(const Vector3 &position) const
  {
    return cone_coordinates({std::hypot(position[0], position[1]), position[2]});
  }

  Vector2 BlankOutline::meridian_point(const Vector2 &L_h) const
  {
    return origin + meridian_direction(L_h);
  }

  Vector2 BlankOutline::cone_direction(const Vector2 &dr_dz) const
  {
    const double c = std::cos(pitch_angle), s = std::sin(pitch_angle);
    // L along (sin d, cos d) of (r, z), h along (cos d, -sin d)
    return {dr_dz[1] * c + dr_dz[0] * s, dr_dz[0] * c - dr_dz[1] * s};
  }

  Vector2 BlankOutline::meridian_direction(const Vector2 &dL_dh) const
  {
    const double c = std::cos(pitch_angle), s = std::sin(pitch_angle);
    return {dL_dh[0] * s + dL_dh[1] * c, dL_dh[0] * c - dL_dh[1] * s};
  }
} // namespace vfife
