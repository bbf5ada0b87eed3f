// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/process/log.h>
#include <vfife/base/process/run_signals.h>
#include <vfife/base/text/byte_stream.h>
#include <vfife/dynamics/operator/whole_partition.h>
#include <vfife/model/model.h>
#include <vfife/output/files/output_folder.h>
#include <vfife/output/files/result_places.h>
#include <vfife/output/observers/progress_line.h>
#include <vfife/reduced/body_rings.h>
#include <vfife/study/pressure/calibrated_penalty.h>
#include <vfife/study/reduced/reduced_run.h>
#include <vfife/study/run/pair_preload.h>
#include <vfife/study/run/steady_swing.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>

namespace vfife
{
  RingMotions bore_motions(const Model &model, const ReducedPair &pair)
  {
    return [&](const unsigned int b, const BodyRing &) {
      return model.bodies[b].floats ? pair.measure_ring(b, ring::bore) : MeanMotion::Motion();
    };
  }

  Swing swing_of(const ReducedStart &start)
  {
    return {start.found.stiffness, start.found.inertia};
  }

  void describe_start(const ReducedStart &start, const bool on_shafts, RunSummary &summary)
  {
    if (!(start.found.stiffness > 0))
      return;
    summary.transmission_error = {
      {error_part::total, {start.transmission_error / arcsecond, "arcsec"}}};
    if (on_shafts)
      for (const MountingNumber &one : list_numbers(start.misalignment))
        summary.misalignment.push_back({one.name, {one.value, one.unit}});
    add_swing(swing_of(start), summary);
  }

  ReducedRun::ReducedRun(
    OutputFolder &folder, Log &log, Model &model, ReducedPair &pair, const OutputOptions &output)
    : folder_(folder)
    , log_(log)
    , model_(model)
    , pair_(pair)
    , observers_(folder)
    , checkpoints_(
        folder, log, model, observers_.list(), output, [this](ByteStream &common, ByteStream *) {
          common.pass_required_part("reduced pair", [this](ByteStream &part) { serialize(part); });
          common.pass_part("contact impulse",
                           [this](ByteStream &part) { part.pass_record(pair_.contact_impulse()); });
        })
  {
    // Observers look at forces of nodes by it.
    state_.partition     = make_whole_partition(model);
    state_.contact_force = NodeField(model.n_nodes());
  }

  void ReducedRun::serialize(ByteStream &stream)
  {
    // All ranks do the same steps.
    stream.pass(state_.step, state_.time);
    pair_.serialize(stream);
    stream.pass_record(start_);
  }

  void ReducedRun::show(const bool last)
  {
    Observers &list = observers_.list();
    if (!last && std::none_of(list.begin(), list.end(), [&](const auto &observer) {
          return observer->due(state_);
        }))
      return;
    pair_.measure(state_);
    for (const auto &observer : list)
      if (last || observer->due(state_))
        observer->observe(model_, state_);
  }

  void ReducedRun::start_swing(const double step)
  {
    const Transmission &t = *model_.transmission;
    // As many positions as the start of an explicit run has.
    const std::size_t   n = turns_over_mesh(t).size();
    std::vector<double> errors(1, start_.transmission_error);
    pair_.set_speed(t.driver_rate, 1. / (n * t.mesh_frequency()));
    while (errors.size() < n)
      {
        pair_.step_standing();
        pair_.measure(state_);
        errors.push_back(state_.measured.transmission_error);
      }
    pair_.set_speed(t.driver_rate, step);
    const SwingMotion swing =
      find_steady_swing(errors, swing_of(start_), t.mesh_frequency(), mesh_damping_, start_.torque);
    pair_.start(swing.torque, t.driven_sense * swing.rate);
    pair_.measure(state_);
    log_.line("the torsional oscillation starts in its steady state: transmission error ",
              swing.error / arcsecond,
              " arcsec beyond the static one, flank torque ",
              swing.torque,
              " of the load torque");
  }

  void ReducedRun::run(const Checkpoint            *checkpoint,
                       const std::uint64_t          n_steps,
                       const double                 step,
                       const std::uint64_t          sample_steps,
                       const std::function<void()> &prepared,
                       const std::function<void()> &complete,
                       RunSummary                  &summary)
  {
    const double end = n_steps * step;
    observers_.list().push_back(
      std::make_unique<ProgressLine>(log_, folder_.communicator(), 0., end, end, sample_steps));
    const auto finish = [&]() {
      summary.run_time = checkpoints_.run_time();
      summary.dt       = step;
      summary.time     = state_.time;
      summary.steps    = state_.step;
      summary.energy   = state_.measured.energy;
      for (const auto &observer : observers_.list())
        observer->finish(model_, state_);
      complete();
      write_summary(folder_, summary, log_);
    };
    try
      {
        if (checkpoint != nullptr)
          {
            checkpoints_.restore(*checkpoint, state_);
            pair_.measure(state_);
          }
        else
          {
            start_.found = pair_.start();
            pair_.measure(state_);
            start_.transmission_error = state_.measured.transmission_error;
            start_.contact_energy     = state_.measured.energy.contact;
            start_.torque             = std::abs(pair_.load());
            if (std::isfinite(mesh_damping_))
              start_swing(step);
            prepared();
          }
        checkpoints_.start_clocks();
        RunSignals signals;
        if (checkpoint == nullptr)
          show(false);
        while (state_.step < n_steps)
          {
            checkpoints_.before_step(signals, state_, false);
            pair_.step();
            ++state_.step;
            state_.time = state_.step * step;
            show(state_.step == n_steps);
          }
        checkpoints_.before_step(signals, state_, true);
      }
    catch (const NumericalError &error)
      {
        summary.fail("time " + std::to_string(1e3 * state_.time) + " ms, step " +
                     std::to_string(state_.step) + ": " + error.what());
        finish();
        throw NumericalError(summary.failure);
      }
    finish();
  }
} // namespace vfife
