// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_dynamics_watch_motion_sums_h
#define vfife_dynamics_watch_motion_sums_h

#include <vfife/dynamics/motion/nodal_update.h>

#include <vector>

namespace vfife
{
  class Communicator;
  struct Model;

  /** Sums over all nodes of an instant, with the velocities half a step before it. */
  struct MotionSums
  {
    /** sum m v [N s] and sum m x x v about the fixed origin [N mm s]: what central differences
     * conserve. */
    Vector3 momentum = Vector3::Zero(), angular_momentum = Vector3::Zero();
    /** Of each body sum m |v|/r / sum m, r about its axis, nodes on it left out: never negative
     * [rad/s]; 0 for a body that does not turn on its axis. */
    std::vector<double> mean_speeds;
    /**
     * sum m |v+ - v- - the body's mean of it|^2/8 [mJ], v+ half a step after the instant. As v+ -
     * v- = a dt, a vibration of the circular frequency omega has (omega dt/2)^2 of its elastic
     * energy there: less than all of it in a stable run, more where central differences let a mode
     * grow, which their own energy, with m v+ . v-/2, does not see: it is conserved.
     */
    double alternating_energy = 0;
  };

  /**
   * Of all ranks, in one reduction; @p motions: of each body of the model, over the nodes that this
   * rank counts. Collective.
   */
  MotionSums sum_motion(const Model                    &model,
                        const std::vector<NodalMotion> &motions,
                        const Communicator             &communicator);
} // namespace vfife

#endif
