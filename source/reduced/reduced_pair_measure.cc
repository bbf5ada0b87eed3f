// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// What is measured of a ReducedPair.
#include "reduced_pair_parts.h"

#include <vfife/model/body_frame.h>
#include <vfife/model/pair_measures.h>
#include <vfife/model/state.h>
#include <vfife/reduced/pair_readings.h>

#include <algorithm>
#include <complex>

namespace vfife
{
  using Eigen::VectorXcd;
  using Eigen::VectorXd;

  double ReducedPair::torque_way() const
  {
    const Transmission &t      = *model_.only_transmission();
    const Member       &driven = *members_[t.driven];
    // The turn with its kinematic part, and what the modes and the residual flexibility make of the
    // bore, as the torque sees it.
    double way = t.driven_sense * driven_turn() + driven.motion.turn() +
                 driven.rows.torque().dot(rows_of(driven, now_.force));
    for (std::size_t i = 0; i < driven.body.harmonics.size(); ++i)
      if (driven.body.harmonics[i].number == 0 && driven.body.harmonics[i].n_modes() > 0)
        way += driven.body.harmonics[i].torque.dot(driven.motion.coordinates(i)).real();
    return way;
  }

  EnergyLedger ReducedPair::find_powers() const
  {
    const Transmission &t = *model_.only_transmission();
    EnergyLedger        powers;
    powers.drive_work = -now_.acting.driver_torque * members_[t.driver]->rate;
    if (springs_.size() > 0)
      {
        powers.drive_work -= bearings_.torques[t.driver] * members_[t.driver]->rate;
        for (std::size_t b = 0; b < members_.size(); ++b)
          powers.drive_work += bearings_.cage_slopes[b] * members_[b]->rate;
      }
    for (const auto &member : members_)
      {
        const auto losses = member->motion.losses();
        powers.damping_loss += losses.first;
        // The damper's torque acts on a body that turns as a whole.
        powers.swing_loss += losses.second;
        if (member->body.turns && member->motion.turn_rate() != 0.)
          powers.mesh_damping_uptake += losses.second / member->motion.turn_rate() *
                                        (member->rate + member->motion.turn_rate());
      }
    return powers;
  }

  void
  ReducedPair::add_work(const double torque, const double way_before, const EnergyLedger &before)
  {
    const EnergyLedger after = find_powers();
    const double       half  = .5 * options_.step;
    energy_.drive_work += half * (before.drive_work + after.drive_work);
    energy_.damping_loss += half * (before.damping_loss + after.damping_loss);
    energy_.mesh_damping_uptake += half * (before.mesh_damping_uptake + after.mesh_damping_uptake);
    energy_.swing_loss += half * (before.swing_loss + after.swing_loss);
    energy_.torque_work += torque * (torque_way() - way_before);
  }

  void ReducedPair::restart_energy()
  {
    energy_ = EnergyLedger();
    measure_energy();
    energy_.start = energy_.kinetic + energy_.strain + energy_.contact;
    energy_.scale = EnergyLedger::scale_floor * energy_.kinetic;
    first_energy_ = energy_;
  }

  void ReducedPair::measure_energy()
  {
    energy_.kinetic = energy_.kinetic_relative = energy_.strain = 0;
    for (const auto &one : members_)
      {
        const Member  &member = *one;
        const VectorXd force  = rows_of(member, now_.force);
        const double   rate   = member.rate + member.motion.turn_rate();
        energy_.kinetic_relative += member.motion.kinetic();
        energy_.kinetic += .5 * member.inertia * rate * rate +
                           member.rate * member.rate * member.motion.added_inertia();
        energy_.strain += member.motion.strain();
        // What the residual flexibility stores: that at once, less the modes' part of it.
        energy_.strain += .5 * force.dot(rows_of(member, now_.deflection)) +
                          member.rows.under(member.axial).dot(force);
        const std::vector<VectorXcd> modal = member.rows.project(force);
        for (std::size_t i = 0; i < modal.size(); ++i)
          energy_.strain -= .5 * modal[i].dot(member.motion.gain(i) * modal[i]).real();
      }
    energy_.strain += bearings_.energy;
    energy_.kinetic += energy_.kinetic_relative;
    energy_.contact = now_.acting.contact_energy;
    energy_.scale   = std::max(energy_.scale, energy_.exchanged_since(first_energy_));
  }

  double ReducedPair::read_turn(const Member &member, const char *const reading) const
  {
    return member.motion.turn() + member.rows.read_all(member.body.find_reading(reading),
                                                       member.coordinates(),
                                                       rows_of(member, now_.force),
                                                       member.axial);
  }

  void ReducedPair::measure_transmission(Measurements &measured) const
  {
    const Transmission &t      = *model_.only_transmission();
    const Member       &driven = *members_[t.driven];
    measured.driver_angle      = t.driver_bore.empty()
                                   ? 0.
                                   : t.driver_sense * read_turn(*members_[t.driver], reading::bore_turn);
    measured.driven_angle      = t.driven_sense * read_turn(driven, reading::bore_turn);
    measured.rim_angle         = t.driven_sense * read_turn(driven, reading::rim_turn);
    complete_angles(t, driver_turn_, measured);
  }

  void ReducedPair::measure_contact(State &state) const
  {
    Measurements &m = state.measured;
    set_teeth(pair_.teeth(), m);
    m.contact_forces.assign(model_.contacts.size(), Vector3::Zero());
    for (const ToothContact &tooth : m.teeth)
      for (std::size_t i = 0; i < model_.contacts.size(); ++i)
        if (model_.contacts[i].side == tooth.side)
          m.contact_forces[i] += tooth.force;
    if (state.contact_force.empty())
      return;
    state.contact_force.set_zero();
    for (std::size_t i = 0; i < nodes_.size(); ++i)
      state.contact_force.set(model_.bodies[nodes_[i].first].first_node + nodes_[i].second,
                              pair_.to_fixed_frame(i, now_.force.segment<3>(3 * i)));
  }

  void ReducedPair::add_contact_impulse()
  {
    Measurements measured;
    set_teeth(pair_.teeth(), measured);
    contact_impulse_.add(options_.step, measured.contact_force, measured.contact_torque);
  }

  void ReducedPair::measure(State &state)
  {
    state.time = time_;
    state.step = step_;
    state.dt   = options_.step;
    measure_transmission(state.measured);
    measure_contact(state);
    measure_energy();
    state.measured.energy = energy_;
    measure_bearings(state.measured);
    state.measured.drive_torque = measure_drive_torque();
    state.measured.rate_factor  = speed_factor();
    state.measured.body_rates.clear();
    for (const auto &member : members_)
      state.measured.body_rates.push_back(member->rate + member->motion.turn_rate() +
                                          member->modal_rate());
    state.measured.probes = measure_probes(model_.probes);
  }

  ReducedPair::Reader ReducedPair::reader(const unsigned int b) const
  {
    const Member &member = *members_[b];
    return [&member,
            coordinates = member.coordinates(),
            force       = VectorXd(rows_of(member, now_.force))](const unsigned int reading,
                                                           const unsigned int sector) {
      const std::size_t row = 3 * member.body.touch_nodes.size() + reading;
      return member.spin * member.body.spin[row] +
             member.rows.read(reading, sector, coordinates, force, member.axial);
    };
  }

  std::vector<ProbeValue> ReducedPair::measure_probes(const std::vector<Probe> &probes) const
  {
    std::vector<ProbeValue> measured;
    for (const Probe &probe : probes)
      {
        const ReducedBody    &reduced = body(probe.body);
        const Reader          read    = reader(probe.body);
        std::array<double, 9> values{};
        for (unsigned int c = 0; c < values.size(); ++c)
          values[c] = read(reduced.find_reading(reading::of_probe(probe.name, c)),
                           reduced.sector_of(probe.node));
        // Along the body's axes as the probe's copy in sector 0 sees them; r, theta, z turn with
        // the sector.
        const Body   &bulk = model_.bodies[probe.body];
        const Matrix3 axes =
          compute_cylindrical_axes(bulk, bulk.node_positions()[reduced.first_copy(probe.node)]);
        measured.push_back(
          make_probe_value(axes.transpose() * Eigen::Map<const Vector3>(values.data()),
                           Eigen::Map<const Stress>(values.data() + 3),
                           {axes}));
      }
    return measured;
  }

  std::vector<VectorXcd> ReducedPair::measure_modal_forces(const unsigned int body) const
  {
    const Member &member = *members_[body];
    return member.rows.project(rows_of(member, now_.force));
  }

  double ReducedPair::measure_turn(const unsigned int body) const
  {
    return members_[body]->motion.turn();
  }

  std::vector<double> ReducedPair::measure_rim(const unsigned int largest)
  {
    // A wave is the sum over sectors k of exp(i n k alpha) (a_k + i b_k), a and b its readings
    // [mm]: of all nodes of the rim, share u exp(i n alpha).
    Member                      &member      = *members_[model_.only_transmission()->driven];
    const ReducedBody           &body        = member.body;
    const std::vector<VectorXcd> coordinates = member.coordinates();
    const VectorXd               force       = rows_of(member, now_.force);
    std::vector<double>          coefficients;
    for (unsigned int c = 0; c < 3; ++c)
      {
        const unsigned int mean = body.find_reading(reading::of_rim(c, 0, false));
        coefficients.push_back(
          1e3 * (body.n_sectors * member.spin * body.spin[3 * body.touch_nodes.size() + mean] +
                 member.rows.read_all(mean, coordinates, force, member.axial)));
        for (unsigned int n = 1; n <= largest; ++n)
          {
            const auto read = [&](const bool imaginary) {
              return member.rows.read_wave(body.find_reading(reading::of_rim(c, n, imaginary)),
                                           n,
                                           coordinates,
                                           force);
            };
            const std::complex<double> sum =
              read(false) + std::complex<double>(0., 1.) * read(true);
            coefficients.push_back(2e3 * sum.real());
            coefficients.push_back(2e3 * sum.imag());
          }
      }
    return coefficients;
  }
} // namespace vfife
