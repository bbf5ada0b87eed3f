// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/process/log.h>
#include <vfife/base/text/byte_stream.h>
#include <vfife/dynamics/operator/whole_partition.h>
#include <vfife/output/measures/pair_mounting.h>
#include <vfife/reduced/body_rings.h>
#include <vfife/study/pressure/calibrated_penalty.h>
#include <vfife/study/reduced/reduced_run.h>
#include <vfife/study/run/steady_swing.h>

#include <algorithm>
#include <cmath>

namespace vfife
{
  RingMotions bore_motions(const Model &model, const ReducedPair &pair)
  {
    return [&](const unsigned int b, const BodyRing &) {
      return model.bodies[b].floats ? pair.reader().read_ring(b, ring::bore) : MeanMotion::Motion();
    };
  }

  ReducedRun::ReducedRun(const RunMeans &means, ReducedPair &pair, const double dt)
    : Stepping(means)
    , pair_(pair)
  {
    state_.dt = dt;
    // Observers look at forces of nodes by it.
    state_.partition     = make_whole_partition(model_);
    state_.contact_force = NodeField(model_.n_nodes());
  }

  PairPreload ReducedRun::preload() const
  {
    PairPreload told;
    told.parts        = {start_.transmission_error, not_known, not_known, not_known, not_known};
    told.supports     = {not_known, not_known};
    told.misalignment = start_.misalignment;
    told.swing        = {start_.found.stiffness, start_.found.inertia};
    told.penalty_lag  = compute_penalty_lag(start_.contact_energy, start_.torque);
    return told;
  }

  void ReducedRun::serialize(ByteStream &common, ByteStream *)
  {
    // All ranks do the same steps.
    common.pass_required_part("reduced pair", [this](ByteStream &part) {
      part.pass(state_.step, state_.time);
      pair_.serialize(part);
      part.pass_record(start_);
    });
    common.pass_part("contact impulse",
                     [this](ByteStream &part) { part.pass_record(pair_.contact_impulse()); });
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

  void ReducedRun::start_swing()
  {
    const Transmission &t    = *model_.only_transmission();
    const double        step = state_.dt; // of the run; measure() sets that of the pair
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
      find_steady_swing(errors, preload().swing, t.mesh_frequency(), mesh_damping_, start_.torque);
    pair_.start(swing.torque, t.driven_sense * swing.rate);
    pair_.measure(state_);
    log_.line("the torsional oscillation starts in its steady state: transmission error ",
              swing.error / arcsecond,
              " arcsec beyond the static one, flank torque ",
              swing.torque,
              " of the load torque");
  }

  void ReducedRun::prepare()
  {
    start_.found = pair_.start();
    pair_.measure(state_);
    start_.transmission_error = state_.measured.transmission_error;
    start_.contact_energy     = state_.measured.energy.contact;
    start_.torque             = std::abs(pair_.load());
    if (std::isfinite(mesh_damping_))
      start_swing();
    if (PairMounting::changes(model_))
      start_.misalignment = PairMounting(model_).measure(bore_motions(model_, pair_));
    log_.line("equilibrium: ",
              start_.found.iterations,
              " iterations, transmission error ",
              start_.transmission_error / arcsecond,
              " arcsec, torsional mode ",
              preload().swing.frequency(),
              " Hz");
  }

  void ReducedRun::take_steps(RunSignals &signals, const bool resumed)
  {
    if (resumed)
      pair_.measure(state_);
    else
      show(false);
    const std::uint64_t n_steps = std::llround(times_.end / state_.dt);
    while (state_.step < n_steps)
      {
        checkpoints_.before_step(signals, state_, false);
        pair_.step();
        ++state_.step;
        state_.time = state_.step * state_.dt;
        show(state_.step == n_steps);
      }
    checkpoints_.before_step(signals, state_, true);
  }

  void ReducedRun::end()
  {
    for (const auto &observer : observers_.list())
      observer->finish(model_, state_);
  }

  std::string ReducedRun::describe(const NumericalError &error) const
  {
    return where(state_) + ": " + error.what();
  }
} // namespace vfife
