// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include "matrix_stream.h"

#include <vfife/base/errors.h>
#include <vfife/base/text/byte_stream.h>
#include <vfife/fem/pair/pressed_balance.h>
#include <vfife/model/model.h>
#include <vfife/model/pair_measures.h>
#include <vfife/model/state.h>
#include <vfife/reduced/pair_readings.h>
#include <vfife/reduced/reduced_pair.h>

#include <algorithm>
#include <cmath>

namespace vfife
{
  using Eigen::VectorXcd;
  using Eigen::VectorXd;

  namespace
  {
    /** Unbalanced forces over contact forces at the start. */
    constexpr double start_tolerance = 1e-9;
    /** Iterations after which there a balance with points on the edges of facets will do. */
    constexpr unsigned int start_patience = 40;

    const Model &require_pair(const Model &model, const std::vector<ReducedBody> &bodies)
    {
      require_reducible(model);
      if (!bodies[model.only_transmission()->driven].turns)
        throw InputError("body \"" + model.bodies[model.only_transmission()->driven].name() +
                         "\" is driven, but a constraint holds its rotation about its axis");
      return model;
    }
  } // namespace

  void require_reducible(const Model &model)
  {
    if (model.transmissions.empty() || model.contacts.empty())
      throw InputError("expected a gear pair with contact");
    for (const Body &body : model.bodies)
      body.require_no_initial_strains("reduced bodies");
    for (const ContactPair &pair : model.contacts)
      if (pair.options.damping_ratio > 0 || pair.options.friction.acts())
        throw InputError("contact \"" + pair.side +
                         "\": a reduced pair does not support friction and damping of the contact. "
                         "Set Contact/friction coefficient and Contact/damping ratio to 0");
  }

  ReducedPair::ReducedPair(const Model              &model,
                           std::vector<ReducedBody>  bodies,
                           const ReducedPairOptions &options)
    : model_(require_pair(model, bodies))
    , tolerance_(options.tolerance)
    , pair_(model)
    , drive_(model, options.step)
    , rows_(model, members_, pair_, drive_)
    , bearings_(model, bodies, pair_)
    , energy_(model, members_, drive_, bearings_, now_)
    , reader_(model, members_, pair_, rows_, now_)
  {
    std::vector<const TouchRows *> rows;
    for (unsigned int b = 0; b < bodies.size(); ++b)
      {
        members_.push_back(
          std::make_unique<PairMember>(model,
                                       b,
                                       std::move(bodies[b]),
                                       ModalDamping{options.damping, options.mesh_damping},
                                       options.step));
        rows.push_back(&members_.back()->rows);
      }
    answers_ = std::make_unique<PairAnswers>(members_, rows_, bearings_, rows);
  }

  void ReducedPair::set_speed(const double driver_rate, const double step)
  {
    drive_.driver_rate = driver_rate;
    drive_.step        = step;
    for (unsigned int b = 0; b < members_.size(); ++b)
      {
        PairMember &member = *members_[b];
        member.set_rate(drive_.rate_factor() * model_.bodies[b].rate);
        member.motion.change(member.rate, step);
        member.set_gains();
      }
    stands_ = false;
    // Steps of another length are no ground to go on from.
    earlier_force_.resize(0);
    if (rows_.nodes().empty()) // before start()
      return;
    rows_.search(now_, earlier_force_);
    now_.deflection = answers_->answer(now_.force);
    energy_.restart();
  }

  std::vector<ModalForces> ReducedPair::project() const
  {
    std::vector<ModalForces> forces;
    for (const auto &member : members_)
      forces.push_back({member->rows.project(member->part_of(now_.force)), 0.});
    forces[model_.only_transmission()->driven].moment = now_.acting.torque;
    return forces;
  }

  std::vector<AxialLoad> ReducedPair::advance_drive()
  {
    const std::vector<AxialLoad> mean = drive_.advance(members_, energy_.ledger);
    pair_.set_position(drive_.turn);
    now_.unit = std::max(now_.unit, std::abs(load()) / model_.only_transmission()->arm);
    return mean;
  }

  bool ReducedPair::balance_at_rows(const std::vector<std::vector<VectorXcd>> &coordinates,
                                    const TurnLoad                            &load)
  {
    // From forces that go on as they did.
    const VectorXd base           = rows_.displace(coordinates);
    const double   present_torque = now_.acting.torque;
    double         torque         = present_torque;
    const VectorXd present        = now_.force;
    if (earlier_force_.size() > 0)
      {
        now_.force += present - earlier_force_;
        torque += torque - earlier_torque_;
      }
    now_.deflection = answers_->answer(now_.force);
    if (load.stiffness > 0)
      now_.turn = load.rest + torque / load.stiffness;
    try
      {
        now_.acting = pair_.evaluate(*answers_, base + now_.deflection, now_.turn, true);
        n_iterations_ += PressedBalance(pair_, *answers_, base, load).find(tolerance_, now_);
      }
    catch (const StrayContact &)
      {
        now_.force         = present;
        now_.acting.torque = present_torque;
        return false;
      }
    displacements_ = base + now_.deflection;
    bearings_.end_step(displacements_);
    earlier_force_  = present;
    earlier_torque_ = present_torque;
    return true;
  }

  void ReducedPair::balance(const std::vector<std::vector<VectorXcd>> &coordinates,
                            const TurnLoad                            &load)
  {
    while (!balance_at_rows(coordinates, load))
      {
        ++rows_.widening;
        rows_.search(now_, earlier_force_);
      }
  }

  void ReducedPair::set_bearings()
  {
    if (bearings_.n_rows() == 0)
      return;
    bearings_.set(displacements_);
    const BearingSprings::Response &present = bearings_.present();
    now_.force.tail(present.force.size())   = present.force;
    now_.acting.torque                      = now_.acting.contact_torque + present.torque;
    now_.deflection                         = answers_->answer(now_.force);
  }

  void ReducedPair::step()
  {
    const unsigned int driven = model_.only_transmission()->driven;
    bearings_.begin_step(time_step());
    energy_.begin_step();
    std::vector<ModalForces> half = project();

    // 1. Where the bodies would be with half the present contact forces alone.
    const std::vector<AxialLoad> axial = advance_drive();
    rows_.search_when_due(now_, earlier_force_);
    std::vector<std::vector<VectorXcd>> coordinates(members_.size());
    TurnLoad                            load;
    for (std::size_t b = 0; b < members_.size(); ++b)
      {
        const PairMember &member = *members_[b];
        ModalForces       forces = member.forces_of(axial[b]);
        forces.add(.5, half[b]);
        half[b] = std::move(forces);
        for (std::size_t i = 0; i < half[b].modes.size(); ++i)
          coordinates[b].push_back(member.motion.expect(i, half[b]));
        if (b == driven)
          load = {0., 1. / member.motion.turn_gain(), member.motion.expect_turn(half[b])};
      }

    // 2. The contact at the end of the step.
    const double turn = now_.turn;
    balance(coordinates, load);
    drive_.check_turn(now_.turn - turn);

    // 3. The motion with the mean of the forces at both ends.
    const std::vector<ModalForces> after = project();
    for (std::size_t b = 0; b < members_.size(); ++b)
      {
        half[b].add(.5, after[b]);
        members_[b]->motion.advance(half[b]);
      }
    set_bearings();
    energy_.end_step(axial[driven].torque);
    add_contact_impulse();
  }

  ReducedEquilibrium ReducedPair::start(const double part, const double rate)
  {
    drive_.time = drive_.turn = 0;
    drive_.n_steps = n_iterations_ = 0;
    rows_.widening                 = 0;
    for (unsigned int b = 0; b < members_.size(); ++b)
      {
        PairMember &member = *members_[b];
        member.axial       = {torque_on(model_, b, 0.), 0.};
        member.set_rate(drive_.rate_factor() * model_.bodies[b].rate);
        member.follow_rate(time_step());
      }
    PairMember &driven = *members_[model_.only_transmission()->driven];
    drive_.load        = part * driven.axial.torque;
    // What the flanks have beyond the load accelerates the body.
    driven.axial.acceleration = (1. - part) * driven.axial.torque / driven.inertia;
    now_                      = PressedState();
    earlier_force_.resize(0);
    pair_.set_position(0.);
    rows_.search(now_, earlier_force_);

    // Modes give way as they do to forces that stand still in space.
    std::vector<TouchRows>         rows;
    std::vector<const TouchRows *> pointers;
    for (unsigned int b = 0; b < members_.size(); ++b)
      {
        const PairMember &member = *members_[b];
        rows.emplace_back(member.body,
                          member.standing_gains(),
                          RingAxes{member.rows.placement(), model_.only_transmission()->arm});
        rows.back().set_nodes(PairRows::nodes_of(rows_.nodes(), b));
      }
    for (const TouchRows &one : rows)
      pointers.push_back(&one);
    PairAnswers answers(members_, rows_, bearings_, pointers);

    bearings_.begin_step(0.);
    const VectorXd base = rows_.displace(standing_coordinates());
    now_                = pair_.press_rigid(answers, base, load(), settle(answers, base));
    now_.unit           = std::abs(load()) / model_.only_transmission()->arm;
    now_.patience       = start_patience;
    PressedBalance     equilibrium(pair_, answers, base, TurnLoad{load()});
    const unsigned int n     = equilibrium.find(start_tolerance, now_);
    ReducedEquilibrium found = find_slope(equilibrium);
    found.turn               = now_.turn;
    found.iterations         = n;

    stand();
    driven.motion.add_turn_rate(rate);
    driven.axial.acceleration = 0.;
    drive_.load               = driven.axial.torque;
    now_.patience             = PressedState().patience;
    displacements_            = base + now_.deflection;
    now_.deflection           = answers_->answer(now_.force);
    set_bearings();
    rows_.check_reach(rows_.nodes(), rows_.displace_nodes(rows_.nodes(), now_.force));
    energy_.restart();
    contact_impulse_ = ContactImpulse();
    add_contact_impulse();
    return found;
  }

  std::vector<std::vector<VectorXcd>> ReducedPair::standing_coordinates() const
  {
    std::vector<std::vector<VectorXcd>> coordinates;
    for (const auto &member : members_)
      coordinates.push_back(member->standing_coordinates(member->axial));
    return coordinates;
  }

  void ReducedPair::stand()
  {
    const std::vector<ModalForces> contact = project();
    for (std::size_t b = 0; b < members_.size(); ++b)
      {
        PairMember &member = *members_[b];
        ModalForces forces = member.forces_of(member.axial);
        forces.add(1., contact[b]);
        member.motion.stand(forces, member.body.turns ? now_.turn : 0., member.sector_rate);
      }
  }

  void ReducedPair::step_standing()
  {
    if (!stands_)
      for (const auto &member : members_)
        member->rows.set_gains(member->standing_gains());
    stands_ = true;
    bearings_.begin_step(0.);
    advance_drive();
    rows_.search_when_due(now_, earlier_force_);
    balance(standing_coordinates(), TurnLoad{load()});
    stand();
    set_bearings();
  }

  PressedState ReducedPair::settle(PairAnswers &answers, const VectorXd &base)
  {
    PressedState now;
    now.force = now.deflection = VectorXd::Zero(base.size());
    if (bearings_.n_rows() == 0)
      return now;
    now.touching = false;
    now.unit     = std::abs(load()) / model_.only_transmission()->arm;
    now.acting   = pair_.evaluate(answers, base, 0., false);
    PressedBalance(pair_, answers, base, TurnLoad{}).find(tolerance_, now);
    return now;
  }

  void ReducedPair::serialize(ByteStream &stream)
  {
    double step = time_step();
    drive_.serialize(stream);
    stream.pass(step, n_iterations_);
    stream.require(step == time_step(), "a motion in steps of another length");
    for (const auto &member : members_)
      member->serialize(step, stream);
    rows_.serialize(now_, earlier_force_, stream);
    stream.pass(now_.turn, now_.unit, earlier_torque_);
    for (VectorXd *const vector : {&now_.force, &earlier_force_, &displacements_})
      pass_matrix(*vector, stream);
    energy_.serialize(stream);
    if (!stream.reads())
      return;
    stream.require(now_.force.size() == rows_.size() && displacements_.size() == rows_.size(),
                   "forces at other nodes");
    bearings_.begin_step(0.);
    now_.acting     = pair_.evaluate(*answers_, displacements_, now_.turn, true);
    now_.deflection = answers_->answer(now_.force);
    bearings_.set(displacements_);
    bearings_.end_step(displacements_);
  }

  ReducedEquilibrium ReducedPair::find_slope(PressedBalance &equilibrium) const
  {
    // Per unit of the torque: the bodies twist further, and the springs answer.
    VectorXd                            twist(rows_.size());
    std::vector<std::vector<VectorXcd>> changes;
    for (const auto &one : members_)
      {
        const PairMember      &member = *one;
        const AxialLoad        unit{member.axial.torque / load(), 0.};
        std::vector<VectorXcd> modes = member.standing_coordinates(unit);
        const VectorXd         own   = member.rows.under(unit) + member.rows.displace(modes);
        for (std::size_t i = 0; i < member.places.size(); ++i)
          twist[member.places[i]] = own[i];
        changes.push_back(std::move(modes));
      }
    const auto [force, turn] = equilibrium.find_slope(now_, twist, 1.);

    ReducedEquilibrium  slope;
    const Transmission &t     = *model_.only_transmission();
    double              twice = 0;
    for (std::size_t b = 0; b < members_.size(); ++b)
      {
        const PairMember            &member = *members_[b];
        const std::vector<VectorXcd> modal  = member.rows.project(member.part_of(force));
        for (std::size_t i = 0; i < modal.size(); ++i)
          {
            changes[b][i] += member.motion.standing_flexibility(i, member.sector_rate) * modal[i];
            twice += changes[b][i].squaredNorm();
          }
      }
    const PairMember &driven = *members_[t.driven];
    twice += driven.body.turn_inertia * turn * turn;
    const double hub = turn + driven.rows.read_all(driven.body.find_reading(reading::bore_turn),
                                                   changes[t.driven],
                                                   driven.part_of(force),
                                                   AxialLoad{1., 0.});
    slope.stiffness  = std::abs(1. / hub);
    slope.inertia    = twice / (hub * hub);
    return slope;
  }

  void ReducedPair::measure_angles(Measurements &measured) const
  {
    const Transmission &t    = *model_.only_transmission();
    const auto          read = [&](const unsigned int b, const char *const reading) {
      return members_[b]->read_turn(reading, members_[b]->part_of(now_.force));
    };
    measured.driver_angle =
      t.driver_bore.empty() ? 0. : t.driver_sense * read(t.driver, reading::bore_turn);
    measured.driven_angle = t.driven_sense * read(t.driven, reading::bore_turn);
    measured.rim_angle    = t.driven_sense * read(t.driven, reading::rim_turn);
    complete_angles(t, drive_.turn, measured);
  }

  void ReducedPair::measure_contact(State &state) const
  {
    Measurements &m = state.measured;
    set_teeth(pair_.teeth(), model_.contacts.size(), m);
    if (state.contact_force.empty())
      return;
    state.contact_force.set_zero();
    for (std::size_t i = 0; i < rows_.nodes().size(); ++i)
      {
        const auto &[b, node] = rows_.nodes()[i];
        state.contact_force.set(model_.bodies[b].first_node + node,
                                pair_.to_fixed_frame(i, now_.force.segment<3>(3 * i)));
      }
  }

  void ReducedPair::add_contact_impulse()
  {
    Measurements measured;
    set_teeth(pair_.teeth(), model_.contacts.size(), measured);
    contact_impulse_.add(time_step(), measured.contact_force, measured.contact_torque);
  }

  double ReducedPair::measure_drive_torque() const
  {
    const PairMember &driver = *members_[model_.only_transmission()->driver];
    double torque = driver.inertia * driver.axial.acceleration - now_.acting.driver_torque;
    if (!driver.in_bearings())
      return torque;
    // What turns the shaft's end.
    torque = 0;
    for (const Coupling &coupling : model_.couplings)
      if (coupling.body == model_.only_transmission()->driver)
        {
          const auto [way, rate] = driver.twist(coupling, driver.part_of(now_.force));
          torque -= coupling.stiffness * way + coupling.damping * rate;
        }
    return torque;
  }

  void ReducedPair::measure(State &state)
  {
    state.time = drive_.time;
    state.step = drive_.n_steps;
    state.dt   = time_step();
    measure_angles(state.measured);
    measure_contact(state);
    energy_.measure();
    state.measured.energy       = energy_.ledger;
    state.measured.bearings     = bearings_.measure(drive_.n_steps > 0);
    state.measured.drive_torque = measure_drive_torque();
    state.measured.rate_factor  = drive_.rate_factor();
    state.measured.body_rates.clear();
    for (const auto &member : members_)
      state.measured.body_rates.push_back(member->rate + member->motion.turn_rate() +
                                          member->modal_rate());
    state.measured.probes = reader_.read_probes(model_.probes);
  }
} // namespace vfife
