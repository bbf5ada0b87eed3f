// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_dynamics_rigid_velocity_h
#define vfife_dynamics_rigid_velocity_h

#include <vfife/base/types.h>

namespace vfife
{
  /** Velocity field of a rigid motion, u(x) = velocity + omega x x (x from the fixed frame's
   * origin). */
  struct RigidVelocity
  {
    Vector3 velocity = Vector3::Zero(); ///< of the point at the origin [mm/s]
    Vector3 omega    = Vector3::Zero(); ///< [rad/s]

    Vector3 at(const Vector3 &x) const
    {
      return velocity + omega.cross(x);
    }
  };
} // namespace vfife

#endif
