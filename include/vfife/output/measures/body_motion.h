// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_output_measures_body_motion_h
#define vfife_output_measures_body_motion_h

#include <vfife/base/types.h>

#include <vector>

namespace vfife
{
  class Communicator;
  struct Model;
  struct State;

  /** How a body has turned as a whole since time zero, and how fast it turns now. */
  struct BodyMotion
  {
    Matrix3 rotation = Matrix3::Identity(); ///< about the body's axis
    Vector3 rate     = Vector3::Zero();     ///< angular velocity, fixed frame [rad/s]
  };

  /**
   * Motion of each body about its axis, on all ranks (collective). Rotation: State::body_motion, as
   * for the probes; where the state has none, the mass-weighted best fit. Rate: momentum L_axis /
   * I_axis. Bodies that no bearing holds (turns_on_axis false) keep the identity and no rate.
   */
  std::vector<BodyMotion>
  compute_body_motions(const Model &model, const State &state, const Communicator &communicator);
} // namespace vfife

#endif
