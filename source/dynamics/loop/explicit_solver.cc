// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/process/communicator.h>
#include <vfife/base/process/log.h>
#include <vfife/base/process/timers.h>
#include <vfife/dynamics/loop/explicit_solver.h>
#include <vfife/dynamics/operator/step_bound.h>
#include <vfife/dynamics/watch/guards.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <limits>

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

    std::vector<DampingReference> make_references(const Model &model)
    {
      std::vector<DampingReference> references;
      for (unsigned int b = 0; b < model.bodies.size(); ++b)
        references.emplace_back(model, b);
      return references;
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
    , rigid_(model.bodies.size())
    , references_(make_references(model))
    , damping_(model.bodies.size())
    , sums_(model.bodies.size())
    , energy_(model)
    , damping_watch_(model)
    , contact_watch_(log)
  {
    contact_.set_masses(operator_.masses());
    std::vector<UpdateAxis> axes;
    for (const DampingReference &reference : references_)
      axes.push_back(reference.axis());
    constraints_.set_axes(axes);
    energy_.set_axes(axes);
  }

  VfifeOperator &ExplicitSolver::vfife_operator()
  {
    return operator_;
  }

  ContactSystem &ExplicitSolver::contact()
  {
    return contact_;
  }

  RigidWalls &ExplicitSolver::walls()
  {
    return walls_;
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

  double ExplicitSolver::element_step() const
  {
    return element_step_;
  }

  void ExplicitSolver::set_step(const double dt)
  {
    dt_         = dt;
    n_substeps_ = 1;
    // The stiffness of points that stick changes with it.
    contact_.set_step(dt);
    walls_.set_step(dt);
    energy_.set_round_off(compute_round_off_energy(model_, dt));
    safe_step_ = vote_on_step(operator_.limiting_element().stable_step());
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
    beginning_ = Beginning{state.step, state.time};
    state.dt   = dt_ * n_substeps_;
    constraints_.read(state, MotionFrame::fixed);
    rigid_ = compute_rigid_rates(state);
    for (DampingReference &reference : references_)
      reference.take_place(state, operator_.masses(), communicator_);
    energy_.reset();
    damping_watch_.reset(rigid_);
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
        set_damping(state);
        const StepWork work = update_nodes(state, due);
        watch_contact(state);
        // What friction took before the beginning is no loss of this run.
        if (!first)
          energy_.add_friction_loss(contact_.friction_loss() + walls_.friction_loss());

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
        damping_watch_.observe_step(sums_);

        if (last)
          break;
        advance_bodies(state);
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
        contact_.search(state.body_motion, rigid_, state.position, search_interval * state.dt);
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
    const bool touching = contact_.is_pressed() || walls_.is_pressed();
    if (touching && state.step == beginning_->step)
      // None where a step's mean pressure presses points that are not behind a surface yet.
      if (const std::string deepest = describe_deepest(model_, contact_, walls_); !deepest.empty())
        log_.line("deepest point at the start: ", deepest);
    contact_watch_.observe(state.time, dt_, touching);
    contact_impulse_.add(dt_, contact_.step_force(), contact_.step_torque());
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
    const State &before = keeps ? observed_ : state;
    for (unsigned int b = 0; b < model_.bodies.size(); ++b)
      {
        sums_[b]        = BodySums();
        sums_[b].update = vfife::update_nodes(state.partition->first_local_node[b],
                                              state.partition->first_local_node[b + 1],
                                              dt_,
                                              damping_[b],
                                              references_[b].axis(),
                                              {state.partition->owned.data(),
                                               forces_.data(),
                                               before.position.data(),
                                               before.velocity.data(),
                                               state.position.data(),
                                               state.velocity.data()},
                                              keeps ? &motions_[b] : nullptr);
      }
    constraints_.apply(state.time,
                       dt_,
                       MotionFrame::fixed,
                       damping_,
                       forces_,
                       state.position,
                       state.velocity,
                       sums_);
    if (keeps)
      constraints_.add_motion(state.velocity, motions_);
    work.after.torque  = power_of_loads();
    work.after.damping = -power_of_dampers();

    // Sums and powers over all ranks, with those of the contact, in the one reduction of a step.
    std::vector<double *> numbers = {&work.before.torque,
                                     &work.before.damping,
                                     &work.after.torque,
                                     &work.after.damping};
    contact_.append_sums(numbers);
    for (BodySums &sums : sums_)
      append_numbers(sums, numbers);
    sum_over_ranks(numbers, communicator_);
    contact_.rethrow_failure();
    add_powers(state.time, work);
    return work;
  }

  void
  ExplicitSolver::check(const State &state, const bool measured, const ElementMeasures &measures)
  {
    // The first two in every step: what they look at is there. The others need a sample.
    check_motion(model_, sums_, observed_, state);
    check_penetration(model_, contact_, walls_, state);
    if (!measured)
      return;
    check_elements(model_, observed_, measures, communicator_);
    if (may_be_unstable())
      check_stability(state, measures);
    energy_.check(options_.energy_limit, describe_instant(state), log_);
  }

  void ExplicitSolver::advance_bodies(State &state)
  {
    for (unsigned int b = 0; b < model_.bodies.size(); ++b)
      {
        const Body &body = model_.bodies[b];
        rigid_[b] = compute_momentum_rate(references_[b].axis(), body.mass(), sums_[b].update);

        // y -> pivot + step (y + drift - pivot): turned about the axis, or, of a body that flies,
        // moved along and turned about where its centre of mass is at the end of the step
        RigidMotion  &motion = state.body_motion[b];
        const Vector3 turn   = dt_ * rigid_[b].omega;
        const double  angle  = turn.norm();
        const Matrix3 step =
          angle > 0 ? rotation_about(turn / angle, angle) : Matrix3(Matrix3::Identity());
        const bool    on_axis = references_[b].axis().use_axis;
        const Vector3 pivot =
          on_axis ? body.axis.point : Vector3(sums_[b].update.first_moment / body.mass());
        const Vector3 drift =
          on_axis ? Vector3(Vector3::Zero()) : Vector3(dt_ * rigid_[b].at(pivot));
        motion.rotation    = step * motion.rotation;
        motion.translation = pivot + step * (motion.translation + drift - pivot);
      }
  }
} // namespace vfife
