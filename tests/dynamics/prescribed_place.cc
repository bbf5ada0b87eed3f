// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// Where prescribed angles put a node: a bead on a turning wire against its closed form, and turns
// of any size in one step.
#include "../parts.h"
#include "../tests.h"

#include <vfife/dynamics/motion/prescribed_place.h>

using namespace vfife;

const Axis    axis = {Vector3(1., 2., 3.), Vector3(2., -1., 2.) / 3.};
const Vector3 e_r = axis.direction.unitOrthogonal(), e_t = axis.direction.cross(e_r);
const double  start_radius = 20.;

Vector3 place(const double radius, const double angle, const double height)
{
  return axis.point + radius * (std::cos(angle) * e_r + std::sin(angle) * e_t) +
         height * axis.direction;
}

/** Angle, or radius and angle, of a node that begins at radius 20 and angle 0. */
HeldDirections hold(const bool with_radius)
{
  HeldDirections held;
  if (with_radius)
    held.push_back({nullptr, HeldCoordinate::radius, e_r, 0., 0.});
  held.push_back({nullptr, HeldCoordinate::angle, e_t, 0., 0.});
  return held;
}

/** Without a force r'' = omega^2 r: r = r_0 cosh(omega t). */
void bead()
{
  constexpr unsigned int n    = 200;
  const double           step = 1. / n; // omega dt
  const HeldDirections   held = hold(false);
  // x at -dt of the exact motion.
  Vector3 old = place(start_radius * std::cosh(step), -step, 5.), x = place(start_radius, 0., 5.);
  for (unsigned int i = 1; i <= n; ++i)
    {
      const Vector3 next = place_prescribed(axis,
                                            place(start_radius, 0., 5.),
                                            x,
                                            x + (x - old),
                                            held,
                                            {{start_radius * i * step, 0., 0.}});
      old                = x;
      x                  = next;
    }
  // Central differences, of second order: omega^2 dt^2/12 of some terms.
  check_below("bead on a turning wire, over its way",
              (x - place(start_radius * std::cosh(1.), 1., 5.)).norm() / start_radius,
              step * step);
}

void any_turn()
{
  const Vector3 start   = place(start_radius, 0., 5.);
  double        off_ray = 0, off_radius = 0, off_place = 0;
  for (int degrees = -175; degrees <= 175; degrees += 5)
    {
      const double angle = degrees * pi / 180;
      // The node has been at 10 degrees, and forces would take it outwards by 0.01 mm.
      const Vector3 old  = place(start_radius, pi / 18, 5.),
                    free = place(start_radius + .01, pi / 18, 5.02);
      const Vector3 x =
        place_prescribed(axis, start, old, free, hold(false), {{start_radius * angle, 0., 0.}});
      const double radius = (x - axis.point - 5.02 * axis.direction).norm();
      raise_to(off_ray, (x - place(radius, angle, 5.02)).norm());
      // At most what the last 0.1 rad add, 1/cos(0.1) - 1.
      off_radius = largest_of(off_radius, std::abs(radius / (start_radius + .01) - 1.));
      const Vector3 led =
        place_prescribed(axis, start, old, free, hold(true), {{.5, start_radius * angle, 0.}});
      raise_to(off_place, (led - place(start_radius + .5, angle, 5.02)).norm());
    }
  check_below("the node is on the ray [mm]", off_ray, 1e-12);
  check_below("it keeps its radius", off_radius, 5.1e-3);
  check_below("with a prescribed radius it is at its place [mm]", off_place, 1e-12);
}

int main()
{
  return run_parts({bead, any_turn});
}
