// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_output_files_run_checkpoints_h
#define vfife_output_files_run_checkpoints_h

#include <vfife/base/process/wall_clock.h>
#include <vfife/model/observer.h>

#include <functional>
#include <string>

namespace vfife
{
  class ByteStream;
  class Communicator;
  class Log;
  class OutputFolder;
  class RunSignals;
  struct Checkpoint;
  struct Model;
  struct OutputOptions;
  struct State;

  /**
   * What lets a run of any solver be interrupted and go on: checkpoints of model, solver, observers
   * and warnings, when they are due or a signal asks for the end. A run that goes on writes the
   * files that it would have written without a stop.
   */
  class RunCheckpoints
  {
  public:
    /** Passes what is the solver's: `common` is equal on all ranks, `own` of one rank, and missing
     * where their number or the program has changed. */
    using Parts = std::function<void(ByteStream &common, ByteStream *own)>;

    /** Everything given must outlive the object. */
    RunCheckpoints(OutputFolder        &folder,
                   Log                 &log,
                   Model               &model,
                   Observers           &observers,
                   const OutputOptions &output,
                   Parts                solver);

    /** The clocks of run time and checkpoints begin now. */
    void start_clocks();
    /** The same after @p earlier seconds of run time. */
    void start_clocks(double earlier);
    /** Of this run and those that it went on from [s]. */
    double run_time() const;

    /** Everything, for checkpoints and those in memory. */
    void serialize(ByteStream &common, ByteStream *own);
    /** Goes on from a checkpoint; @p state is what the solver's part sets. Collective. */
    void restore(const Checkpoint &checkpoint, const State &state);

    /** Before a step: writes a checkpoint when it is due, or @p last, or a signal asks for the end;
     * then throws Interrupted. Returns whether a signal has asked for a field. Collective. */
    bool before_step(RunSignals &signals, const State &state, bool last);

  private:
    void serialize_warnings(ByteStream &stream);
    void write();
    void stop(const State &state) const;

    OutputFolder         &folder_;
    const Communicator   &communicator_;
    Log                  &log_;
    Model                &model_;
    Observers            &observers_;
    const OutputOptions  &output_;
    Parts                 solver_;
    WallClock::time_point begin_, last_checkpoint_;
    double                earlier_time_   = 0;     ///< run time before the checkpoint [s]
    bool                  has_checkpoint_ = false; ///< of this run
  };

  /** Time and step of a state, for messages. */
  std::string where(const State &state);
} // namespace vfife

#endif
