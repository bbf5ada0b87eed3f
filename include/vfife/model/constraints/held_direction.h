// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_model_constraints_held_direction_h
#define vfife_model_constraints_held_direction_h

#include <vfife/model/model.h>

#include <vector>

namespace vfife
{
  /** Which coordinate of a node a constraint prescribes. */
  enum class HeldCoordinate
  {
    along,  ///< along a direction that is fixed in space
    radius, ///< distance from the body's axis
    angle   ///< about the body's axis
  };

  /** One scalar equation n . u = g of a constraint for the small displacement u of a node. */
  struct HeldDirection
  {
    const Constraint *constraint = nullptr;
    HeldCoordinate    coordinate = HeldCoordinate::along;
    Vector3           direction  = Vector3::Zero(); ///< n: unit, at the undeformed place
    double            value      = 0;               ///< g, times the history [mm]
    double            rate       = 0; ///< what the speed of its body adds to g in a second [mm/s]
  };

  /**
   * The equations of @p constraint for a node of @p body at the undeformed @p place (fixed frame):
   * at most three, along directions at right angles. Kinds that leave a node free to turn hold
   * radius and axial position. At the axis itself whatever prescribes radius or angle holds both
   * directions across. Throws InputError for a radius that is to change there.
   */
  std::vector<HeldDirection>
  find_held_directions(const Constraint &constraint, const Body &body, const Vector3 &place);

  /** Sum of n n^T over those equations: the projector on what the constraint holds. */
  Matrix3
  compute_held_projector(const Constraint &constraint, const Body &body, const Vector3 &place);

  /** The direction of an equation for a node that has moved to @p place: r and theta are those of
   * the present place. */
  Vector3 present_direction(const HeldDirection &held, const Axis &axis, const Vector3 &place);

  /** Nodes at most this far from an axis lie on it [mm]: round-off of placements, and no cell is
   * as small. */
  constexpr double on_axis_distance = 1e-9;
} // namespace vfife

#endif
