// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_tests_benchmark_operator_cost_h
#define vfife_tests_benchmark_operator_cost_h

#include "plain_elements.h"

#include <vfife/base/text/table.h>
#include <vfife/dynamics/operator/vfife_operator.h>
#include <vfife/model/model.h>

#include <array>
#include <memory>

namespace vfife
{
  /** Whole time steps of one operator, driven from outside. */
  class BenchmarkCase
  {
  public:
    BenchmarkCase(const std::string   &mesh,
                  const Model         &model,
                  StiffnessKind        stiffness,
                  OperatorLayout       layout,
                  const PlainElements &plain,
                  const Communicator  &communicator);

    /** Seconds of one step in the mean over @p steps: internal forces, and nodal update. */
    std::array<double, 2> measure(FrameKind frame, InstructionSet set, unsigned int steps);

    /** Seconds an element of the plain implementation, its update included. */
    double measure_plain(FrameKind frame);

    /** What one element and its share of nodes move between memory and core in a step, as STREAM
     * counts [bytes]. Shared constants are counted as held by the caches. */
    double bytes() const;

    std::string   mesh, layout;
    StiffnessKind stiffness;

  private:
    double update(InstructionSet set);

    const Model         &model_;
    const PlainElements &plain_;
    VfifeOperator        operator_;
    NodeField            positions_, velocities_, forces_;
    std::vector<double>  plain_positions_, plain_forces_;
  };

  /** Flops of one element in a frame, by counting the kernel. */
  double flops_of(FrameKind frame);

  /**
   * Measures all variants of @p cases in turn, @p repeats times, each round beside the ceilings of
   * the core; medians over the rounds, ratios being taken within a round.
   */
  Table compare_operators(std::vector<std::unique_ptr<BenchmarkCase>> &cases,
                          unsigned int                                 repeats,
                          unsigned int                                 steps);
} // namespace vfife

#endif
