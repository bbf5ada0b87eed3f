// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_dynamics_watch_damping_watch_h
#define vfife_dynamics_watch_damping_watch_h

#include <vfife/dynamics/rigid_velocity.h>
#include <vfife/dynamics/update_sums.h>
#include <vfife/model/state.h>

#include <vector>

namespace vfife
{
  class ByteStream;
  struct Model;

  /** Adds up over a run what the dampers do to each body, and how its two rates differ
   * (doc/theory/dynamics.md, The rate of a body). */
  class DampingWatch
  {
  public:
    explicit DampingWatch(const Model &model);

    /** Forgets everything: a new run begins at these @p rates of the bodies. */
    void reset(const std::vector<RigidVelocity> &rates);

    /** Looks at a step with its @p sums over all ranks. */
    void observe_step(const std::vector<BodySums> &sums);

    /** Looks at the mean speeds of the bodies in a sample, MotionSums::mean_speeds, beside their
     * momentum @p rates. */
    void observe_sample(const std::vector<double>        &mean_speeds,
                        const std::vector<RigidVelocity> &rates);

    /** Means over the steps and samples so far, and the drift to the present @p rates. */
    std::vector<DampingAudit> compute_audit(const std::vector<RigidVelocity> &rates) const;

    /** For checkpoints. */
    void serialize(ByteStream &stream);

  private:
    const Model               &model_;
    std::vector<RigidVelocity> rates_at_start_;
    std::vector<DampingAudit>  sums_; ///< not yet divided
    unsigned int               n_steps_ = 0, n_samples_ = 0;
  };
} // namespace vfife

#endif
