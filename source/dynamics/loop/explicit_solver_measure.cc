// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// The part of ExplicitSolver that measures: energies, contact, dampers, and what observers see.
#include <vfife/base/process/communicator.h>
#include <vfife/base/process/timers.h>
#include <vfife/dynamics/loop/explicit_solver.h>
#include <vfife/dynamics/motion/mean_speed.h>
#include <vfife/dynamics/watch/measurement.h>

#include <algorithm>
#include <cmath>

namespace vfife
{
  void ExplicitSolver::add_work(const double factor)
  {
    ledger_.drive_work += factor * dt_ * powers_.drive;
    ledger_.torque_work += factor * dt_ * powers_.torque;
    ledger_.damping_loss += factor * dt_ * powers_.damping;
    ledger_.mesh_damping_loss += factor * dt_ * powers_.mesh;
    ledger_.contact_loss += factor * dt_ * powers_.contact;
  }

  void ExplicitSolver::update_ledger(const double strain, const bool first)
  {
    ledger_.kinetic = ledger_.kinetic_relative = 0;
    for (const auto &s : sums_)
      ledger_.kinetic += s.update.kinetic;
    ledger_.kinetic_relative = ledger_.kinetic;
    for (unsigned int b = 0; b < model_.bodies.size(); ++b)
      ledger_.kinetic_relative -= compute_rigid_kinetic_energy(UpdateAxis::of(model_.bodies[b]),
                                                               model_.bodies[b].mass(),
                                                               sums_[b].update);
    ledger_.strain  = strain;
    ledger_.contact = contact_.energy() + walls_.collect_results().energy;
    if (first)
      {
        ledger_.start    = ledger_.kinetic + ledger_.strain + ledger_.contact;
        ledger_.scale    = EnergyLedger::scale_floor * ledger_.kinetic;
        ledger_at_start_ = ledger_;
      }
    has_touched_ = has_touched_ || ledger_.contact > 0;
    // Bodies that meet may exchange this much; before they do, it is nobody's measure.
    largest_approach_ = std::max(largest_approach_, approach_.compute(sums_));
    if (has_touched_)
      ledger_.scale = std::max(ledger_.scale, largest_approach_);
    ledger_.scale =
      std::max(ledger_.scale,
               std::abs(ledger_.strain - ledger_at_start_.strain) +
                 std::abs(ledger_.contact - ledger_at_start_.contact) +
                 std::abs(ledger_.kinetic_relative - ledger_at_start_.kinetic_relative) +
                 std::abs(ledger_.damping_loss + ledger_.mesh_damping_loss + ledger_.contact_loss));
  }

  void ExplicitSolver::measure_contact()
  {
    Measurements &m = observed_.measured;
    m.teeth         = contact_.collect_results();
    m.contact_force = m.contact_torque = m.largest_penetration = 0;
    m.teeth_in_contact                                         = m.teeth.size();
    for (const ToothContact &tooth : m.teeth)
      {
        m.contact_force += tooth.force.norm();
        m.contact_torque += tooth.torque;
        m.largest_penetration = std::max(m.largest_penetration, tooth.penetration);
      }
    const RigidWalls::Results wall = walls_.collect_results();
    m.contact_force += wall.force;
    m.largest_penetration = std::max(m.largest_penetration, wall.penetration);
  }

  void ExplicitSolver::add_audit()
  {
    ++audited_steps_;
    for (unsigned int b = 0; b < audit_.size(); ++b)
      {
        audit_[b].net_torque += sums_[b].update.damping_torque;
        audit_[b].power += sums_[b].update.damping_power;
      }
  }

  void ExplicitSolver::add_rate_difference(const State &state)
  {
    ++audited_samples_;
    for (unsigned int b = 0; b < audit_.size(); ++b)
      {
        const Body &body = model_.bodies[b];
        if (!body.turns_on_axis)
          continue;
        const RigidVelocity mean_speed = compute_mean_speed_rate(body, state, b, communicator_);
        audit_[b].rate_difference +=
          (body.rate < 0 ? -1. : 1.) * body.axis.direction.dot(mean_speed.omega - rigid_[b].omega);
      }
  }

  void ExplicitSolver::finish_audit()
  {
    for (unsigned int b = 0; b < audit_.size(); ++b)
      {
        audit_[b].net_torque /= std::max(1U, audited_steps_);
        audit_[b].power /= std::max(1U, audited_steps_);
        audit_[b].rate_difference /= std::max(1U, audited_samples_);
        audit_[b].body = model_.bodies[b].name();
        audit_[b].spin_drift =
          (rigid_[b].omega - rates_at_start_[b].omega).dot(model_.bodies[b].axis.direction);
      }
  }

  const ContactLosses &ExplicitSolver::contact_losses() const
  {
    return contact_watch_.losses();
  }

  const std::vector<DampingAudit> &ExplicitSolver::damping_audit() const
  {
    return audit_;
  }

  double ExplicitSolver::take_measurements(const State &state)
  {
    const auto scope = timers_.time(timers_.section("measurement"));
    observed_        = state;
    measure_transmission(model_, observed_, communicator_);
    observed_.measured.probes = measure_probes(model_, observed_, operator_, communicator_);
    measure_momentum(observed_, operator_.masses(), communicator_);
    measure_contact();
    add_rate_difference(state);
    return measures_.strain_energy + loads_.compute_spring_energy(state.position);
  }

  void ExplicitSolver::measure_at_rest(State &state)
  {
    measures_ = operator_.measure_internal_forces(state.position, forces_);
    contact_.search(state.body_motion,
                    std::vector<RigidVelocity>(model_.bodies.size()),
                    state.position,
                    0.);
    const NodeField no_velocity = operator_.make_field();
    state.contact_force         = operator_.make_field();
    contact_.add_forces(state.body_motion, state.position, no_velocity, dt_, state.contact_force);
    walls_.add_forces(state.position, state.contact_force);
    EnergyLedger ledger;
    ledger.strain             = take_measurements(state);
    ledger.contact            = contact_.energy() + walls_.collect_results().energy;
    state.measured            = observed_.measured;
    state.measured.energy     = ledger;
    state.measured.body_rates = std::vector<double>(model_.bodies.size(), 0.);
    state.measured.momentum = state.measured.angular_momentum = Vector3::Zero();
  }

  void ExplicitSolver::show(Observers &observers, const bool last)
  {
    const auto scope                = timers_.time(timers_.section("observers"));
    observed_.measured.energy       = ledger_;
    observed_.measured.drive_torque = drive_torque_;
    observed_.measured.body_rates.clear();
    for (unsigned int b = 0; b < model_.bodies.size(); ++b)
      observed_.measured.body_rates.push_back(model_.bodies[b].axis.direction.dot(rigid_[b].omega));
    for (const auto &observer : observers)
      if (last || observer->due(observed_))
        observer->observe(model_, observed_);
  }
} // namespace vfife
