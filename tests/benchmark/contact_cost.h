// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_tests_benchmark_contact_cost_h
#define vfife_tests_benchmark_contact_cost_h

#include <vfife/base/text/table.h>
#include <vfife/model/model.h>

namespace vfife
{
  class Communicator;
  class Log;

  /**
   * Processor time of the contact of a gear pair beside that of the rest of a step (internal forces
   * and nodal update), search included; medians of @p repeats measurements. The bodies turn at
   * their speeds, rigidly closed so far that about as much area touches as under the load of the
   * reference pair; forces are computed, not followed.
   *
   * Columns: part, time [us] a step, share [%] of the step with contact.
   */
  Table measure_contact_cost(const Model        &model,
                             unsigned int        repeats,
                             const Communicator &communicator,
                             Log                &log);
} // namespace vfife

#endif
