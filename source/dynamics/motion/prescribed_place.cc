// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/dynamics/motion/prescribed_place.h>

#include <algorithm>
#include <cmath>

namespace vfife
{
  namespace
  {
    /** Radius, direction of r and height of a place relative to an axis. */
    struct Cylindrical
    {
      double  radius, height;
      Vector3 e_r, e_theta;

      Cylindrical(const Axis &axis, const Vector3 &x)
      {
        const Vector3 &a    = axis.direction;
        const Vector3  from = x - axis.point;
        height              = a.dot(from);
        const Vector3 flat  = from - height * a;
        radius              = flat.norm();
        // On the axis any direction is r.
        e_r     = radius > 0 ? Vector3(flat / radius) : Vector3(a.unitOrthogonal());
        e_theta = a.cross(e_r);
      }
    };
  } // namespace

  Vector3 place_prescribed(const Vector3                &start,
                           const Vector3                &free,
                           const PrescribedDisplacement &prescribed)
  {
    Vector3 x = free;
    for (unsigned int c = 0; c < 3; ++c)
      if (prescribed[c])
        x[c] = start[c] + *prescribed[c];
    return x;
  }

  Vector3 place_prescribed(const Axis                   &axis,
                           const Vector3                &start,
                           const Vector3                &old,
                           const Vector3                &free,
                           const PrescribedDisplacement &prescribed)
  {
    // Where the prescribed displacements put the radius and the ray from the axis, seen along it.
    const Cylindrical first(axis, start), last(axis, old);
    const Vector3     from   = free - axis.point;
    const double      radius = first.radius + prescribed[0].value_or(0.),
                 angle       = prescribed[1].value_or(0.);
    const Vector3 ray        = std::cos(angle) * first.e_r + std::sin(angle) * first.e_theta;

    // Seen along the axis, x* where forces alone put the node:
    //
    //   e_theta ^
    //           |       o<-----o x*    a radius R: back along the old e_r onto its circle, so that
    //    across |     / R              the way across, which is the turn, stays as it is
    //           +---/------> e_r       (e_r, e_theta at the place before the step)
    Vector3 flat = from - axis.direction.dot(from) * axis.direction;
    if (prescribed[0] && prescribed[1])
      flat = radius * ray;
    else if (prescribed[0])
      {
        // Along the old e_r until the radius fits: what lies across stays, R^2 = along^2 +
        // across^2.
        const double across = last.e_theta.dot(flat);
        flat = std::sqrt(std::max(0., radius * radius - across * across)) * last.e_r +
               across * last.e_theta;
      }
    else if (prescribed[1])
      // Along the old e_theta until the ray is met: what lies along the old e_r stays.
      flat = last.e_r.dot(flat) / last.e_r.dot(ray) * ray;
    const double height = prescribed[2] ? first.height + *prescribed[2] : axis.direction.dot(from);
    return axis.point + flat + height * axis.direction;
  }

  Vector3 project_free(const Axis                &axis,
                       const bool                 cylindrical,
                       const Vector3             &x,
                       const std::array<bool, 3> &prescribed,
                       const Vector3             &f)
  {
    // Columns: the prescribed directions at the present place.
    Matrix3 directions = Matrix3::Identity();
    if (cylindrical)
      {
        const Cylindrical place(axis, x);
        directions << place.e_r, place.e_theta, axis.direction;
      }
    Vector3 rest = f;
    for (unsigned int c = 0; c < 3; ++c)
      if (prescribed[c])
        rest -= directions.col(c).dot(f) * directions.col(c);
    return rest;
  }
} // namespace vfife
