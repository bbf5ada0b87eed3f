// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_study_reduced_reduced_run_h
#define vfife_study_reduced_reduced_run_h

#include <vfife/model/state.h>
#include <vfife/output/files/summary.h>
#include <vfife/study/run/run_observers.h>

#include <cstdint>
#include <functional>

namespace vfife
{
  class Log;
  class OutputFolder;
  class ReducedPair;
  struct ReducedEquilibrium;

  /** The steps of a reduced pair from its equilibrium to the end, with observers and the figures of
   * the summary that any run has. */
  class ReducedRun
  {
  public:
    /** Everything given must outlive the object. */
    ReducedRun(const OutputFolder &folder, Log &log, const Model &model, ReducedPair &pair);

    RunObservers &observers()
    {
      return observers_;
    }
    const State &state() const
    {
      return state_;
    }

    /**
     * Finds the equilibrium, calls @p prepared in it, and does @p n_steps steps; @p complete fills
     * in @p summary, also of a run that has failed, before it is written. @p step [s];
     * @p sample_steps from sample to sample. Throws NumericalError after that.
     */
    void run(std::uint64_t                                          n_steps,
             double                                                 step,
             std::uint64_t                                          sample_steps,
             const std::function<void(const ReducedEquilibrium &)> &prepared,
             const std::function<void()>                           &complete,
             RunSummary                                            &summary);

  private:
    void show(bool last);

    const OutputFolder &folder_;
    Log                &log_;
    const Model        &model_;
    ReducedPair        &pair_;
    RunObservers        observers_;
    State               state_;
  };
} // namespace vfife

#endif
