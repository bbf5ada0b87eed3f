// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_dynamics_loop_state_stream_h
#define vfife_dynamics_loop_state_stream_h

#include <cstdint>

namespace vfife
{
  class ByteStream;
  class Communicator;
  struct State;

  /** The state in which a run begins. */
  struct RunBeginning
  {
    std::uint64_t step = 0;
    double        time = 0; ///< [s]
  };

  /** Passes times, motions, positions and velocities of a run, equal on all ranks, for checkpoints.
   * Refuses times that do not match the steps, and numbers that are not finite. Collective. */
  void pass_state(ByteStream         &stream,
                  const Communicator &communicator,
                  RunBeginning       &beginning,
                  State              &state);
} // namespace vfife

#endif
