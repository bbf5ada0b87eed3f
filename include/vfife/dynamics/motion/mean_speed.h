// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_dynamics_motion_mean_speed_h
#define vfife_dynamics_motion_mean_speed_h

#include <vfife/dynamics/rigid_velocity.h>

namespace vfife
{
  class Body;
  class Communicator;
  struct State;

  /**
   * The paper's Eq. (8): the rotation about the axis at the mass-weighted mean of |v|/r over the
   * nodes of body @p b of the model, r the distance to the axis. Unsigned as published (the sense
   * is that of the body's initial rate) and not torque-free; for comparison. Collective.
   */
  RigidVelocity compute_mean_speed_rate(const Body         &body,
                                        const State        &state,
                                        unsigned int        b,
                                        const Communicator &communicator);
} // namespace vfife

#endif
