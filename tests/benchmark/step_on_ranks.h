// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_tests_benchmark_step_on_ranks_h
#define vfife_tests_benchmark_step_on_ranks_h

#include <vfife/base/text/table.h>

namespace vfife
{
  class Communicator;
  struct Model;

  /** Measured times of one core [s]. */
  struct CoreTimes
  {
    double shared = 0, own = 0; ///< of an element and step, by what its constants are
    double contact_all    = 0;  ///< of the contact in a step: what each rank has to do
    double contact_shared = 0;  ///< and what ranks share
  };

  /** Time and bandwidth of messages between the first two ranks, there and back, by their length;
   * without rows on one rank. Collective. */
  Table measure_messages(const Communicator &communicator);

  /**
   * Largest computation and messages of a rank in a step for 1, 2, 4... 1,024 ranks, from the
   * partition itself, and the time of the step (doc/developer/performance.md, Many ranks).
   */
  Table estimate_steps(const Model &model, const CoreTimes &core);
} // namespace vfife

#endif
