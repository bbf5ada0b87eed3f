// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// The equilibrium from which a ReducedPair starts, and the motion with which it goes on.
#include "matrix_stream.h"
#include "reduced_pair_parts.h"

#include <vfife/base/text/byte_stream.h>
#include <vfife/reduced/pair_readings.h>

#include <cmath>

namespace vfife
{
  using Eigen::VectorXcd;
  using Eigen::VectorXd;

  namespace
  {
    /** Unbalanced forces over contact forces. */
    constexpr double start_tolerance = 1e-9;
    /** Iterations after which a balance with points on the edges of facets will do. */
    constexpr unsigned int start_patience = 40;
  } // namespace

  ReducedEquilibrium ReducedPair::start(const double part, const double rate)
  {
    time_ = driver_turn_ = 0;
    step_ = n_iterations_ = 0;
    widening_             = 0;
    for (unsigned int b = 0; b < members_.size(); ++b)
      {
        Member &member = *members_[b];
        member.axial   = {torque_on(model_, b, 0.), 0.};
        member.set_rate(speed_factor() * model_.bodies[b].rate);
        member.follow_rate(options_.step);
      }
    Member &driven = *members_[model_.only_transmission()->driven];
    load_          = part * driven.axial.torque;
    // What the flanks have beyond the load accelerates the body.
    driven.axial.acceleration = (1. - part) * driven.axial.torque / driven.inertia;
    now_                      = PressedState();
    earlier_force_.resize(0);
    pair_.set_position(0.);
    search();

    // Modes give way as they do to forces that stand still in space.
    std::vector<TouchRows>         rows;
    std::vector<const TouchRows *> pointers;
    for (unsigned int b = 0; b < members_.size(); ++b)
      {
        const Member &member = *members_[b];
        rows.emplace_back(member.body,
                          member.standing_gains(),
                          RingAxes{member.rows.placement(), model_.only_transmission()->arm});
        rows.back().set_nodes(nodes_of(nodes_, b));
      }
    for (const TouchRows &one : rows)
      pointers.push_back(&one);
    Answers answers(*this, pointers);

    springs_.set_dampers({}, 0.);
    const VectorXd base      = displace(standing_coordinates());
    now_                     = pair_.press_rigid(answers, base, load_, settle(answers, base));
    now_.unit                = std::abs(load_) / model_.only_transmission()->arm;
    now_.patience            = start_patience;
    const unsigned int n     = pair_.balance(answers, base, TurnLoad{load_}, start_tolerance, now_);
    ReducedEquilibrium found = find_slope(answers, base + now_.deflection);
    found.turn               = now_.turn;
    found.iterations         = n;

    stand();
    driven.motion.add_turn_rate(rate);
    driven.axial.acceleration = 0.;
    load_                     = driven.axial.torque;
    now_.patience             = PressedState().patience;
    rows_                     = base + now_.deflection;
    now_.deflection           = answers_->answer(now_.force);
    set_bearings(rows_);
    check_reach(nodes_, displace_nodes(nodes_));
    restart_energy();
    contact_impulse_ = ContactImpulse();
    add_contact_impulse();
    return found;
  }

  std::vector<std::vector<VectorXcd>> ReducedPair::standing_coordinates() const
  {
    std::vector<std::vector<VectorXcd>> coordinates;
    for (const auto &member : members_)
      {
        std::vector<VectorXcd> &own =
          coordinates.emplace_back(member->forces_of(member->axial).modes);
        for (std::size_t i = 0; i < own.size(); ++i)
          own[i] = member->motion.standing_flexibility(i, member->sector_rate) * own[i];
      }
    return coordinates;
  }

  void ReducedPair::stand()
  {
    const std::vector<ModalForces> contact = project(now_);
    for (std::size_t b = 0; b < members_.size(); ++b)
      {
        Member     &member = *members_[b];
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
    springs_.set_dampers({}, 0.);
    advance_drive();
    search_when_due();
    balance_widely(standing_coordinates(), TurnLoad{load_});
    stand();
    set_bearings(rows_);
  }

  void ReducedPair::serialize(ByteStream &stream)
  {
    double step = options_.step;
    stream.pass(time_, step_, driver_turn_, driver_rate_, load_, step, n_iterations_);
    stream.require(step == options_.step, "a motion in steps of another length");
    for (const auto &member : members_)
      {
        double rate = member->rate, of_modes = member->motion.rate(), of_gains = member->gain_rate;
        stream.pass(rate, of_modes, of_gains, member->axial.torque, member->axial.acceleration);
        if (stream.reads())
          {
            member->set_rate(rate);
            member->motion.change(of_gains, step);
            member->set_gains();
            member->motion.change(of_modes, step);
          }
        member->motion.serialize(stream);
      }
    std::vector<NodeOfBody> nodes = nodes_;
    stream.pass(search_steps_, since_search_, widening_, searched_from_, searched_to_, nodes);
    pass_matrix(held_, stream);
    if (stream.reads())
      {
        now_ = PressedState();
        earlier_force_.resize(0);
        pair_.set_position(searched_from_);
        pair_.find_candidates(searched_to_);
        if (held_.size() > 0)
          pair_.hold(held_);
        set_rows(std::move(nodes));
        pair_.set_position(driver_turn_);
      }
    stream.pass(now_.turn, now_.unit, earlier_torque_);
    for (VectorXd *const vector : {&now_.force, &earlier_force_, &rows_})
      pass_matrix(*vector, stream);
    stream.pass_record(energy_);
    stream.pass_record(first_energy_);
    if (!stream.reads())
      return;
    stream.require(now_.force.size() == n_rows() && rows_.size() == n_rows(),
                   "forces at other nodes");
    springs_.set_dampers({}, 0.);
    now_.acting     = pair_.evaluate(*answers_, rows_, now_.turn, true);
    now_.deflection = answers_->answer(now_.force);
    bearings_ = damped_ = answers_->evaluate_bearings(rows_);
  }

  ReducedEquilibrium ReducedPair::find_slope(Answers &answers, const VectorXd &u)
  {
    // Per unit of the torque: the bodies twist further, and the springs answer.
    VectorXd                            twist(u.size());
    std::vector<std::vector<VectorXcd>> changes;
    for (const auto &one : members_)
      {
        const Member          &member = *one;
        const AxialLoad        unit{member.axial.torque / load_, 0.};
        std::vector<VectorXcd> modes = member.forces_of(unit).modes;
        for (std::size_t i = 0; i < modes.size(); ++i)
          modes[i] = member.motion.standing_flexibility(i, member.sector_rate) * modes[i];
        const VectorXd own = member.rows.under(unit) + member.rows.displace(modes);
        for (std::size_t i = 0; i < member.places.size(); ++i)
          twist[member.places[i]] = own[i];
        changes.push_back(std::move(modes));
      }
    const auto [force, turn] = pair_.find_slope(answers, u, TurnLoad{load_}, twist, 1.);

    ReducedEquilibrium  slope;
    const Transmission &t     = *model_.only_transmission();
    double              twice = 0;
    for (std::size_t b = 0; b < members_.size(); ++b)
      {
        const Member                &member = *members_[b];
        const std::vector<VectorXcd> modal  = member.rows.project(rows_of(member, force));
        for (std::size_t i = 0; i < modal.size(); ++i)
          {
            changes[b][i] += member.motion.standing_flexibility(i, member.sector_rate) * modal[i];
            twice += changes[b][i].squaredNorm();
          }
      }
    const Member &driven = *members_[t.driven];
    twice += driven.body.turn_inertia * turn * turn;
    const double hub = turn + driven.rows.read_all(driven.body.find_reading(reading::bore_turn),
                                                   changes[t.driven],
                                                   rows_of(driven, force),
                                                   AxialLoad{1., 0.});
    slope.stiffness  = std::abs(1. / hub);
    slope.inertia    = twice / (hub * hub);
    return slope;
  }
} // namespace vfife
