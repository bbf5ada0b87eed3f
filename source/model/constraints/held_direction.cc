// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/model/constraints/held_direction.h>

namespace vfife
{
  namespace
  {
    /** Directions r, theta, z at a place off the axis, and the radius. */
    struct CylindricalPlace
    {
      double  radius;
      Vector3 e_r, e_theta;

      CylindricalPlace(const Axis &axis, const Vector3 &place)
      {
        const Vector3 across = axis.direction.cross(place - axis.point);
        radius               = across.norm();
        e_theta              = radius > on_axis_distance ? Vector3(across / radius)
                                                         : Vector3(axis.direction.unitOrthogonal());
        e_r                  = e_theta.cross(axis.direction);
      }
    };

    /** Equations of constraints that prescribe r, theta or z of the axis. */
    std::vector<HeldDirection> hold_cylindrical(const Constraint          &constraint,
                                                const Axis                &axis,
                                                const Vector3             &place,
                                                const std::array<bool, 3> &prescribed,
                                                const Vector3             &displacement)
    {
      std::vector<HeldDirection> held;
      const auto                 hold =
        [&](const HeldCoordinate coordinate, const Vector3 &direction, const double value) {
          held.push_back({&constraint, coordinate, direction, value, 0.});
        };
      const CylindricalPlace at(axis, place);
      if (at.radius > on_axis_distance)
        {
          if (prescribed[0])
            hold(HeldCoordinate::radius, at.e_r, displacement[0]);
          if (prescribed[1])
            hold(HeldCoordinate::angle, at.e_theta, at.radius * displacement[1]);
        }
      else if (prescribed[0] || prescribed[1])
        {
          // On the axis there is neither r nor theta, and what leads them leaves neither way free.
          if (prescribed[0] && displacement[0] != 0)
            throw InputError(
              "Model/Constraint " + constraint.name + "/displacement",
              "one of the nodes lies on the axis, where a radial displacement is impossible");
          hold(HeldCoordinate::along, at.e_r, 0.);
          hold(HeldCoordinate::along, at.e_theta, 0.);
        }
      if (prescribed[2])
        hold(HeldCoordinate::along, axis.direction, displacement[2]);
      return held;
    }

    /** x, y, z with a value and a rate along each. */
    std::vector<HeldDirection> hold_cartesian(const Constraint          &constraint,
                                              const std::array<bool, 3> &prescribed,
                                              const Vector3             &displacement,
                                              const Vector3             &rate)
    {
      std::vector<HeldDirection> held;
      for (unsigned int c = 0; c < 3; ++c)
        if (prescribed[c])
          held.push_back(
            {&constraint, HeldCoordinate::along, Vector3::Unit(c), displacement[c], rate[c]});
      return held;
    }
  } // namespace

  std::vector<HeldDirection>
  find_held_directions(const Constraint &constraint, const Body &body, const Vector3 &place)
  {
    const std::array<bool, 3> all  = {{true, true, true}};
    const Vector3             zero = Vector3::Zero();
    switch (constraint.kind)
      {
      case ConstraintKind::prescribed_rotation:
        {
          // A small rotation: angle times a x (X - c). The speed of the body goes on for ever.
          const Vector3 turn = body.axis.direction.cross(place - body.axis.point);
          return hold_cartesian(constraint,
                                all,
                                constraint.angle.value_or(0.) * turn,
                                constraint.angle ? zero : Vector3(body.rate * turn));
        }
      case ConstraintKind::free_rotation:
      case ConstraintKind::rigid_hub:
        return hold_cylindrical(constraint, body.axis, place, {{true, false, true}}, zero);
      case ConstraintKind::directions:
        return constraint.cylindrical
                 ? hold_cylindrical(
                     constraint, body.axis, place, constraint.prescribed, constraint.displacement)
                 : hold_cartesian(constraint, constraint.prescribed, constraint.displacement, zero);
      case ConstraintKind::held:
        break;
      }
    return hold_cartesian(constraint, all, zero, zero);
  }

  Matrix3
  compute_held_projector(const Constraint &constraint, const Body &body, const Vector3 &place)
  {
    Matrix3 projector = Matrix3::Zero();
    for (const HeldDirection &held : find_held_directions(constraint, body, place))
      projector += held.direction * held.direction.transpose();
    return projector;
  }

  Vector3 present_direction(const HeldDirection &held, const Axis &axis, const Vector3 &place)
  {
    if (held.coordinate == HeldCoordinate::along)
      return held.direction;
    const CylindricalPlace at(axis, place);
    return held.coordinate == HeldCoordinate::radius ? at.e_r : at.e_theta;
  }
} // namespace vfife
