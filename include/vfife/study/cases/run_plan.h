// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_study_cases_run_plan_h
#define vfife_study_cases_run_plan_h

namespace vfife
{
  struct DynamicsOptions;
  struct Model;
  struct OutputOptions;

  /** What is known of a study before it computes: checks look at what is there. */
  struct RunPlan
  {
    const Model           *model    = nullptr; ///< nullptr: there is no mesh
    const DynamicsOptions *dynamics = nullptr; ///< nullptr: nothing moves
    const OutputOptions   *output   = nullptr; ///< of a motion

    // Of explicit runs; zero of others.
    double element_step  = 0; ///< stable step of the elements times safety [s]
    double stable_step   = 0; ///< the same after the contact's vote [s]
    double step          = 0; ///< of the run [s]
    double expected_time = 0; ///< wall time of the run [s]
  };
} // namespace vfife

#endif
