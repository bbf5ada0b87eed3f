// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_study_benchmark_contact_benchmark_h
#define vfife_study_benchmark_contact_benchmark_h

#include <vfife/base/parameter_handler.h>
#include <vfife/base/text/table.h>
#include <vfife/model/model.h>

namespace vfife
{
  class Communicator;
  class Log;

  /** What the contact of a gear pair is measured at. */
  struct ContactBenchmarkOptions
  {
    double       closing = 0.012; ///< of the flanks at the mean contact [mm]
    unsigned int steps   = 200;   ///< of one measurement

    void declare(dealii::ParameterHandler &prm);
  };

  /**
   * Processor time of the contact of a gear pair beside that of the rest of a step (internal forces
   * and nodal update), search included; medians of @p repeats measurements. The bodies turn at
   * their speeds, rigidly closed so far that about as much area touches as under the load; forces
   * are computed, not followed.
   *
   * Columns: part, time [us] a step, share [%] of the step with contact.
   */
  Table measure_contact_cost(const Model                   &model,
                             const ContactBenchmarkOptions &options,
                             unsigned int                   repeats,
                             const Communicator            &communicator,
                             Log                           &log);

  /** Its table without rows: contact_cost.csv. */
  Table make_contact_cost_table();
} // namespace vfife

#endif
