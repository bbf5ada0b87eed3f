// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/process/log.h>
#include <vfife/base/process/run_signals.h>
#include <vfife/output/files/output_folder.h>
#include <vfife/output/observers/bearing_writer.h>
#include <vfife/output/observers/progress_line.h>
#include <vfife/study/run/stepping.h>

namespace vfife
{
  Stepping::Stepping(const RunMeans &means)
    : folder_(means.folder)
    , log_(means.log)
    , model_(means.model)
    , times_(means.times)
    , observers_(folder_)
    , checkpoints_(folder_,
                   log_,
                   model_,
                   observers_.list(),
                   means.output,
                   [this](ByteStream &common, ByteStream *own) { serialize(common, own); })
  {
  }

  Stepping::~Stepping() = default;

  std::string Stepping::describe(const NumericalError &error) const
  {
    return error.what();
  }

  void Stepping::record_bearings()
  {
    if (model_.bearings.empty())
      return;
    observers_.add<BearingWriter>(times_.sample_steps);
    write_bearing_curves(folder_, model_.bearings);
  }

  void Stepping::finish(const std::function<void()> &complete)
  {
    summary_.run_time = checkpoints_.run_time();
    summary_.dt       = state_.dt;
    summary_.time     = state_.time;
    summary_.steps    = state_.step;
    summary_.energy   = state_.measured.energy;
    end();
    // The study adds its figures last, when all others stand.
    complete();
    if (summary_.status != "failed" && times_.end < times_.whole * (1. - 1e-9))
      log_.line("ended after Dynamics/maximum number of steps, ",
                1e3 * times_.end,
                " of ",
                1e3 * times_.whole,
                " ms");
    write_summary(folder_, summary_, log_);
  }

  void Stepping::run(const Checkpoint            *checkpoint,
                     const std::function<void()> &prepared,
                     const std::function<void()> &complete)
  {
    observers_.list().push_back(std::make_unique<ProgressLine>(
      log_, folder_.communicator(), 0., times_.end, times_.whole, times_.sample_steps));
    // 1. The place of the first step: that of the checkpoint, or what the start finds.
    checkpoints_.start_clocks();
    try
      {
        if (checkpoint != nullptr)
          checkpoints_.restore(*checkpoint, state_);
        else
          {
            prepare();
            prepared();
          }
        // 2. The steps. Run time and clock of the checkpoints begin here: the equilibrium is no
        // part of the speed in steps. Signals are caught only while there is something to save.
        checkpoints_.start_clocks();
        RunSignals signals;
        take_steps(signals, checkpoint != nullptr);
      }
    // 3. The end. A failure is stated in the summary before others hear of it; an interruption
    // passes by, as its checkpoint is all that it leaves.
    catch (const NumericalError &error)
      {
        summary_.fail(describe(error));
        finish(complete);
        throw NumericalError(summary_.failure);
      }
    finish(complete);
  }
} // namespace vfife
