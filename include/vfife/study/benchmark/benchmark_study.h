// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_study_benchmark_benchmark_study_h
#define vfife_study_benchmark_benchmark_study_h

#include <vfife/study/study_kind.h>

#include <memory>

namespace vfife
{
  struct BenchmarkOptions
  {
    unsigned int repeats = 7;  ///< measurements of each variant, medians are reported
    unsigned int steps   = 3;  ///< time steps a measurement
    unsigned int cells   = 52; ///< of the general mesh along each side
    unsigned int plain_elements =
      20000; ///< part of a mesh on which the plain implementation is measured

    void declare(dealii::ParameterHandler &prm);
  };

  /**
   * Study kind `benchmark`: element-steps per second of processor time, of whole time steps
   * (internal forces and nodal update, no contact) on the gear pair and on a mesh without two equal
   * elements, by frame, stiffness, layout and instruction set, beside what the core can do at that
   * moment and beside a plain implementation; then the share of the pair's contact in a step.
   * benchmark.csv and .json, contact_cost.csv and .json.
   */
  std::unique_ptr<StudyKind> make_benchmark_study();
} // namespace vfife

#endif
