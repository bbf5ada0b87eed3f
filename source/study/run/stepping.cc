// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/process/communicator.h>
#include <vfife/base/process/log.h>
#include <vfife/base/process/run_signals.h>
#include <vfife/base/text/byte_stream.h>
#include <vfife/dynamics/loop/explicit_solver.h>
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
    /** Steps between checkpoints in memory: cheap beside them, and what goes wrong is noticed. */
    constexpr unsigned int snapshot_interval = 1000;

    /** ExplicitSolver::alternating_share() of states that a run may go back to: of the energy, so a
     * hundredth of the amplitude. */
    constexpr double clean_share = 1e-4;
  } // namespace

  Stepping::Stepping(OutputFolder        &folder,
                     Log                 &log,
                     Model               &model,
                     ExplicitSolver      &solver,
                     const OutputOptions &output,
                     const std::uint64_t  sample_steps)
    : folder_(folder)
    , log_(log)
    , model_(model)
    , solver_(solver)
    , sample_steps_(sample_steps)
    , observers_(folder)
    , checkpoints_(folder,
                   log,
                   model,
                   observers_.list(),
                   output,
                   [this](ByteStream &common, ByteStream *own) { serialize_solver(common, own); })
  {
    solver_.start(state_);
  }

  Stepping::~Stepping() = default;

  void Stepping::add_fields(const OutputOptions   &output,
                            const double           dt,
                            const DynamicsOptions &dynamics)
  {
    auto fields = std::make_unique<FieldWriter>(
      folder_,
      model_,
      output.field_format,
      output.compute_field_steps(model_.transmission ? &*model_.transmission : nullptr, dt),
      dynamics.stiffness,
      dynamics.frame);
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

  void Stepping::keep_snapshot()
  {
    ByteStream common, own;
    checkpoints_.serialize(common, &own);
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
    const double       so_far     = checkpoints_.run_time();
    // A mode that grows has begun before it is noticed: the last state but one, or the first where
    // that has the mode already.
    if (snapshots_.size() > 1)
      snapshots_.pop_back();
    if (snapshots_.back().alternating_share > clean_share)
      snapshots_.resize(1);
    ByteStream common(snapshots_.back().common, "memory"), own(snapshots_.back().own, "memory");
    checkpoints_.serialize(common, &own);
    checkpoints_.start_clocks(so_far);
    solver_.divide_step(state_, n_substeps);
    log_.warning("step ",
                 1e9 * state_.dt,
                 " ns became unstable (",
                 failure,
                 "); restarting at ",
                 where(state_),
                 " with the step divided by ",
                 n_substeps);
    return true;
  }

  void Stepping::serialize_solver(ByteStream &common, ByteStream *own)
  {
    common.pass_required_part("solver",
                              [&](ByteStream &part) { solver_.serialize(part, own, state_); });
    common.pass_part("start", [&](ByteStream &part) { start_->serialize(part); });
    common.pass_part("start, later", [&](ByteStream &part) { start_->serialize_later(part); });
  }

  void Stepping::before_step(RunSignals &signals, const std::uint64_t last_step)
  {
    if (state_.step % snapshot_interval == 0 && solver_.may_be_unstable())
      keep_snapshot();
    if (checkpoints_.before_step(signals, state_, state_.step == last_step) && fields_ != nullptr)
      fields_->request();
  }

  void Stepping::finish(const std::function<void()> &complete)
  {
    summary_.run_time       = checkpoints_.run_time();
    summary_.dt             = state_.dt;
    summary_.time           = state_.time;
    summary_.steps          = state_.step;
    summary_.energy         = state_.measured.energy;
    summary_.damping        = solver_.damping_audit();
    summary_.contact_losses = solver_.contact_losses();
    // The study adds its figures last, when all others stand.
    complete();
    write_summary(folder_, summary_, log_);
  }

  void Stepping::run(const Checkpoint            *checkpoint,
                     const double                 end_time,
                     const double                 whole_time,
                     RunStart                    &start,
                     const std::function<void()> &prepared,
                     const std::function<void()> &complete)
  {
    observers_.list().push_back(std::make_unique<ProgressLine>(
      log_, folder_.communicator(), 0., end_time, whole_time, sample_steps_));
    // 1. The place of the first step: that of the checkpoint, or what the start finds.
    start_ = &start;
    checkpoints_.start_clocks();
    try
      {
        if (checkpoint != nullptr)
          checkpoints_.restore(*checkpoint, state_);
        else
          {
            start.prepare(state_);
            prepared();
          }
        // 2. The steps. Run time and clock of the checkpoints begin here: the equilibrium is no
        // part of the speed in steps. Signals are caught only while there is something to save.
        checkpoints_.start_clocks();
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
        summary_.fail(error.what());
        finish(complete);
        throw NumericalError(summary_.failure);
      }
    finish(complete);
    log_.line("finished: ",
              state_.step,
              " steps in ",
              duration_text(summary_.run_time),
              checkpoint != nullptr ? " with the time before the checkpoint, " : ", ",
              1e-6 * summary_.element_steps_per_second(),
              " million element-steps per second");
  }
} // namespace vfife
