// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_study_run_stepped_solver_h
#define vfife_study_run_stepped_solver_h

#include <vfife/base/process/timers.h>
#include <vfife/dynamics/loop/explicit_solver.h>

#include <functional>

namespace vfife
{
  struct RunSummary;

  /** The explicit solver of a model, ready for its first step: the step is chosen and set. */
  struct SteppedSolver
  {
    Timers         timers;
    ExplicitSolver solver;
    double         dt; ///< [s]

    /** The step, at most the stable one, which is given [s]. */
    using ChooseStep = std::function<double(double stable_step)>;

    /** What is given must outlive the object, but for @p choose_step. */
    SteppedSolver(const Model           &model,
                  const DynamicsOptions &options,
                  const Communicator    &communicator,
                  Log                   &log,
                  const ChooseStep      &choose_step);

    /** What limits the step, the penalties of contact, congruent elements. */
    void log_step(const Model &model, Log &log);

    /** Seconds that @p n_steps will take, from some evaluations of the internal forces. */
    double expect_run_time(const State &state, double n_steps);

    /** Adds to @p summary the time of each part of a run and, on several ranks, what a rank sends
     * in a step; logs both by step. Collective. */
    void add_times(const Communicator &communicator, RunSummary &summary, Log &log) const;
  };
} // namespace vfife

#endif
