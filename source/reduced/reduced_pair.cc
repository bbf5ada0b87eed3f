// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include "reduced_pair_parts.h"

#include <vfife/base/errors.h>
#include <vfife/model/state.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace vfife
{
  using Eigen::MatrixXcd;
  using Eigen::VectorXcd;
  using Eigen::VectorXd;

  namespace
  {
    /** Part of a tooth by which bodies may turn against each other in a step. */
    constexpr double largest_turn = .1;

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
    , options_(options)
    , pair_(model)
    , springs_(make_bearing_springs(model, bodies))
    , load_(torque_on(model, model.only_transmission()->driven, 0.))
  {
    std::vector<const TouchRows *> rows;
    for (unsigned int b = 0; b < bodies.size(); ++b)
      {
        members_.push_back(std::make_unique<Member>(model, b, std::move(bodies[b]), options));
        rows.push_back(&members_.back()->rows);
      }
    answers_     = std::make_unique<Answers>(*this, rows);
    driver_rate_ = model.only_transmission()->driver_rate;
  }

  ReducedPair::~ReducedPair() = default;

  const ReducedBody &ReducedPair::body(const unsigned int b) const
  {
    return members_[b]->body;
  }

  double ReducedPair::speed_factor() const
  {
    return driver_rate_ / model_.only_transmission()->driver_rate *
           model_.only_transmission()->rate_history.value(time_);
  }

  void ReducedPair::set_speed(const double driver_rate, const double step)
  {
    driver_rate_  = driver_rate;
    options_.step = step;
    for (unsigned int b = 0; b < members_.size(); ++b)
      {
        Member &member = *members_[b];
        member.set_rate(speed_factor() * model_.bodies[b].rate);
        member.motion.change(member.rate, step);
        member.set_gains();
      }
    stands_ = false;
    // Steps of another length are no ground to go on from.
    earlier_force_.resize(0);
    if (nodes_.empty()) // before start()
      return;
    search();
    now_.deflection = answers_->answer(now_.force);
    restart_energy();
  }

  double ReducedPair::sector_sense(const unsigned int b) const
  {
    return members_[b]->sense;
  }

  double ReducedPair::driver_turn(const double n_steps) const
  {
    const Transmission &t    = *model_.only_transmission();
    const double        time = n_steps * options_.step;
    return t.has_constant_rate() ? driver_turn_ + driver_rate_ * time : t.driver_turn(time_ + time);
  }

  double ReducedPair::driven_turn() const
  {
    return model_.only_transmission()->ratio() * driver_turn_;
  }

  VectorXd ReducedPair::rows_of(const Member &member, const VectorXd &x) const
  {
    VectorXd own(member.places.size());
    for (std::size_t i = 0; i < member.places.size(); ++i)
      own[i] = x[member.places[i]];
    return own;
  }

  VectorXd ReducedPair::displace(const std::vector<std::vector<VectorXcd>> &coordinates) const
  {
    VectorXd u(n_rows());
    for (std::size_t b = 0; b < members_.size(); ++b)
      {
        const Member  &member = *members_[b];
        const VectorXd own    = member.spin * member.rows.spin() + member.rows.under(member.axial) +
                             member.rows.displace(coordinates[b]);
        for (std::size_t i = 0; i < member.places.size(); ++i)
          u[member.places[i]] = own[i];
      }
    return u;
  }

  std::vector<ModalForces> ReducedPair::project(const PressedState &state) const
  {
    std::vector<ModalForces> forces;
    for (const auto &member : members_)
      forces.push_back({member->rows.project(rows_of(*member, state.force)), 0.});
    forces[model_.only_transmission()->driven].moment = state.acting.torque;
    return forces;
  }

  std::vector<AxialLoad> ReducedPair::advance_drive()
  {
    driver_turn_ = driver_turn(1.);
    ++step_;
    time_ += options_.step;
    pair_.set_position(driver_turn_);
    std::vector<AxialLoad> mean;
    for (unsigned int b = 0; b < members_.size(); ++b)
      {
        Member      &member = *members_[b];
        const double before = member.rate, torque = member.axial.torque;
        member.axial.torque = torque_on(model_, b, time_);
        if (!model_.only_transmission()->has_constant_rate())
          {
            member.set_rate(speed_factor() * model_.bodies[b].rate);
            member.axial.acceleration = (member.rate - before) / options_.step;
            member.follow_rate(options_.step);
          }
        if (b == model_.only_transmission()->driver)
          energy_.drive_work += .5 * member.inertia * (member.rate * member.rate - before * before);
        mean.push_back({.5 * (torque + member.axial.torque), member.axial.acceleration});
      }
    load_     = members_[model_.only_transmission()->driven]->axial.torque;
    now_.unit = std::max(now_.unit, std::abs(load_) / model_.only_transmission()->arm);
    return mean;
  }

  bool ReducedPair::balance(const std::vector<std::vector<VectorXcd>> &coordinates,
                            const TurnLoad                            &load)
  {
    // From forces that go on as they did.
    const VectorXd base           = displace(coordinates);
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
        n_iterations_ += pair_.balance(*answers_, base, load, options_.tolerance, now_);
      }
    catch (const StrayContact &)
      {
        now_.force         = present;
        now_.acting.torque = present_torque;
        return false;
      }
    rows_ = base + now_.deflection;
    if (springs_.has_dampers())
      damped_ = answers_->evaluate_bearings(rows_);
    earlier_force_  = present;
    earlier_torque_ = present_torque;
    return true;
  }

  void ReducedPair::check_turn(const double turned) const
  {
    const Transmission &t = *model_.only_transmission();
    if (std::abs(turned) * t.driven_teeth < largest_turn * 2. * pi)
      return;
    std::ostringstream text;
    text << "at step " << step_ << " (" << 1e3 * time_ << " ms) the driven body rotated by "
         << turned * 180. / pi << " degrees beyond the driver in one step of "
         << 1e6 * options_.step
         << " us, so that flanks pass through each other. Increase Reduced/steps per mesh cycle";
    throw NumericalError(text.str());
  }

  void ReducedPair::search_when_due()
  {
    if (++since_search_ < search_steps_)
      return;
    widening_ -= widening_ > 0 ? 1 : 0;
    search();
  }

  void ReducedPair::balance_widely(const std::vector<std::vector<VectorXcd>> &coordinates,
                                   const TurnLoad                            &load)
  {
    while (!balance(coordinates, load))
      {
        ++widening_;
        search();
      }
  }

  void ReducedPair::step()
  {
    const Transmission &t      = *model_.only_transmission();
    const auto          before = bearings_;
    springs_.set_dampers(before, options_.step);
    const double             way    = torque_way();
    const EnergyLedger       powers = find_powers();
    std::vector<ModalForces> half   = project(now_);

    // 1. Where the bodies would be with half the present contact forces alone.
    const std::vector<AxialLoad> axial = advance_drive();
    search_when_due();
    std::vector<std::vector<VectorXcd>> coordinates(members_.size());
    TurnLoad                            load;
    for (std::size_t b = 0; b < members_.size(); ++b)
      {
        const Member &member = *members_[b];
        ModalForces   forces = member.forces_of(axial[b]);
        forces.add(.5, half[b]);
        half[b] = std::move(forces);
        for (std::size_t i = 0; i < half[b].modes.size(); ++i)
          coordinates[b].push_back(member.motion.expect(i, half[b]));
        if (b == t.driven)
          load = {0., 1. / member.motion.turn_gain(), member.motion.expect_turn(half[b])};
      }

    // 2. The contact at the end of the step.
    const double turn = now_.turn;
    balance_widely(coordinates, load);
    check_turn(now_.turn - turn);

    // 3. The motion with the mean of the forces at both ends.
    const std::vector<ModalForces> after = project(now_);
    for (std::size_t b = 0; b < members_.size(); ++b)
      {
        half[b].add(.5, after[b]);
        members_[b]->motion.advance(half[b]);
      }
    set_bearings(rows_);
    add_work(axial[t.driven].torque, way, powers);
    if (springs_.has_dampers())
      add_damping(before);
    add_contact_impulse();
  }
} // namespace vfife
