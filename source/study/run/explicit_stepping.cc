// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/process/log.h>
#include <vfife/base/text/byte_stream.h>
#include <vfife/dynamics/loop/explicit_solver.h>
#include <vfife/output/observers/field_writer.h>
#include <vfife/output/output_options.h>
#include <vfife/study/run/explicit_stepping.h>
#include <vfife/study/run/run_start.h>

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

  ExplicitStepping::ExplicitStepping(const RunMeans &means, ExplicitSolver &solver, RunStart &start)
    : Stepping(means)
    , solver_(solver)
    , start_(start)
  {
    solver_.start(state_);
  }

  void ExplicitStepping::add_fields(const OutputOptions   &output,
                                    const double           dt,
                                    const DynamicsOptions &dynamics)
  {
    auto fields =
      std::make_unique<FieldWriter>(folder_,
                                    model_,
                                    output.field_format,
                                    output.compute_field_steps(model_.only_transmission(), dt),
                                    dynamics.stiffness,
                                    dynamics.frame);
    // Kept beside the list of observers: a signal may ask it for a file.
    fields_ = fields.get();
    observers_.list().push_back(std::move(fields));
  }

  void ExplicitStepping::keep_snapshot()
  {
    ByteStream common, own;
    checkpoints_.serialize(common, &own);
    snapshots_.push_back({common.bytes(), own.bytes(), solver_.alternating_share()});
    if (snapshots_.size() > 3)
      snapshots_.erase(snapshots_.begin() + 1);
  }

  bool ExplicitStepping::go_back(const NumericalError &error)
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

  void ExplicitStepping::serialize(ByteStream &common, ByteStream *own)
  {
    common.pass_required_part("solver",
                              [&](ByteStream &part) { solver_.serialize(part, own, state_); });
    common.pass_part("start", [&](ByteStream &part) { start_.serialize(part); });
    common.pass_part("start, later", [&](ByteStream &part) { start_.serialize_later(part); });
  }

  void ExplicitStepping::prepare()
  {
    start_.prepare(state_);
  }

  void ExplicitStepping::take_steps(RunSignals &signals, bool)
  {
    const std::uint64_t last_step   = std::llround(times_.end / state_.dt);
    const auto          before_step = [&](State &) {
      if (state_.step % snapshot_interval == 0 && solver_.may_be_unstable())
        keep_snapshot();
      if (checkpoints_.before_step(signals, state_, state_.step == last_step) && fields_ != nullptr)
        fields_->request();
    };
    solver_.run(state_,
                times_.end,
                observers_.list(),
                before_step,
                [this](const NumericalError &error) { return go_back(error); });
  }

  void ExplicitStepping::end()
  {
    summary_.damping        = solver_.damping_audit();
    summary_.contact_losses = solver_.contact_losses();
  }
} // namespace vfife
