// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/process/communicator.h>
#include <vfife/base/process/log.h>
#include <vfife/base/process/run_signals.h>
#include <vfife/base/text/byte_stream.h>
#include <vfife/model/state.h>
#include <vfife/output/files/checkpoint.h>
#include <vfife/output/files/output_folder.h>
#include <vfife/output/files/run_checkpoints.h>
#include <vfife/output/output_options.h>

#include <cmath>
#include <cstdlib>
#include <utility>

namespace vfife
{
  namespace
  {
    /** Signals and clock are looked at every so many steps: ranks must agree on them. */
    constexpr unsigned int look_interval = 10;
  } // namespace

  std::string where(const State &state)
  {
    return "time " + std::to_string(1e3 * state.time) + " ms, step " + std::to_string(state.step);
  }

  RunCheckpoints::RunCheckpoints(OutputFolder        &folder,
                                 Log                 &log,
                                 Model               &model,
                                 Observers           &observers,
                                 const OutputOptions &output,
                                 Parts                solver)
    : folder_(folder)
    , communicator_(folder.communicator())
    , log_(log)
    , model_(model)
    , observers_(observers)
    , output_(output)
    , solver_(std::move(solver))
    , begin_(WallClock::now())
    , last_checkpoint_(begin_)
  {
  }

  void RunCheckpoints::start_clocks()
  {
    begin_ = last_checkpoint_ = WallClock::now();
  }

  void RunCheckpoints::start_clocks(const double earlier)
  {
    begin_        = WallClock::now();
    earlier_time_ = earlier;
  }

  double RunCheckpoints::run_time() const
  {
    return earlier_time_ + seconds_since(begin_);
  }

  void RunCheckpoints::serialize(ByteStream &common, ByteStream *own)
  {
    // One function writes and reads. `common` is equal on all ranks, `own` is of one rank, and
    // missing where their number has changed. Everything is a part with a name, so that a run goes
    // on from the checkpoint of a version that did not have all of them.
    common.pass_required_part("model", [&](ByteStream &part) { serialize_model(part, model_); });
    common.pass_part("wall time", [&](ByteStream &part) {
      // The wall time so far goes on counting after a restart.
      double time = run_time();
      part.pass(time);
      part.require(time >= 0 && std::isfinite(time), "the run time is not valid");
      earlier_time_ = part.reads() ? time : earlier_time_;
    });
    solver_(common, own);
    for (const auto &observer : observers_)
      if (const std::string name = observer->part_name(); !name.empty())
        common.pass_part("observer " + name, [&](ByteStream &part) { observer->serialize(part); });
    common.pass_part("warnings", [&](ByteStream &part) { serialize_warnings(part); });
  }

  void RunCheckpoints::serialize_warnings(ByteStream &stream)
  {
    // Warnings of the log belong to the run: its summary lists them at the end.
    std::vector<std::pair<std::string, unsigned int>> warnings;
    for (const Log::Warning &warning : log_.warnings())
      warnings.emplace_back(warning.text, warning.count);
    stream.pass(warnings);
    std::vector<Log::Warning> earlier;
    for (const auto &[text, count] : warnings)
      earlier.push_back({text, count});
    if (stream.reads())
      log_.take_warnings(earlier);
  }

  void RunCheckpoints::write()
  {
    // From the second checkpoint on the one before is kept, in case the last is damaged.
    ByteStream common, own;
    serialize(common, &own);
    write_checkpoint(folder_, common.bytes(), own.bytes(), has_checkpoint_);
    has_checkpoint_  = true;
    last_checkpoint_ = WallClock::now();
  }

  void RunCheckpoints::restore(const Checkpoint &checkpoint, const State &state)
  {
    ByteStream common(checkpoint.common, data_of(checkpoint));
    // With as many ranks of the same program as before each goes on with its own part, bit by bit.
    // Otherwise the state is divided and contact searched for anew: what a rank knows is laid out
    // as the program's version has it, and sums of other ranks have another order.
    const bool same_ranks   = checkpoint.own.size() == communicator_.size();
    const bool same_version = checkpoint.version == present_version();
    const bool same         = same_ranks && same_version;
    ByteStream own(same ? checkpoint.own[communicator_.rank()] : "", data_of(checkpoint));
    serialize(common, same ? &own : nullptr);
    common.finish();
    own.finish();
    has_checkpoint_ = true;
    log_.line("continues from \"",
              checkpoint.file,
              "\" at ",
              where(state),
              same_ranks ? "" : ", written by another number of ranks: results agree to round-off");
    for (const std::string &remark : checkpoint.remarks)
      log_.line(remark);
    if (!same_version)
      log_.line("the checkpoint was written by version ",
                checkpoint.version,
                " of the program, this is ",
                present_version(),
                ": results agree to round-off");
  }

  void RunCheckpoints::stop(const State &state) const
  {
    // The command with which this run goes on, ready to be copied; a script that has started the
    // program and its ranks gives its own name.
    const unsigned int n       = communicator_.size();
    const char *const  script  = std::getenv("VFIFE_COMMAND");
    const std::string  command = script != nullptr ? script
                                 : n > 1           ? "mpirun -n " + std::to_string(n) + " vfife"
                                                   : "vfife";
    throw Interrupted("stopped on request at " + where(state) +
                      " after a checkpoint; to continue: " + command + " --restart \"" +
                      folder_.path() + "\"");
  }

  bool RunCheckpoints::before_step(RunSignals &signals, const State &state, const bool last)
  {
    const bool writes = output_.checkpoint_every > 0;
    // After the equilibrium before the start, which takes long, and at the end, so that a run can
    // be made longer.
    bool due         = writes && (!has_checkpoint_ || last);
    bool wants_field = false;
    int  signal      = 0;
    if (state.step % look_interval == 0)
      {
        // Clocks differ: rank 0's decides for all.
        const bool is_time = writes && communicator_.is_root() &&
                             seconds_since(last_checkpoint_) >= output_.checkpoint_every;
        std::vector<double> asked = {is_time ? 1. : 0.,
                                     static_cast<double>(signals.stop_signal()),
                                     signals.take_field_request() ? 1. : 0.};
        communicator_.max(asked);
        due         = due || asked[0] > 0 || asked[1] > 0;
        signal      = static_cast<int>(asked[1]);
        wants_field = asked[2] > 0;
      }
    // Signals reach single ranks and clocks differ: by now all ranks have decided alike, and
    // writing is collective. Who is stopped has written first.
    if (due)
      write();
    if (signal != 0)
      stop(state);
    return wants_field;
  }
} // namespace vfife
