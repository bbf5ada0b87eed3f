// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// The states of ExplicitSolver: how they begin, what is measured and shown of them, and what
// checkpoints keep.
#include <vfife/base/process/communicator.h>
#include <vfife/base/process/timers.h>
#include <vfife/base/text/byte_stream.h>
#include <vfife/dynamics/loop/explicit_solver.h>
#include <vfife/dynamics/watch/measurement.h>
#include <vfife/dynamics/watch/motion_sums.h>
#include <vfife/model/constraints/supports.h>

#include <algorithm>
#include <cmath>

namespace vfife
{
  namespace
  {
    /** Passes the vectors of a field by node of the model. */
    void pass_vectors(ByteStream         &stream,
                      const Partition    &partition,
                      const Communicator &communicator,
                      NodeField          &field)
    {
      std::vector<double> all(3 * partition.local_node.size(), 0.);
      const auto          place = [&](const std::uint32_t local) {
        return Eigen::Map<Vector3>(all.data() +
                                   3 * static_cast<std::size_t>(partition.global_node[local]));
      };
      if (!stream.reads())
        {
          for (const std::uint32_t i : partition.owned_nodes())
            place(i) = field.value(i);
          communicator.sum(all); // one owner a node: adding the others' zeros changes no digit
        }
      stream.pass_known(all);
      const auto is_finite = [](const double number) { return std::isfinite(number); };
      if (stream.reads())
        stream.require(std::all_of(all.begin(), all.end(), is_finite),
                       "a coordinate or velocity is not finite");
      if (stream.reads())
        for (const std::uint32_t i : partition.nodes())
          field.set(i, place(i));
    }
    /** A run goes on from time and step of its beginning in equal steps. */
    void check_times(const ByteStream   &stream,
                     const std::uint64_t first_step,
                     const double        first_time,
                     const State        &state)
    {
      stream.require(std::isfinite(state.dt) && state.dt > 0 && state.step >= first_step,
                     "the time step is not valid");
      const double steps = static_cast<double>(state.step - first_step);
      stream.require(std::abs(state.time - first_time - steps * state.dt) <=
                       1e-9 * (std::abs(state.time) + state.dt),
                     "the time does not match the step");
    }
  } // namespace

  void ExplicitSolver::start(State &state)
  {
    // 1. Undeformed bodies in their places, with their masses.
    const Partition &partition = operator_.partition();
    state.partition            = std::make_shared<const Partition>(partition);
    state.time                 = 0;
    state.step                 = 0;
    state.dt                   = dt_;
    state.position             = operator_.make_field();
    state.velocity             = operator_.make_field();
    state.body_motion.clear();
    for (unsigned int b = 0; b < model_.bodies.size(); ++b)
      {
        const Body &body = model_.bodies[b];
        state.body_motion.push_back(body.placement);
        for (const std::uint32_t i : partition.nodes(b))
          {
            const Vector3 &X = body.node_positions()[partition.global_node[i] - body.first_node];
            state.position.set(i, body.placement(X));
            state.position.set_number(i, 1. / operator_.masses()[i]);
            state.velocity.set_number(i, operator_.masses()[i]);
          }
      }
    // 2. Constrained nodes are moved by their constraints alone: no mass in the common update.
    constraints_.clear_masses(state);
    // 3. Rigid motion, and what is added to it.
    set_initial_velocities(state);
  }

  void ExplicitSolver::set_initial_velocities(State &state) const
  {
    const Partition &partition = *state.partition;
    for (unsigned int b = 0; b < model_.bodies.size(); ++b)
      {
        const Body   &body = model_.bodies[b];
        const Matrix3 back = rotation_about(body.axis.direction, -body.rate * dt_);
        for (const std::uint32_t i : partition.nodes(b))
          {
            // The chord of the step before time zero: central differences then start without an
            // error of first order.
            const Vector3 r = state.node_position(i) - body.axis.point;
            state.velocity.set(i, body.velocity + (r - back * r) / dt_);
            if (!body.initial_velocity.empty())
              state.velocity.add(i,
                                 body.initial_velocity[partition.global_node[i] - body.first_node]);
          }
      }
  }

  std::vector<RigidVelocity> ExplicitSolver::compute_rigid_rates(const State &state) const
  {
    std::vector<RigidVelocity> rates;
    for (unsigned int b = 0; b < model_.bodies.size(); ++b)
      {
        const UpdateAxis axis = references_[b].axis();
        BodySums         sums;
        for (const std::uint32_t i : state.partition->owned_nodes(b))
          add_node_moments(axis,
                           operator_.masses()[i],
                           state.node_position(i),
                           state.node_velocity(i),
                           sums.update);
        sum_over_ranks(sums, communicator_);
        rates.push_back(compute_momentum_rate(axis, model_.bodies[b].mass(), sums.update));
      }
    return rates;
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
    motions_.assign(model_.bodies.size(), {});
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
    const MotionSums motion             = sum_motion(model_, motions_, communicator_);
    observed_.measured.momentum         = motion.momentum;
    observed_.measured.angular_momentum = motion.angular_momentum;
    alternating_energy_                 = motion.alternating_energy;
    damping_watch_.observe_sample(motion.mean_speeds, rigid_);
  }

  void ExplicitSolver::take_energies(const ElementMeasures &measures)
  {
    // The rigid motions are advanced after this: they are those before the update still.
    energy_.take_sample(rigid_,
                        sums_,
                        measures.strain_energy + loads_.compute_spring_energy(observed_.position) +
                          bearings_.energy(),
                        contact_.energy() + walls_.energy(),
                        observed_.step - beginning_->step);
  }

  void ExplicitSolver::take_reactions(const State &state)
  {
    // Of the time of the forces: the update has moved the nodes, and knows both velocities.
    const auto            scope = timers_.time(timers_.section("measurement"));
    std::vector<Reaction> reactions(list_supports(model_).size());
    constraints_.add_reactions(dt_, damping_, forces_, state.velocity, reactions);
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
    measured.body_rates.clear();
    for (unsigned int b = 0; b < model_.bodies.size(); ++b)
      {
        measured.drive_torque += sums_[b].drive_torque;
        measured.body_rates.push_back(model_.bodies[b].axis.direction.dot(rigid_[b].omega));
      }
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
    state.measured.energy.contact = contact_.energy() + walls_.energy();
    state.measured.body_rates.assign(model_.bodies.size(), 0.);
    state.measured.momentum = state.measured.angular_momentum = Vector3::Zero();
  }

  std::vector<DampingAudit> ExplicitSolver::damping_audit() const
  {
    return damping_watch_.compute_audit(rigid_);
  }

  const ContactLosses &ExplicitSolver::contact_losses() const
  {
    return contact_watch_.losses();
  }

  void ExplicitSolver::serialize(ByteStream &common, ByteStream *own, State &state)
  {
    // What all ranks know.
    Beginning beginning = beginning_.value_or(Beginning());
    common.pass_required_part("state", [&](ByteStream &part) {
      part.pass(beginning.step, beginning.time, state.time, state.step, state.dt);
      check_times(part, beginning.step, beginning.time, state);
      part.pass_known(state.body_motion);
      pass_vectors(part, *state.partition, communicator_, state.position);
      pass_vectors(part, *state.partition, communicator_, state.velocity);
      for (RigidVelocity &rate : rigid_)
        part.pass(rate.velocity, rate.omega);
    });
    if (!common.pass_part("damping references", [&](ByteStream &part) {
          for (DampingReference &reference : references_)
            reference.serialize(part);
        }))
      for (DampingReference &reference : references_)
        reference.take_place(state, operator_.masses(), communicator_);
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
    n_substeps_        = n_substeps;
    dt_                = state.dt / n_substeps;
    alternating_share_ = 0;
    stability_watch_   = EnergyWatch();
    if (own == nullptr) // other ranks know other parts of the pairs
      contact_.search(state.body_motion, rigid_, state.position, search_interval * state.dt);
    // What a failure before the next measurement would show.
    observe_from(state);
    observed_.measured.energy = energy_.ledger();
    transmission_.measure(observed_, communicator_);
  }
} // namespace vfife
