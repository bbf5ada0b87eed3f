// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/process/log.h>
#include <vfife/base/text/byte_stream.h>
#include <vfife/dynamics/watch/energy_book.h>
#include <vfife/model/model.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace vfife
{
  namespace
  {
    /** Part of the energy limit from which on there is a warning. */
    constexpr double warning_part = 0.4;

    /** sum m u- . u+/2 of the rigid motions u before and after an update, as the energy of the
     * whole motion is counted. With u+ . u+/2 a body whose rotation is accelerated had a share of
     * it in the motion relative to that. */
    double rigid_kinetic_energy(const UpdateAxis    &axis,
                                const RigidVelocity &before,
                                const UpdateSums    &sums)
    {
      if (axis.use_axis)
        return 0.5 * axis.direction.dot(before.omega) * sums.axial_momentum;
      return 0.5 * (before.velocity.dot(sums.momentum) + before.omega.dot(sums.angular_momentum));
    }
  } // namespace

  EnergyBook::EnergyBook(const Model &model)
    : approach_(model)
  {
    for (const Body &body : model.bodies)
      axes_.push_back(UpdateAxis::of(body));
  }

  void EnergyBook::set_axes(const std::vector<UpdateAxis> &axes)
  {
    axes_ = axes;
  }

  void EnergyBook::reset()
  {
    ledger_ = at_start_ = EnergyLedger();
    largest_approach_   = 0;
    has_touched_ = has_sample_ = has_warned_ = false;
    warning_watch_ = failure_watch_ = EnergyWatch();
  }

  void EnergyBook::set_round_off(const double of_step)
  {
    round_off_ = of_step;
  }

  double EnergyBook::round_off(const std::uint64_t n_steps) const
  {
    return round_off_ * static_cast<double>(n_steps + 1);
  }

  void EnergyBook::add_work(const StepPowers &powers, const double time)
  {
    // Called twice a step with half of it: the first and the last instant have a way on one side.
    ledger_.drive_work += time * powers.drive;
    ledger_.torque_work += time * powers.torque;
    ledger_.damping_loss += time * powers.damping;
    ledger_.mesh_damping_uptake += time * powers.mesh;
    ledger_.swing_loss += time * powers.swing;
    ledger_.contact_loss += time * powers.contact;
  }

  void EnergyBook::add_friction_loss(const double loss)
  {
    ledger_.contact_loss += loss;
    ledger_.friction_loss += loss;
  }

  void EnergyBook::observe_contact(const bool touching)
  {
    has_touched_ = has_touched_ || touching;
  }

  void EnergyBook::take_sample(const std::vector<RigidVelocity> &before,
                               const std::vector<BodySums>      &sums,
                               const double                      strain,
                               const double                      contact,
                               const std::uint64_t               n_steps)
  {
    // Energies now: T = sum m v- . v+/2, what it is beyond the bodies' rigid motion, and springs.
    ledger_.kinetic = 0;
    for (const BodySums &body : sums)
      ledger_.kinetic += body.update.kinetic;
    ledger_.kinetic_relative = ledger_.kinetic;
    for (std::size_t b = 0; b < axes_.size(); ++b)
      ledger_.kinetic_relative -= rigid_kinetic_energy(axes_[b], before[b], sums[b].update);
    ledger_.strain  = strain;
    ledger_.contact = contact;
    if (!std::exchange(has_sample_, true))
      {
        // The ledger begins with the first sample. In rigid flight or spin nothing is exchanged;
        // the floor keeps the round-off of the kinetic energy from being measured by itself.
        ledger_.start = ledger_.kinetic + ledger_.strain + ledger_.contact;
        ledger_.scale = EnergyLedger::scale_floor * ledger_.kinetic;
        at_start_     = ledger_;
      }

    // The scale: bodies that meet may exchange the energy of approach; before they do, it is
    // nobody's measure.
    observe_contact(contact > 0);
    largest_approach_ = std::max(largest_approach_, approach_.compute(sums));
    if (has_touched_)
      ledger_.scale = std::max(ledger_.scale, largest_approach_);
    // Where nothing moves there is round-off alone.
    ledger_.scale = std::max(ledger_.scale, round_off(n_steps));
    // Bodies spin up or fall while hardly anything is strained: their motion as a whole counts too.
    ledger_.scale = std::max(ledger_.scale, ledger_.exchanged_since(at_start_));
  }

  void EnergyBook::check(const double limit, const std::string &instant, Log &log)
  {
    // An error that is not finite fails at once, one beyond a limit when it has lasted and grows.
    const double error = ledger_.error(), residual = ledger_.residual();
    const auto   says = [&](const std::string &verb) {
      return "the energy error " + verb + " " + std::to_string(error) + " " + instant + " (limit " +
             std::to_string(limit) + ", Dynamics/energy limit)";
    };
    if (!std::isfinite(error))
      throw NumericalError(says("is"));
    if (warning_watch_.exceeds(error, residual, warning_part * limit) &&
        !std::exchange(has_warned_, true))
      log.warning(says("has reached"));
    if (failure_watch_.exceeds(error, residual, limit))
      throw NumericalError(says("is") + " and grows: the integration is unstable");
  }

  const EnergyLedger &EnergyBook::ledger() const
  {
    return ledger_;
  }

  void EnergyBook::serialize(ByteStream &stream)
  {
    stream.pass_record(ledger_);
    stream.pass_record(at_start_);
    stream.pass(largest_approach_, has_touched_, has_sample_, has_warned_);
    stream.pass(warning_watch_, failure_watch_);
  }
} // namespace vfife
