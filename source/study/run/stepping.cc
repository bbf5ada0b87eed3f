// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/process/communicator.h>
#include <vfife/base/process/log.h>
#include <vfife/base/process/run_signals.h>
#include <vfife/base/text/byte_stream.h>
#include <vfife/dynamics/loop/explicit_solver.h>
#include <vfife/output/files/checkpoint.h>
#include <vfife/output/files/output_folder.h>
#include <vfife/output/observers/field_writer.h>
#include <vfife/output/observers/progress_line.h>
#include <vfife/study/run/run_start.h>
#include <vfife/study/run/stepping.h>

#include <cmath>

namespace vfife
{
  namespace
  {
    /** Signals and clock are looked at every so many steps: ranks must agree on them. */
    constexpr unsigned int look_interval = 10;

    /** Steps between checkpoints in memory: cheap beside them, and what goes wrong is noticed. */
    constexpr unsigned int snapshot_interval = 1000;

    /** ExplicitSolver::alternating_share() of states that a run may go back to: of the energy, so a
     * hundredth of the amplitude. */
    constexpr double clean_share = 1e-4;

    /** Time and step of a state, for messages. */
    std::string where(const State &state)
    {
      return "time " + std::to_string(1e3 * state.time) + " ms, step " + std::to_string(state.step);
    }
  } // namespace

  Stepping::Stepping(OutputFolder        &folder,
                     Log                 &log,
                     Model               &model,
                     ExplicitSolver      &solver,
                     const OutputOptions &output,
                     const std::uint64_t  sample_steps)
    : folder_(folder)
    , communicator_(folder.communicator())
    , log_(log)
    , model_(model)
    , solver_(solver)
    , output_(output)
    , sample_steps_(sample_steps)
    , observers_(folder)
    , begin_(WallClock::now())
    , last_checkpoint_(begin_)
  {
    solver_.start(state_);
  }

  Stepping::~Stepping() = default;

  void Stepping::add_fields(const std::uint64_t steps, const DynamicsOptions &dynamics)
  {
    auto fields =
      std::make_unique<FieldWriter>(folder_, model_, steps, dynamics.stiffness, dynamics.frame);
    // Kept beside the list of observers: a signal may ask it for a file.
    fields_ = fields.get();
    observers_.list().push_back(std::move(fields));
  }

  State &Stepping::state()
  {
    return state_;
  }

  RunSummary &Stepping::summary()
  {
    return summary_;
  }

  double Stepping::run_time() const
  {
    return earlier_time_ + seconds_since(begin_);
  }

  void Stepping::serialize(ByteStream &common, ByteStream *own)
  {
    // One function writes and reads. `common` is equal on all ranks, `own` is of one rank, and
    // missing where their number has changed. Everything is a part with a name, so that a run goes
    // on from the checkpoint of a version that did not have all of them.
    common.pass_required_part("model", [&](ByteStream &part) { serialize_model(part, model_); });
    common.pass_part("wall time", [&](ByteStream &part) {
      // The wall time so far goes on counting after a restart.
      double time = run_time();
      part.pass(time);
      part.require(time >= 0 && std::isfinite(time), "a run time that is none");
      earlier_time_ = part.reads() ? time : earlier_time_;
    });
    common.pass_required_part("solver",
                              [&](ByteStream &part) { solver_.serialize(part, own, state_); });
    common.pass_part("start", [&](ByteStream &part) { start_->serialize(part); });
    for (const auto &observer : observers_.list())
      if (const std::string name = observer->part_name(); !name.empty())
        common.pass_part("observer " + name, [&](ByteStream &part) { observer->serialize(part); });
    common.pass_part("warnings", [&](ByteStream &part) { serialize_warnings(part); });
  }

  void Stepping::serialize_warnings(ByteStream &stream)
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

  void Stepping::write()
  {
    // From the second checkpoint on the one before is kept, in case the last is damaged.
    ByteStream common, own;
    serialize(common, &own);
    write_checkpoint(folder_, common.bytes(), own.bytes(), has_checkpoint_);
    has_checkpoint_  = true;
    last_checkpoint_ = WallClock::now();
  }

  void Stepping::restore(const Checkpoint &checkpoint)
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
    log_.line("goes on from \"",
              checkpoint.file,
              "\" at ",
              where(state_),
              same_ranks ? "" : ", written by another number of ranks: agrees to round-off");
    for (const std::string &remark : checkpoint.remarks)
      log_.line(remark);
    if (!same_version)
      log_.line("the checkpoint was written by version ",
                checkpoint.version,
                " of the program, this is ",
                present_version(),
                ": agrees to round-off");
  }

  void Stepping::keep_snapshot()
  {
    ByteStream common, own;
    serialize(common, &own);
    snapshots_.push_back({common.bytes(), own.bytes(), solver_.alternating_share()});
    if (snapshots_.size() > 3)
      snapshots_.erase(snapshots_.begin() + 1);
  }

  bool Stepping::go_back(const NumericalError &error)
  {
    if (!solver_.may_be_unstable() || snapshots_.empty())
      return false;
    const unsigned int n_substeps = 2 * solver_.n_substeps();
    const std::string  failure    = error.what();
    const double       so_far     = run_time();
    // A mode that grows has begun before it is noticed: the last state but one, or the first where
    // that has the mode already.
    if (snapshots_.size() > 1)
      snapshots_.pop_back();
    if (snapshots_.back().alternating_share > clean_share)
      snapshots_.resize(1);
    ByteStream common(snapshots_.back().common, "memory"), own(snapshots_.back().own, "memory");
    serialize(common, &own);
    earlier_time_ = so_far;
    begin_        = WallClock::now();
    solver_.divide_step(state_, n_substeps);
    log_.warning("a step of ",
                 1e9 * state_.dt,
                 " ns, longer than that of the worst element, came to an end (",
                 failure,
                 "): goes on from ",
                 where(state_),
                 ", with ",
                 n_substeps,
                 " steps in the place of one");
    return true;
  }

  void Stepping::stop(const int signal) const
  {
    // The command with which this run goes on, ready to be copied.
    const unsigned int n = communicator_.size();
    throw Interrupted(
      "stopped by " + RunSignals::name(signal) + " at " + where(state_) +
      " after a checkpoint; to go on: " + (n > 1 ? "mpirun -n " + std::to_string(n) + " " : "") +
      "vfife --restart \"" + folder_.path() + "\"");
  }

  void Stepping::before_step(RunSignals &signals, const std::uint64_t last_step)
  {
    if (state_.step % snapshot_interval == 0 && solver_.may_be_unstable())
      keep_snapshot();
    const bool writes = output_.checkpoint_every > 0;
    // After the equilibrium before the start, which takes long, and at the end, so that a run can
    // be made longer.
    bool due    = writes && (!has_checkpoint_ || state_.step == last_step);
    int  signal = 0;
    if (state_.step % look_interval == 0)
      {
        // Clocks differ: rank 0's decides for all.
        const bool is_time = writes && communicator_.is_root() &&
                             seconds_since(last_checkpoint_) >= output_.checkpoint_every;
        std::vector<double> asked = {is_time ? 1. : 0.,
                                     static_cast<double>(signals.stop_signal()),
                                     signals.take_field_request() ? 1. : 0.};
        communicator_.max(asked);
        due    = due || asked[0] > 0 || asked[1] > 0;
        signal = static_cast<int>(asked[1]);
        if (asked[2] > 0 && fields_ != nullptr)
          fields_->request();
      }
    // Signals reach single ranks and clocks differ: by now all ranks have decided alike, and
    // writing is collective. Who is stopped has written first.
    if (due)
      write();
    if (signal != 0)
      stop(signal);
  }

  void Stepping::finish(const std::function<void()> &complete)
  {
    summary_.run_time       = run_time();
    summary_.dt             = state_.dt;
    summary_.time           = state_.time;
    summary_.steps          = state_.step;
    summary_.energy         = state_.measured.energy;
    summary_.damping        = solver_.damping_audit();
    summary_.contact_losses = solver_.contact_losses();
    for (const Log::Warning &warning : log_.warnings())
      summary_.warnings.push_back(warning.text);
    // The study adds its figures last, when all others stand.
    complete();
    write_summary(folder_, summary_);
  }

  void Stepping::run(const Checkpoint            *checkpoint,
                     const double                 end_time,
                     const double                 whole_time,
                     RunStart                    &start,
                     const std::function<void()> &prepared,
                     const std::function<void()> &complete)
  {
    observers_.list().push_back(
      std::make_unique<ProgressLine>(log_, communicator_, 0., end_time, whole_time, sample_steps_));
    // 1. The place of the first step: that of the checkpoint, or what the start finds.
    start_ = &start;
    begin_ = WallClock::now();
    try
      {
        if (checkpoint != nullptr)
          restore(*checkpoint);
        else
          {
            start.prepare(state_);
            prepared();
          }
        // 2. The steps. Run time and clock of the checkpoints begin here: the equilibrium is no
        // part of the speed in steps. Signals are caught only while there is something to save.
        begin_ = last_checkpoint_     = WallClock::now();
        const std::uint64_t last_step = std::llround(end_time / state_.dt);
        RunSignals          signals;
        solver_.run(
          state_,
          end_time,
          observers_.list(),
          [&](State &) { before_step(signals, last_step); },
          [this](const NumericalError &error) { return go_back(error); });
      }
    // 3. The end. A failure is stated in the summary before others hear of it; an interruption
    // passes by, as its checkpoint is all that it leaves.
    catch (const NumericalError &error)
      {
        summary_.status  = "failed";
        summary_.failure = error.what();
        finish(complete);
        throw;
      }
    finish(complete);
    log_.line("finished: ",
              state_.step,
              " steps in ",
              duration_text(summary_.run_time),
              ", ",
              1e-6 * summary_.element_steps_per_second(),
              " million element-steps a second");
  }
} // namespace vfife
