// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_tests_gear_gap_search_h
#define vfife_tests_gear_gap_search_h

#include <vfife/gear/spiral_bevel/gear_pair.h>

#include <cmath>

/**
 * Gear rotation at which the generated flanks of a side touch at the rotation @p rot1 of the
 * generated pinion flank, from points alone, without normals and meshing equation: the smallest
 * angle (drive; coast: the largest one) about the gear axis between a point of the pinion and the
 * gear flank at the same (r, z), over a grid about (L, h) that shrinks onto the smallest one.
 */
inline double gap_search(const vfife::GearPair &pair,
                         const vfife::MeshSide  side,
                         const double           rot1,
                         vfife::Vector2         L_h)
{
  using namespace vfife;
  const double sign = side == MeshSide::drive ? 1. : -1.;
  // generated flanks with the errors that all teeth share
  const FlankContact contact = pair.flank_contact(side);
  const Flank       &pinion = contact.pinion(), &gear = contact.gear();
  const auto         angle = [&](const Vector2 &x) {
    const Vector3 P    = pair.pinion_placement(rot1)(pinion.point_at(x[0], x[1]).position);
    const Vector2 cone = gear.cone_coordinates(P);
    return sign * std::remainder(vfife::polar_angle(P) -
                                   vfife::polar_angle(gear.point_at(cone[0], cone[1]).position),
                                 2. * pi);
  };
  double size = 1., best = angle(L_h);
  for (unsigned int i = 0; i < 60; ++i)
    {
      const Vector2 center = L_h;
      bool          moved  = false;
      for (int j = -2; j <= 2; ++j)
        for (int k = -2; k <= 2; ++k)
          {
            const Vector2 x     = center + size / 2 * Vector2(j, 0.3 * k);
            const double  value = angle(x);
            if (value < best)
              {
                best  = value;
                L_h   = x;
                moved = true;
              }
          }
      if (!moved)
        size *= 0.6;
    }
  return sign * best;
}

#endif
