// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_study_run_stepping_h
#define vfife_study_run_stepping_h

#include <vfife/model/observer.h>
#include <vfife/model/state.h>
#include <vfife/output/files/run_checkpoints.h>
#include <vfife/output/files/summary.h>
#include <vfife/output/output_options.h>
#include <vfife/study/run/run_observers.h>

#include <functional>
#include <string>
#include <vector>

namespace vfife
{
  class ByteStream;
  class Communicator;
  class ExplicitSolver;
  class FieldWriter;
  class Log;
  class NumericalError;
  class OutputFolder;
  class RunSignals;
  class RunStart;
  struct Checkpoint;
  struct DynamicsOptions;

  /**
   * The time steps of a run from its start, or from a checkpoint, to its end, whatever the model:
   * observers, checkpoints, signals, failure, summary.json. A run that goes on from a checkpoint
   * writes the files that it would have written without a stop.
   */
  class Stepping
  {
  public:
    /** Everything given must outlive the object. The step of @p solver is set. @p sample_steps:
     * steps from sample to sample of the histories. */
    Stepping(OutputFolder        &folder,
             Log                 &log,
             Model               &model,
             ExplicitSolver      &solver,
             const OutputOptions &output,
             std::uint64_t        sample_steps);
    ~Stepping();

    RunObservers &observers()
    {
      return observers_;
    }

    /** Adds the fields as often as @p output says for a step of @p dt [s]; never: on SIGUSR1 only.
     */
    void add_fields(const OutputOptions &output, double dt, const DynamicsOptions &dynamics);

    State &state();

    /** To be filled by the study; run() adds time, steps, energy, dampers, warnings. */
    RunSummary &summary();

    /**
     * Runs from where @p start takes the state, or from @p checkpoint (nullptr: none), to
     * @p end_time [s], of a run that would end at @p whole_time. @p prepared is called in the state
     * that @p start has found. @p complete fills in the summary of a run that has ended or failed,
     * before it is written. Throws NumericalError after the
     * summary of a failed run has been written, Interrupted after a checkpoint.
     */
    void run(const Checkpoint            *checkpoint,
             double                       end_time,
             double                       whole_time,
             RunStart                    &start,
             const std::function<void()> &prepared,
             const std::function<void()> &complete);

  private:
    /** A checkpoint in memory, of this rank. */
    struct Snapshot
    {
      std::string common, own;
      double      alternating_share; ///< ExplicitSolver::alternating_share()
    };

    void serialize_solver(ByteStream &common, ByteStream *own);
    void keep_snapshot();
    bool go_back(const NumericalError &error);
    void before_step(RunSignals &signals, std::uint64_t last_step);
    void finish(const std::function<void()> &complete);

    OutputFolder   &folder_;
    Log            &log_;
    Model          &model_;
    ExplicitSolver &solver_;
    std::uint64_t   sample_steps_;
    RunObservers    observers_;
    FieldWriter    *fields_ = nullptr;
    State           state_;
    RunSummary      summary_;

    RunCheckpoints checkpoints_;
    RunStart      *start_ = nullptr;
    std::vector<Snapshot>
      snapshots_; ///< the first and the last two, while the step may be too long
  };
} // namespace vfife

#endif
