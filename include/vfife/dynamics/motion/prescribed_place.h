// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_dynamics_motion_prescribed_place_h
#define vfife_dynamics_motion_prescribed_place_h

#include <vfife/model/constraints/held_direction.h>

#include <array>
#include <vector>

namespace vfife
{
  /** At most three independent equations for the place of a node. */
  using HeldDirections = std::vector<HeldDirection>;

  /**
   * The place nearest to @p free that meets the equations @p held, of a node that began at @p start
   * and was at @p old before the step: along a fixed direction n . (x - start) = g, for the radius
   * |x| = R + g, for the angle the ray at g/R from that of the start, g the @p values [mm]. The
   * node moves from @p free along the directions that the equations had at @p old, as the forces of
   * constraints of central differences act: a free rotation on a circle then keeps its speed
   * exactly. A prescribed angle may turn the node by anything: beyond 0.1 rad its motion is turned
   * about the axis first. Not a number where the equations have no common place: the guards of a
   * run, at which all ranks look together, tell of the node.
   */
  Vector3 place_prescribed(const Axis                  &axis,
                           const Vector3               &start,
                           const Vector3               &old,
                           const Vector3               &free,
                           const HeldDirections        &held,
                           const std::array<double, 3> &values);

  /** Takes out of the force @p f on a node at @p x what acts along held directions. */
  Vector3
  project_free(const Axis &axis, const Vector3 &x, const HeldDirections &held, const Vector3 &f);
} // namespace vfife

#endif
