// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/fem/system/held_directions.h>

namespace vfife
{
  Matrix3 held_directions(const Constraint &constraint, const Axis &axis, const Vector3 &point)
  {
    const Vector3 across  = axis.direction.cross(point - axis.point);
    const bool    on_axis = !(across.norm() > 0.);
    const Vector3 tangent = on_axis ? Vector3(Vector3::Zero()) : Vector3(across.normalized());
    switch (constraint.kind)
      {
      case ConstraintKind::free_rotation:
      case ConstraintKind::rigid_hub:
        // On the axis there is no tangent, and nothing is left free.
        return Matrix3::Identity() - tangent * tangent.transpose();
      case ConstraintKind::directions:
        {
          // Sum of e e^T over the directions e that are prescribed.
          Matrix3 axes = Matrix3::Identity(), held = Matrix3::Zero();
          if (constraint.cylindrical)
            // r, theta, z. On the axis r and theta are zero, what is held of them is added below.
            axes << tangent.cross(axis.direction), tangent, axis.direction;
          for (unsigned int c = 0; c < 3; ++c)
            if (constraint.prescribed[c])
              held += axes.col(c) * axes.col(c).transpose();
          if (constraint.cylindrical && on_axis &&
              (constraint.prescribed[0] || constraint.prescribed[1]))
            held += Matrix3::Identity() - axis.direction * axis.direction.transpose();
          return held;
        }
      default:
        return Matrix3::Identity();
      }
  }
} // namespace vfife
