// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/text/byte_stream.h>
#include <vfife/model/energy_ledger.h>
#include <vfife/model/model.h>
#include <vfife/model/pair_measures.h>
#include <vfife/reduced/pair/pair_drive.h>

#include <cmath>
#include <sstream>

namespace vfife
{
  namespace
  {
    /** Part of a tooth by which bodies may turn against each other in a step. */
    constexpr double largest_turn = .1;
  } // namespace

  PairDrive::PairDrive(const Model &model, const double length)
    : step(length)
    , driver_rate(model.only_transmission()->driver_rate)
    , load(torque_on(model, model.only_transmission()->driven, 0.))
    , model_(model)
    , transmission_(*model.only_transmission())
  {
  }

  double PairDrive::rate_factor() const
  {
    return driver_rate / transmission_.driver_rate * transmission_.rate_history.value(time);
  }

  double PairDrive::turn_after(const double more) const
  {
    return transmission_.has_constant_rate() ? turn + driver_rate * (more * step)
                                             : transmission_.driver_turn(time + more * step);
  }

  double PairDrive::driven_turn() const
  {
    return transmission_.ratio() * turn;
  }

  std::vector<AxialLoad> PairDrive::advance(PairMembers &members, EnergyLedger &energy)
  {
    turn = turn_after(1.);
    ++n_steps;
    time += step;
    std::vector<AxialLoad> mean;
    for (unsigned int b = 0; b < members.size(); ++b)
      {
        PairMember  &member = *members[b];
        const double before = member.rate, torque = member.axial.torque;
        member.axial.torque = torque_on(model_, b, time);
        if (!transmission_.has_constant_rate())
          {
            member.set_rate(rate_factor() * model_.bodies[b].rate);
            member.axial.acceleration = (member.rate - before) / step;
            member.follow_rate(step);
          }
        if (b == transmission_.driver)
          energy.drive_work += .5 * member.inertia * (member.rate * member.rate - before * before);
        mean.push_back({.5 * (torque + member.axial.torque), member.axial.acceleration});
      }
    load = members[transmission_.driven]->axial.torque;
    return mean;
  }

  void PairDrive::check_turn(const double turned) const
  {
    if (std::abs(turned) * transmission_.driven_teeth < largest_turn * 2. * pi)
      return;
    std::ostringstream text;
    text << "at step " << n_steps << " (" << 1e3 * time << " ms) the driven body rotated by "
         << turned * 180. / pi << " degrees beyond the driver in one step of " << 1e6 * step
         << " us, so that flanks pass through each other. Increase Reduced/steps per mesh cycle";
    throw NumericalError(text.str());
  }

  void PairDrive::serialize(ByteStream &stream)
  {
    stream.pass(time, n_steps, turn, driver_rate, load);
  }
} // namespace vfife
