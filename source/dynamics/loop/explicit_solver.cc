// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/process/communicator.h>
#include <vfife/base/process/log.h>
#include <vfife/base/process/timers.h>
#include <vfife/dynamics/loop/explicit_solver.h>
#include <vfife/dynamics/motion/mean_speed.h>
#include <vfife/dynamics/operator/broken_element.h>
#include <vfife/dynamics/operator/step_bound.h>
#include <vfife/dynamics/watch/measurement.h>

#include <algorithm>
#include <cmath>
#include <utility>

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
    , contact_(model, operator_.partition(), communicator)
    , constraints_(model, operator_.partition(), communicator)
    , torques_(model, operator_.partition())
    , loads_(model, operator_, communicator)
    , walls_(model, operator_.partition(), communicator)
    , forces_(operator_.make_field())
    , approach_(model)
    , contact_watch_(log)
    , element_step_(find_element_step(model, options.step_bound, operator_, communicator, log))
  {
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

  double ExplicitSolver::stable_step()
  {
    return walls_.vote_on_step(
      loads_.vote_on_step(contact_.vote_on_step(options_.safety * element_step_)));
  }

  double ExplicitSolver::element_step() const
  {
    return element_step_;
  }

  void ExplicitSolver::set_step(const double dt)
  {
    dt_ = dt;
    contact_.set_penalties(dt);
    walls_.set_penalties(dt);
  }

  void ExplicitSolver::start(State &state)
  {
    state.partition = operator_.partition();
    state.time      = 0;
    state.step      = 0;
    state.dt        = dt_;
    state.position  = operator_.make_field();
    state.velocity  = operator_.make_field();
    state.body_motion.clear();
    for (unsigned int b = 0; b < model_.bodies.size(); ++b)
      {
        const Body &body = model_.bodies[b];
        state.body_motion.push_back(body.placement);
        for (const std::uint32_t i : state.partition.nodes(b))
          {
            state.position.set(
              i,
              body.placement(
                body.node_positions()[state.partition.global_node[i] - body.first_node]));
            state.position.set_number(i, 1. / operator_.masses()[i]);
            state.velocity.set_number(i, operator_.masses()[i]);
          }
      }
    constraints_.clear_masses(state);
    set_rigid_velocities(state);
    for (unsigned int b = 0; b < model_.bodies.size(); ++b)
      if (!model_.bodies[b].initial_velocity.empty())
        for (const std::uint32_t i : state.partition.nodes(b))
          state.velocity.add(i,
                             model_.bodies[b].initial_velocity[state.partition.global_node[i] -
                                                               model_.bodies[b].first_node]);
  }

  void ExplicitSolver::set_rigid_velocities(State &state) const
  {
    for (unsigned int b = 0; b < model_.bodies.size(); ++b)
      {
        const Body   &body = model_.bodies[b];
        const Matrix3 back = rotation_about(body.axis.direction, -body.rate * dt_);
        for (const std::uint32_t i : state.partition.nodes(b))
          {
            // The chord of the step before time zero: central differences then start without an
            // error of first order.
            const Vector3 r = state.node_position(i) - body.axis.point;
            state.velocity.set(i, body.velocity + (r - back * r) / dt_);
          }
      }
  }

  std::vector<RigidVelocity> ExplicitSolver::compute_rigid_rates(const State &state) const
  {
    std::vector<UpdateSums> sums(model_.bodies.size());
    for (unsigned int b = 0; b < model_.bodies.size(); ++b)
      for (const std::uint32_t i : state.partition.owned_nodes(b))
        add_node_moments(UpdateAxis::of(model_.bodies[b]),
                         operator_.masses()[i],
                         state.node_position(i),
                         state.node_velocity(i),
                         sums[b]);
    std::vector<RigidVelocity> rates;
    for (unsigned int b = 0; b < model_.bodies.size(); ++b)
      {
        sum_over_ranks(sums[b], communicator_);
        rates.push_back(compute_momentum_rate(UpdateAxis::of(model_.bodies[b]),
                                              model_.bodies[b].mass(),
                                              sums[b]));
      }
    return rates;
  }

  void ExplicitSolver::begin_run(State &state)
  {
    state.dt = dt_;
    constraints_.read(state, MotionFrame::fixed);
    rigid_  = compute_rigid_rates(state);
    ledger_ = EnergyLedger();
    powers_ = StepPowers();
    allocate();
    rates_at_start_ = rigid_;
    first_step_     = state.step;
    start_time_     = state.time;
    audited_steps_ = audited_samples_ = 0;
    contact_watch_.reset();
    largest_approach_ = 0;
    has_touched_      = false;
  }

  void ExplicitSolver::compute_forces(State &state, const bool measured)
  {
    {
      const auto scope = timers_.time(timers_.section("element forces"));
      if (measured)
        measures_ = operator_.measure_internal_forces(state.position, forces_);
      else
        operator_.compute_internal_forces(state.position, forces_);
    }
    {
      const auto scope = timers_.time(timers_.section("contact"));
      if (state.step % search_interval == 0 || search_now_)
        contact_.search(state.body_motion, rigid_, state.position, search_interval * dt_);
      search_now_ = false;
      if (measured)
        state.contact_force = forces_;
      contact_.add_forces(state.body_motion, state.position, state.velocity, dt_, forces_);
      if (measured)
        state.contact_force = forces_ - std::move(state.contact_force);
    }
    walls_.add_forces(state.position, forces_);
    torques_.add_forces(state.time, state.position, forces_);
    loads_.add_forces(state.time, state.position, forces_);
  }

  void ExplicitSolver::set_damping(const State &state)
  {
    for (unsigned int b = 0; b < model_.bodies.size(); ++b)
      {
        const Body &body  = model_.bodies[b];
        damping_[b].zeta  = options_.damping;
        damping_[b].rigid = rigid_[b];
        if (options_.damping_rate == DampingRate::mean_speed && body.turns_on_axis &&
            options_.damping > 0)
          damping_[b].rigid = compute_mean_speed_rate(body, state, b, communicator_);

        damping_[b].mesh = RigidVelocity();
        if (model_.transmission && model_.transmission->driven == b)
          {
            const Transmission &t = *model_.transmission;
            const double        rate =
              body.axis.direction.dot(rigid_[b].omega) - t.driven_sense * t.driven_rate();
            damping_[b].mesh.omega    = options_.mesh_damping * rate * body.axis.direction;
            damping_[b].mesh.velocity = -damping_[b].mesh.omega.cross(body.axis.point);
          }
      }
  }

  void ExplicitSolver::update_nodes(State &state)
  {
    const auto scope = timers_.time(timers_.section("nodal update"));
    powers_          = StepPowers();
    powers_.torque   = torques_.half_power(state.velocity) + loads_.half_power(state.velocity);
    constraints_.save(state.position, state.velocity);
    for (unsigned int b = 0; b < model_.bodies.size(); ++b)
      {
        sums_[b]        = BodySums();
        sums_[b].update = vfife::update_nodes(state.partition.first_local_node[b],
                                              state.partition.first_local_node[b + 1],
                                              dt_,
                                              damping_[b],
                                              UpdateAxis::of(model_.bodies[b]),
                                              state.partition.owned.data(),
                                              forces_.data(),
                                              state.position.data(),
                                              state.velocity.data());
      }
    constraints_.apply(state.time,
                       dt_,
                       MotionFrame::fixed,
                       damping_,
                       forces_,
                       state.position,
                       state.velocity,
                       sums_);
    powers_.torque += torques_.half_power(state.velocity) + loads_.half_power(state.velocity);

    drive_torque_  = 0;
    powers_.torque = communicator_.sum(powers_.torque);
    for (auto &s : sums_)
      {
        sum_over_ranks(s.update, communicator_, {&s.drive_power, &s.drive_torque});
        powers_.drive += s.drive_power;
        powers_.damping += s.update.damping_power;
        powers_.mesh += s.update.mesh_power;
        drive_torque_ += s.drive_torque;
      }
    powers_.contact = contact_.lost_power();
  }

  void ExplicitSolver::advance_bodies(State &state)
  {
    for (unsigned int b = 0; b < model_.bodies.size(); ++b)
      {
        const Body &body = model_.bodies[b];
        rigid_[b] = compute_momentum_rate(UpdateAxis::of(body), body.mass(), sums_[b].update);
        RigidMotion  &motion = state.body_motion[b];
        const Vector3 turn   = dt_ * rigid_[b].omega;
        const double  angle  = turn.norm();
        const Matrix3 step =
          angle > 0 ? rotation_about(turn / angle, angle) : Matrix3(Matrix3::Identity());
        const Vector3 pivot = body.turns_on_axis
                                ? body.axis.point
                                : Vector3(sums_[b].update.first_moment / body.mass());
        const Vector3 drift =
          body.turns_on_axis ? Vector3(Vector3::Zero()) : Vector3(dt_ * rigid_[b].at(pivot));
        motion.rotation    = step * motion.rotation;
        motion.translation = pivot + step * (motion.translation + drift - pivot);
      }
  }

  void ExplicitSolver::run(State            &state,
                           const double      end_time,
                           Observers        &observers,
                           const BeforeStep &before_step)
  {
    if (!goes_on_)
      begin_run(state);
    goes_on_                      = false;
    const std::uint64_t last_step = first_step_ + std::llround((end_time - start_time_) / dt_);
    if (state.step > last_step)
      throw InputError("the run has come to step " + std::to_string(state.step) +
                       " and cannot end at step " + std::to_string(last_step));
    try
      {
        for (;;)
          {
            if (before_step)
              before_step(state);
            const bool first = state.step == first_step_;
            const bool last  = state.step == last_step;
            const bool due =
              first || last ||
              std::any_of(observers.begin(), observers.end(), [&](const auto &observer) {
                return observer->due(state);
              });
            compute_forces(state, due);
            if (first && contact_.energy() > 0.)
              log_.line("deepest point at the start: ", contact_.describe_deepest_point());
            contact_watch_.observe(state.time, dt_, contact_.energy() > 0);
            has_touched_        = has_touched_ || contact_.energy() > 0;
            const double strain = due ? take_measurements(state) : 0.;
            set_damping(state);
            update_nodes(state);
            add_work(first ? 0.
                           : 0.5); // the trapezoidal rule counts half of the first and last steps
            if (due)
              {
                update_ledger(strain, first);
                show(observers, last);
              }
            check(state, due);
            add_work(0.5);
            add_audit();
            if (last)
              break;
            advance_bodies(state);
            ++state.step;
            state.time = start_time_ + (state.step - first_step_) * dt_;
          }
      }
    catch (const NumericalError &)
      {
        state = observed_;
        finish_audit();
        for (const auto &observer : observers)
          observer->finish(model_, observed_);
        throw;
      }
    state = observed_;
    finish_audit();
    for (const auto &observer : observers)
      observer->finish(model_, observed_);
  }

} // namespace vfife
