// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/text/byte_stream.h>
#include <vfife/model/model.h>
#include <vfife/reduced/pair/pair_energy.h>

#include <algorithm>

namespace vfife
{
  using Eigen::VectorXcd;
  using Eigen::VectorXd;

  PairEnergy::PairEnergy(const Model        &model,
                         const PairMembers  &members,
                         const PairDrive    &drive,
                         const PairBearings &bearings,
                         const PressedState &now)
    : transmission_(*model.only_transmission())
    , members_(members)
    , drive_(drive)
    , bearings_(bearings)
    , now_(now)
  {
  }

  double PairEnergy::torque_way() const
  {
    const PairMember &driven = *members_[transmission_.driven];
    // The turn with its kinematic part, and what the modes and the residual flexibility make of the
    // bore, as the torque sees it.
    double way = transmission_.driven_sense * drive_.driven_turn() + driven.motion.turn() +
                 driven.rows.torque().dot(driven.part_of(now_.force));
    for (std::size_t i = 0; i < driven.body.harmonics.size(); ++i)
      if (driven.body.harmonics[i].number == 0 && driven.body.harmonics[i].n_modes() > 0)
        way += driven.body.harmonics[i].torque.dot(driven.motion.coordinates(i)).real();
    return way;
  }

  EnergyLedger PairEnergy::find_powers() const
  {
    const unsigned int driver = transmission_.driver;
    EnergyLedger       powers;
    powers.drive_work = -now_.acting.driver_torque * members_[driver]->rate;
    if (bearings_.n_rows() > 0)
      {
        const BearingSprings::Response &bearings = bearings_.present();
        powers.drive_work -= bearings.torques[driver] * members_[driver]->rate;
        for (std::size_t b = 0; b < members_.size(); ++b)
          powers.drive_work += bearings.cage_slopes[b] * members_[b]->rate;
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

  void PairEnergy::begin_step()
  {
    way_    = torque_way();
    powers_ = find_powers();
  }

  void PairEnergy::end_step(const double torque)
  {
    const EnergyLedger &before = powers_, after = find_powers();
    const double        half = .5 * drive_.step;
    ledger.drive_work += half * (before.drive_work + after.drive_work);
    ledger.damping_loss += half * (before.damping_loss + after.damping_loss);
    ledger.mesh_damping_uptake += half * (before.mesh_damping_uptake + after.mesh_damping_uptake);
    ledger.swing_loss += half * (before.swing_loss + after.swing_loss);
    ledger.torque_work += torque * (torque_way() - way_);
    bearings_.add_damping(members_[transmission_.driver]->rate, drive_.step, ledger);
  }

  void PairEnergy::restart()
  {
    ledger = EnergyLedger();
    measure();
    ledger.start = ledger.kinetic + ledger.strain + ledger.contact;
    ledger.scale = EnergyLedger::scale_floor * ledger.kinetic;
    first_       = ledger;
  }

  void PairEnergy::measure()
  {
    ledger.kinetic = ledger.kinetic_relative = ledger.strain = 0;
    for (const auto &one : members_)
      {
        const PairMember &member = *one;
        const VectorXd    force  = member.part_of(now_.force);
        const double      rate   = member.rate + member.motion.turn_rate();
        ledger.kinetic_relative += member.motion.kinetic();
        ledger.kinetic += .5 * member.inertia * rate * rate +
                          member.rate * member.rate * member.motion.added_inertia();
        ledger.strain += member.motion.strain();
        // What the residual flexibility stores: that at once, less the modes' part of it.
        ledger.strain += .5 * force.dot(member.part_of(now_.deflection)) +
                         member.rows.under(member.axial).dot(force);
        const std::vector<VectorXcd> modal = member.rows.project(force);
        for (std::size_t i = 0; i < modal.size(); ++i)
          ledger.strain -= .5 * modal[i].dot(member.motion.gain(i) * modal[i]).real();
      }
    ledger.strain += bearings_.present().energy;
    ledger.kinetic += ledger.kinetic_relative;
    ledger.contact = now_.acting.contact_energy;
    ledger.scale   = std::max(ledger.scale, ledger.exchanged_since(first_));
  }

  void PairEnergy::serialize(ByteStream &stream)
  {
    stream.pass_record(ledger);
    stream.pass_record(first_);
  }
} // namespace vfife
