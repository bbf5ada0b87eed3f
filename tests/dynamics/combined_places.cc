// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// Places of led nodes: on all surfaces that hold them, reached along the old directions; forces
// along what is free; what has no place.
#include "../parts.h"
#include "../tests.h"

#include <vfife/dynamics/motion/prescribed_place.h>

using namespace vfife;

const Axis axis{Vector3(1., 2., 3.), Vector3(2., -1., 2.) / 3.};

Vector3 across(const Vector3 &place)
{
  const Vector3 arm = place - axis.point;
  return arm - axis.direction.dot(arm) * axis.direction;
}

HeldDirection hold(const HeldCoordinate coordinate, const Vector3 &start, const Vector3 &along)
{
  HeldDirection held;
  held.coordinate       = coordinate;
  const Vector3 tangent = axis.direction.cross(start - axis.point).normalized();
  held.direction        = coordinate == HeldCoordinate::along   ? along
                          : coordinate == HeldCoordinate::angle ? tangent
                                                                : Vector3(tangent.cross(axis.direction));
  return held;
}

void combined()
{
  const Vector3 start(31., -12., 9.), old = start + Vector3(.3, .2, -.4),
                                      free = start + Vector3(.5, .7, .2);
  const Vector3        oblique             = Vector3(1., 2., -1.).normalized();
  const HeldDirections held                = {hold(HeldCoordinate::radius, start, oblique),
                                              hold(HeldCoordinate::along, start, oblique)};
  const Vector3        x = place_prescribed(axis, start, old, free, held, {{.02, -.03, 0.}});
  check_close("radius and plane: radius [mm]", across(x).norm(), across(start).norm() + .02, 1e-13);
  check_close("radius and plane: along the normal [mm]", oblique.dot(x - start), -.03, 1e-13);
  const Vector3 e_r = across(old).normalized(), moved = x - free;
  check_below("radius and plane: moved along the old directions",
              std::abs(moved.dot(e_r.cross(oblique).normalized())),
              1e-13);
  const Vector3 force = project_free(axis, x, held, Vector3(3., 4., 5.));
  check_below("radius and plane: the force that is left",
              std::abs(force.dot(oblique)) + std::abs(force.dot(across(x).normalized())),
              1e-14);

  // Nearly parallel: a thousandth of a radian between plane and radius.
  const Vector3        tilted = (held[0].direction + 1e-3 * axis.direction).normalized();
  const HeldDirections narrow = {hold(HeldCoordinate::radius, start, oblique),
                                 hold(HeldCoordinate::along, start, tilted)};
  const Vector3 y = place_prescribed(axis, start, start, start + Vector3(1e-3, 0., 0.), narrow, {});
  check_close("nearly parallel: radius [mm]", across(y).norm(), across(start).norm(), 1e-13);
  check_below("nearly parallel: along the normal [mm]", tilted.dot(y - start), 1e-13);
}

void altogether()
{
  const Vector3        start(31., -12., 9.);
  const double         radius = across(start).norm(), turn = .4;
  const HeldDirections held = {hold(HeldCoordinate::angle, start, start),
                               hold(HeldCoordinate::along, start, axis.direction),
                               hold(HeldCoordinate::radius, start, start)};
  const Vector3        wanted =
    axis.point +
    (radius + .5) * (rotation_about(axis.direction, turn) * across(start).normalized()) +
    (axis.direction.dot(start - axis.point) + .1) * axis.direction;
  const Vector3 x = place_prescribed(
    axis, start, wanted, wanted + Vector3(.1, .1, -.2), held, {{turn * radius, .1, .5}});
  check_below("radius, angle and height [mm]", (x - wanted).norm(), 1e-13);
  check("nothing is free", project_free(axis, x, held, Vector3(1., 2., 3.)).isZero(0.));
}

void circle()
{
  // A free turn keeps its speed: the chords of all steps have one length.
  const Vector3        start(31., -12., 9.);
  const HeldDirections held = {hold(HeldCoordinate::radius, start, start)};
  Vector3              old = start, way = 2. * axis.direction.cross(across(start)).normalized();
  double               first = 0;
  for (unsigned int step = 0; step < 1000; ++step)
    {
      const Vector3 x = place_prescribed(axis, start, old, old + way, held, {});
      way             = x - old;
      old             = x;
      if (step == 0)
        first = way.norm();
    }
  check_ratio("circle: chord of the last step over that of the first", way.norm() / first, 1e-12);
  check_close("circle: radius [mm]", across(old).norm(), across(start).norm(), 1e-13);
}

void impossible()
{
  // A plane beside the circle.
  const Vector3        start(31., -12., 9.);
  const Vector3        radial = across(start).normalized();
  const HeldDirections held   = {hold(HeldCoordinate::radius, start, start),
                                 hold(HeldCoordinate::along,
                                    start,
                                    (radial + .1 * axis.direction.cross(radial)).normalized())};
  check("no common place: not a number",
        !place_prescribed(axis, start, start, start, held, {{0., 30., 0.}}).allFinite());
}

int main()
{
  return run_parts({combined, altogether, circle, impossible});
}
