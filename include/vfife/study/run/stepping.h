// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_study_run_stepping_h
#define vfife_study_run_stepping_h

#include <vfife/model/observer.h>
#include <vfife/model/state.h>
#include <vfife/output/files/run_checkpoints.h>
#include <vfife/output/files/summary.h>
#include <vfife/study/cases/run_length.h>

#include <functional>
#include <memory>
#include <string>
#include <utility>

namespace vfife
{
  class ByteStream;
  class Log;
  class NumericalError;
  class OutputFolder;
  class RunSignals;
  struct Checkpoint;

  /** What looks at a run and writes into its folder. */
  class RunObservers
  {
  public:
    /** The folder must outlive the object. */
    explicit RunObservers(const OutputFolder &folder)
      : folder_(folder)
    {
    }

    /** Adds an observer, made of the folder and the arguments. */
    template <typename Writer, typename... Arguments>
    const Writer &add(Arguments &&...arguments)
    {
      list_.push_back(std::make_unique<Writer>(folder_, std::forward<Arguments>(arguments)...));
      return static_cast<const Writer &>(*list_.back());
    }

    Observers &list()
    {
      return list_;
    }

  private:
    const OutputFolder &folder_;
    Observers           list_;
  };

  /** What a run works with. Everything but the times must outlive it. */
  struct RunMeans
  {
    OutputFolder        &folder;
    Log                 &log;
    Model               &model;
    const OutputOptions &output;
    RunTimes             times;
  };

  /**
   * The time steps of a run from its start, or from a checkpoint, to its end, whatever solver takes
   * them: observers, checkpoints, signals, failure, summary.json. A run that goes on from a
   * checkpoint writes the files that it would have written without a stop.
   */
  class Stepping
  {
  public:
    explicit Stepping(const RunMeans &means);
    virtual ~Stepping();

    OutputFolder &folder() const
    {
      return folder_;
    }
    Log &log() const
    {
      return log_;
    }
    Model &model() const
    {
      return model_;
    }
    const RunTimes &times() const
    {
      return times_;
    }
    RunObservers &observers()
    {
      return observers_;
    }
    const State &state() const
    {
      return state_;
    }
    /** To be filled by the study; run() adds time, steps, energy, warnings. */
    RunSummary &summary()
    {
      return summary_;
    }

    /** Adds the writer of the model's bearings, and their curves, if there are any. */
    void record_bearings();

    /**
     * Runs from the start, or from @p checkpoint (nullptr: none), to the end. @p prepared is called
     * in the state of the first step. @p complete fills in the summary of a run that has ended or
     * failed, before it is written. Throws NumericalError after the summary of a failed run has
     * been written, Interrupted after a checkpoint.
     */
    void run(const Checkpoint            *checkpoint,
             const std::function<void()> &prepared,
             const std::function<void()> &complete);

  protected:
    /** Passes what is the solver's: RunCheckpoints::Parts. */
    virtual void serialize(ByteStream &common, ByteStream *own) = 0;
    /** Takes the state to its first step. Throws NumericalError. */
    virtual void prepare() = 0;
    /** Takes the steps to the end, of a run that goes on from a checkpoint if @p resumed. Throws
     * NumericalError, and what RunCheckpoints::before_step() throws. */
    virtual void take_steps(RunSignals &signals, bool resumed) = 0;
    /** The steps have ended, well or not: adds what the solver knows to the summary. */
    virtual void end() = 0;
    /** For the summary; that of steps says where they have failed. */
    virtual std::string describe(const NumericalError &error) const;

    OutputFolder  &folder_;
    Log           &log_;
    Model         &model_;
    const RunTimes times_;
    RunObservers   observers_;
    State          state_;
    RunSummary     summary_;
    RunCheckpoints checkpoints_;

  private:
    void finish(const std::function<void()> &complete);
  };
} // namespace vfife

#endif
