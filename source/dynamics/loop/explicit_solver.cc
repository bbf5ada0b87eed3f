// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/process/communicator.h>
#include <vfife/base/process/log.h>
#include <vfife/base/process/timers.h>
#include <vfife/base/text/byte_stream.h>
#include <vfife/dynamics/loop/explicit_solver.h>
#include <vfife/dynamics/loop/start_state.h>
#include <vfife/dynamics/operator/step_bound.h>
#include <vfife/dynamics/watch/guards.h>
#include <vfife/dynamics/watch/measurement.h>
#include <vfife/dynamics/watch/motion_sums.h>
#include <vfife/model/constraints/supports.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <limits>
#include <tuple>

namespace vfife
{
  namespace
  {
    OperatorLayout layout_for(const DynamicsOptions &options)
    {
      OperatorLayout layout;
      layout.single_hourglass  = options.single_stiffness;
      layout.mass_scaling_step = options.mass_scaling_step;
      return layout;
    }

    /** Kinetic energy of nodes that move by eight units in the last place of their coordinates in a
     * step [mJ]. */
    double compute_round_off_energy(const Model &model, const double dt)
    {
      const double unit = 8. * std::numeric_limits<double>::epsilon() / dt;
      double       sum  = 0;
      for (const Body &body : model.bodies)
        for (unsigned int i = 0; i < body.n_nodes(); ++i)
          sum += .5 * body.node_masses()[i] * unit * unit *
                 body.placement(body.node_positions()[i]).squaredNorm();
      return sum;
    }

    bool any_due(const Observers &observers, const State &state)
    {
      return std::any_of(observers.begin(), observers.end(), [&](const auto &observer) {
        return observer->due(state);
      });
    }
  } // namespace

  ExplicitSolver::ExplicitSolver(const Model           &model,
                                 const DynamicsOptions &options,
                                 const Communicator    &communicator,
                                 Log                   &log,
                                 Timers                &timers)
    : model_(model)
    , options_(options)
    , communicator_(communicator)
    , log_(log)
    , timers_(timers)
    , operator_(model, options.frame, options.stiffness, communicator, layout_for(options))
    , contact_(model, operator_.partition(), communicator, options.safety)
    , walls_(model, operator_.partition(), communicator)
    , torques_(model, operator_.partition())
    , loads_(model, operator_, communicator)
    , bearings_(model, operator_.partition(), communicator)
    , constraints_(model, operator_.partition(), communicator)
    , transmission_(model, operator_.partition())
    , element_step_(find_element_step(model, options.step_bound, operator_, communicator, log))
    , forces_(operator_.make_field())
    , motions_(model, options_, operator_.masses(), communicator)
    , energy_(model)
    , damping_watch_(model)
    , contact_watch_(log)
  {
    contact_.set_masses(operator_.masses());
    constraints_.set_axes(motions_.axes());
    energy_.set_axes(motions_.axes());
  }

  double ExplicitSolver::vote_on_step(const double element_step)
  {
    // Squares of frequencies add up: of elements, of contact springs, of springs to the ground,
    // bearings, walls.
    return walls_.vote_on_step(bearings_.vote_on_step(
      loads_.vote_on_step(contact_.vote_on_step(options_.safety * element_step))));
  }

  double ExplicitSolver::stable_step()
  {
    return vote_on_step(element_step_);
  }

  void ExplicitSolver::set_step(const double dt)
  {
    dt_         = dt;
    n_substeps_ = 1;
    // The stiffness of points that stick changes with it.
    contact_.set_step(dt);
    walls_.set_step(dt);
    energy_.set_round_off(compute_round_off_energy(model_, dt));
    stability_.set_safe_step(vote_on_step(operator_.limiting_element().stable_step()));
  }

  void ExplicitSolver::divide_step(State &state, const unsigned int n)
  {
    const double earlier = dt_;
    n_substeps_          = n;
    dt_                  = state.dt / n;
    compute_forces(state, false);
    for (const std::uint32_t i : state.partition->nodes())
      state.velocity.add(i, 0.5 * (earlier - dt_) * state.position.number(i) * forces_.value(i));
  }

  void ExplicitSolver::start(State &state)
  {
    start_undeformed(model_, operator_, dt_, state);
    // Constrained nodes are moved by their constraints alone: no mass in the common update.
    constraints_.clear_masses(state);
  }

  void ExplicitSolver::set_initial_velocities(State &state) const
  {
    vfife::set_initial_velocities(model_, dt_, state);
  }

  void ExplicitSolver::run(State            &state,
                           const double      end_time,
                           Observers        &observers,
                           const BeforeStep &before_step,
                           const Recover    &recover)
  {
    // A run that goes on has begun before: serialize() knows where.
    if (!beginning_)
      begin_run(state);
    // Counted from the beginning, so that a run in parts has the steps of the whole one.
    const std::uint64_t last_step =
      beginning_->step + std::llround((end_time - beginning_->time) / state.dt);
    if (state.step > last_step)
      throw InputError("the run is at step " + std::to_string(state.step) +
                       " and cannot end at step " + std::to_string(last_step));

    std::exception_ptr failure;
    for (bool goes_on = true; goes_on;)
      {
        goes_on = false;
        failure = nullptr;
        try
          {
            integrate(state, last_step, observers, before_step);
          }
        catch (const NumericalError &error)
          {
            failure = std::current_exception();
            goes_on = recover && recover(error);
          }
      }

    // However it has ended: what was seen last is what there is.
    beginning_.reset();
    state = observed_;
    for (const auto &observer : observers)
      observer->finish(model_, observed_);
    if (failure)
      std::rethrow_exception(failure);
  }

  void ExplicitSolver::begin_run(State &state)
  {
    // Angles of free rotations and the bodies' rates follow from positions and velocities.
    beginning_ = RunBeginning{state.step, state.time};
    state.dt   = dt_ * n_substeps_;
    constraints_.read(state, MotionFrame::fixed);
    motions_.begin(state);
    energy_.reset();
    damping_watch_.reset(motions_.rates());
    contact_watch_.reset();
    contact_impulse_ = ContactImpulse();
    observe_from(state);
  }

  void ExplicitSolver::integrate(State              &state,
                                 const std::uint64_t last_step,
                                 Observers          &observers,
                                 const BeforeStep   &before_step)
  {
    for (unsigned int substep = 0;;)
      {
        const auto scope = timers_.time(timers_.section("rest of the steps"));
        // Checkpoints, signals and observers see the state before its step and nothing of substeps.
        const bool whole = substep == 0;
        if (whole && before_step)
          before_step(state);
        const bool first = whole && state.step == beginning_->step;
        const bool last  = whole && state.step == last_step;
        const bool due   = first || last || (whole && any_due(observers, state));

        // Forces of the state at t_n, and what is seen of it while it is there: the update moves
        // it.
        const ElementMeasures measures = compute_forces(state, due);
        if (due)
          take_measurements(state);
        // From v- at t_n - dt/2 to v+ at t_n + dt/2, positions to t_n + dt.
        motions_.set_damping(state, dt_);
        const StepWork work = update_nodes(state, due);
        watch_contact(state);
        // What friction took before the beginning is no loss of this run.
        if (!first)
          energy_.add_friction_loss(contact_.sums().friction_loss() + walls_.friction_loss());

        // The way of a step meets half the forces of its two ends: those of this instant did half
        // of their work on the way before it and do half on the way after it. Energies of a state
        // need the velocities on both sides, so observers wait for the update.
        if (!first)
          energy_.add_work(work.before, 0.5 * dt_);
        if (due)
          {
            take_motion();
            take_energies(measures);
            take_reactions(state);
            show(observers, last);
          }
        check(state, due, measures);
        energy_.add_work(work.after, 0.5 * dt_);
        damping_watch_.observe_step(motions_.sums());

        if (last)
          break;
        motions_.advance(dt_, state);
        substep = (substep + 1) % n_substeps_;
        if (substep == 0)
          ++state.step;
        // A product and no sum of steps, which would collect round-off.
        const double n_steps =
          (state.step - beginning_->step) + static_cast<double>(substep) / n_substeps_;
        state.time = beginning_->time + n_steps * state.dt;
      }
  }

  ElementMeasures ExplicitSolver::compute_forces(const State &state, const bool measured)
  {
    // 1. Internal forces set the field; all others are added.
    ElementMeasures measures;
    {
      const auto scope = timers_.time(timers_.section("element forces"));
      if (measured)
        measures = operator_.measure_internal_forces(state.position, forces_);
      else
        operator_.compute_internal_forces(state.position, forces_);
    }
    // 2. Torques, other loads, bearings, then walls, which ask where all these lead.
    {
      const auto scope = timers_.time(timers_.section("loads"));
      torques_.add_forces(state.time, state.position, forces_);
      loads_.add_forces(state.time, state.position, forces_);
      bearings_.add_forces(state.time, state.position, state.velocity, forces_);
      walls_.add_step_forces(state.position, state.velocity, dt_, forces_);
    }
    // 3. Contact, which may ask where all else leads: candidates every so many steps, forces in
    // each. Observers get its part of the forces.
    {
      const auto scope = timers_.time(timers_.section("contact"));
      if (state.step % search_interval == 0)
        contact_.search(state.body_motion,
                        motions_.rates(),
                        state.position,
                        search_interval * state.dt);
      if (measured)
        contact_.save_forces(forces_);
      contact_.add_step_forces(state.body_motion, state.position, state.velocity, dt_, forces_);
      if (measured)
        contact_.find_added(forces_, observed_.contact_force);
    }
    return measures;
  }

  void ExplicitSolver::watch_contact(const State &state)
  {
    // Of surfaces with each other and with walls.
    const bool touching = contact_.sums().is_pressed() || walls_.is_pressed();
    if (touching && state.step == beginning_->step)
      // None where a step's mean pressure presses points that are not behind a surface yet.
      if (const std::string deepest = describe_deepest(model_, contact_, walls_); !deepest.empty())
        log_.line("deepest point at the start: ", deepest);
    contact_watch_.observe(state.time, dt_, touching);
    contact_impulse_.add(dt_, contact_.sums().tooth_force(), contact_.sums().torque());
    energy_.observe_contact(touching);
  }

  StepWork ExplicitSolver::update_nodes(State &state, const bool keeps)
  {
    const auto scope = timers_.time(timers_.section("nodal update"));

    // All nodes by central differences, then the constrained ones to where they belong. Loads do
    // work on the ways before and after.
    const auto power_of_loads = [&]() {
      return 2. * (torques_.half_power(state.velocity) + loads_.half_power(state.velocity));
    };
    const auto power_of_dampers = [&]() {
      return 2. * bearings_.half_damper_power(state.velocity);
    };
    StepWork work;
    work.before.torque  = power_of_loads();
    work.before.damping = -power_of_dampers();
    constraints_.save(state.position, state.velocity);
    if (keeps)
      keep_for_observers(state);
    const State           &before  = keeps ? observed_ : state;
    const auto            &damping = motions_.damping();
    std::vector<BodySums> &sums    = motions_.sums();
    for (unsigned int b = 0; b < model_.bodies.size(); ++b)
      {
        sums[b]        = BodySums();
        sums[b].update = vfife::update_nodes(state.partition->first_local_node[b],
                                             state.partition->first_local_node[b + 1],
                                             dt_,
                                             damping[b],
                                             motions_.axis(b),
                                             {state.partition->owned.data(),
                                              forces_.data(),
                                              before.position.data(),
                                              before.velocity.data(),
                                              state.position.data(),
                                              state.velocity.data()},
                                             keeps ? &sampled_motions_[b] : nullptr);
      }
    constraints_.apply(
      state.time, dt_, MotionFrame::fixed, damping, forces_, state.position, state.velocity, sums);
    if (keeps)
      constraints_.add_motion(state.velocity, sampled_motions_);
    work.after.torque  = power_of_loads();
    work.after.damping = -power_of_dampers();

    // Sums and powers over all ranks, with those of the contact, in the one reduction of a step.
    std::vector<double *> numbers = {&work.before.torque,
                                     &work.before.damping,
                                     &work.after.torque,
                                     &work.after.damping};
    contact_.append_sums(numbers);
    for (BodySums &of_body : sums)
      append_numbers(of_body, numbers);
    sum_over_ranks(numbers, communicator_);
    contact_.rethrow_failure();
    add_powers(state.time, work);
    return work;
  }

  void ExplicitSolver::add_powers(const double time, StepWork &work) const
  {
    // What drives give through the bearings' dampers and these do not give to the bodies is lost.
    // A drive has no way before time zero.
    const double first = time < dt_ ? time : time - dt_;
    const double last  = time < dt_ ? time + dt_ : time;
    for (const auto &[powers, from, to] :
         {std::tuple<StepPowers *, double, double>(&work.before, first, last),
          std::tuple<StepPowers *, double, double>(&work.after, time, time + dt_)})
      {
        powers->drive   = bearings_.drive_power(from, to);
        powers->contact = contact_.sums().lost_power() + walls_.lost_power();
        powers->damping += bearings_.damper_drive_power(from, to);
      }
    motions_.add_powers(work);
  }

  void
  ExplicitSolver::check(const State &state, const bool measured, const ElementMeasures &measures)
  {
    // The first two in every step: what they look at is there. The others need a sample.
    check_motion(model_, motions_.sums(), observed_, state);
    check_penetration(model_, contact_, walls_, state);
    if (!measured)
      return;
    check_elements(model_, observed_, measures, communicator_);
    if (may_be_unstable())
      stability_.check(measures.strain_energy + contact_.sums().energy() + walls_.energy(),
                       energy_.round_off(observed_.step - beginning_->step),
                       describe_instant(state));
    energy_.check(options_.energy_limit, describe_instant(state), log_);
  }

  void ExplicitSolver::set_windings(const std::vector<double> &windings)
  {
    bearings_.set_windings(windings);
  }

  void ExplicitSolver::take_measurements(State &state)
  {
    const auto scope = timers_.time(timers_.section("measurement"));
    transmission_.measure(state, communicator_);
    state.measured.probes = measure_probes(model_, model_.probes, state, operator_, communicator_);
    measure_contact(contact_, walls_, state.measured);
    state.measured.bearings = bearings_.bearing_states();
  }

  void ExplicitSolver::keep_for_observers(State &state)
  {
    // The update reads the arrays that are kept and writes into those of the sample before: no
    // field is copied.
    observed_.time        = state.time;
    observed_.step        = state.step;
    observed_.dt          = state.dt;
    observed_.partition   = state.partition;
    observed_.body_motion = state.body_motion;
    observed_.measured    = state.measured;
    sampled_motions_.assign(model_.bodies.size(), {});
    std::swap(observed_.position, state.position);
    std::swap(observed_.velocity, state.velocity);
  }

  void ExplicitSolver::observe_from(const State &state)
  {
    observed_               = state;
    observed_.contact_force = operator_.make_field();
  }

  void ExplicitSolver::take_motion()
  {
    const auto       scope              = timers_.time(timers_.section("measurement"));
    const MotionSums motion             = sum_motion(model_, sampled_motions_, communicator_);
    observed_.measured.momentum         = motion.momentum;
    observed_.measured.angular_momentum = motion.angular_momentum;
    stability_.observe(motion.alternating_energy);
    damping_watch_.observe_sample(motion.mean_speeds, motions_.rates());
  }

  void ExplicitSolver::take_energies(const ElementMeasures &measures)
  {
    // The rigid motions are advanced after this: they are those before the update still.
    energy_.take_sample(motions_.rates(),
                        motions_.sums(),
                        measures.strain_energy + loads_.compute_spring_energy(observed_.position) +
                          bearings_.energy(),
                        contact_.sums().energy() + walls_.energy(),
                        observed_.step - beginning_->step);
  }

  void ExplicitSolver::take_reactions(const State &state)
  {
    // Of the time of the forces: the update has moved the nodes, and knows both velocities.
    const auto            scope = timers_.time(timers_.section("measurement"));
    std::vector<Reaction> reactions(list_supports(model_).size());
    constraints_.add_reactions(dt_, motions_.damping(), forces_, state.velocity, reactions);
    loads_.add_spring_reactions(observed_.position, reactions);
    bearings_.add_reactions(observed_.position, first_bearing(model_), reactions);
    sum_over_ranks(reactions, communicator_);
    observed_.measured.reactions = std::move(reactions);
  }

  void ExplicitSolver::show(Observers &observers, const bool last)
  {
    const auto    scope    = timers_.time(timers_.section("observers"));
    Measurements &measured = observed_.measured;
    measured.energy        = energy_.ledger();
    measured.drive_torque  = 0;
    for (const BodySums &sums : motions_.sums())
      measured.drive_torque += sums.drive_torque;
    measured.body_rates = motions_.axial_rates();
    for (const auto &observer : observers)
      if (last || observer->due(observed_))
        observer->observe(model_, observed_);
  }

  void ExplicitSolver::measure_at_rest(State &state)
  {
    const ElementMeasures measures = operator_.measure_internal_forces(state.position, forces_);
    contact_.search(state.body_motion,
                    std::vector<RigidVelocity>(model_.bodies.size()),
                    state.position,
                    0.);
    // Contact and walls alone in a field of their own.
    const NodeField no_velocity = operator_.make_field();
    state.contact_force         = operator_.make_field();
    contact_.add_forces(state.body_motion, state.position, no_velocity, dt_, state.contact_force);
    walls_.add_forces(state.position, state.contact_force);
    bearings_.add_forces_at_rest(state.position, forces_);

    // At rest there are stored energies only.
    take_measurements(state);
    state.measured.energy = EnergyLedger();
    state.measured.energy.strain =
      measures.strain_energy + loads_.compute_spring_energy(state.position) + bearings_.energy();
    state.measured.energy.contact = contact_.sums().energy() + walls_.energy();
    state.measured.body_rates.assign(model_.bodies.size(), 0.);
    state.measured.momentum = state.measured.angular_momentum = Vector3::Zero();
  }

  std::vector<DampingAudit> ExplicitSolver::damping_audit() const
  {
    return damping_watch_.compute_audit(motions_.rates());
  }

  void ExplicitSolver::serialize(ByteStream &common, ByteStream *own, State &state)
  {
    // What all ranks know.
    RunBeginning beginning = beginning_.value_or(RunBeginning());
    common.pass_required_part("state", [&](ByteStream &part) {
      pass_state(part, communicator_, beginning, state);
      motions_.serialize_rates(part);
    });
    if (!common.pass_part("damping references",
                          [&](ByteStream &part) { motions_.serialize_places(part); }))
      motions_.take_places(state);
    common.pass_part("counted turns", [&](ByteStream &part) {
      std::vector<double> windings = bearings_.windings();
      part.pass_known(windings);
      bearings_.set_windings(windings);
      transmission_.serialize(part);
    });
    common.pass_required_part("constraints", [&](ByteStream &part) {
      constraints_.serialize(part, *state.partition);
    });
    common.pass_required_part("energy", [&](ByteStream &part) { energy_.serialize(part); });
    common.pass_part("damping", [&](ByteStream &part) { damping_watch_.serialize(part); });
    common.pass_part("contact", [&](ByteStream &part) { contact_watch_.serialize(part); });
    common.pass_part("contact impulse",
                     [&](ByteStream &part) { part.pass_record(contact_impulse_); });
    common.pass_part("friction", [&](ByteStream &part) {
      contact_.serialize_friction(part);
      walls_.serialize(part);
    });
    unsigned int n_substeps = n_substeps_;
    common.pass_part("substeps", [&](ByteStream &part) {
      part.pass(n_substeps);
      part.require(n_substeps > 0 && n_substeps <= 1024,
                   std::to_string(n_substeps) + " substeps, expected 1 to 1024");
    });
    // What this rank knows of the pairs that may touch.
    if (own != nullptr)
      own->pass_required_part("contact", [&](ByteStream &part) { contact_.serialize(part); });
    if (!common.reads())
      return;

    beginning_ = beginning;
    set_step(state.dt);
    n_substeps_ = n_substeps;
    dt_         = state.dt / n_substeps;
    stability_.reset();
    if (own == nullptr) // other ranks know other parts of the pairs
      contact_.search(state.body_motion,
                      motions_.rates(),
                      state.position,
                      search_interval * state.dt);
    // What a failure before the next measurement would show.
    observe_from(state);
    observed_.measured.energy = energy_.ledger();
    transmission_.measure(observed_, communicator_);
  }
} // namespace vfife
