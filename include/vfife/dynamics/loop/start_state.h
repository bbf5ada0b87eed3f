// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_dynamics_loop_start_state_h
#define vfife_dynamics_loop_start_state_h

namespace vfife
{
  class VfifeOperator;
  struct Model;
  struct State;

  /** Sets the undeformed bodies at time zero, in their places and with their masses; @p dt: step of
   * the run [s]. Velocities are those of set_initial_velocities(). */
  void start_undeformed(const Model &model, const VfifeOperator &vfife, double dt, State &state);

  /** Sets velocities at -dt/2: rigid motion at the bodies' rates plus the initial velocities of
   * their nodes. */
  void set_initial_velocities(const Model &model, double dt, State &state);
} // namespace vfife

#endif
