// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_study_benchmark_rank_benchmark_h
#define vfife_study_benchmark_rank_benchmark_h

#include <vfife/base/parameter_handler.h>
#include <vfife/base/text/table.h>

namespace vfife
{
  class Communicator;
  struct Model;

  struct RankBenchmarkOptions
  {
    unsigned int largest_number = 1024;   ///< of ranks for which a step is reckoned
    double       latency        = 1.5e-6; ///< assumed of a message [s]
    double       bandwidth      = 10;     ///< assumed of a rank [GB/s]

    void declare(dealii::ParameterHandler &prm);
  };

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

  /** Their table without rows: messages.csv. */
  Table make_message_table();

  /**
   * For 1, 2, 4... ranks what the largest share of the model has to compute and to send in a step,
   * from the partition itself, and the time of a step that follows (doc/developer/performance.md,
   * Many ranks).
   */
  Table
  reckon_ranks(const Model &model, const RankBenchmarkOptions &options, const CoreTimes &core);

  /** Its table without rows: ranks.csv. */
  Table make_rank_table();
} // namespace vfife

#endif
