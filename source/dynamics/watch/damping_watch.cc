// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/text/byte_stream.h>
#include <vfife/dynamics/watch/damping_watch.h>
#include <vfife/model/model.h>

#include <algorithm>

namespace vfife
{
  DampingWatch::DampingWatch(const Model &model)
    : model_(model)
    , rates_at_start_(model.bodies.size())
    , sums_(model.bodies.size())
  {
  }

  void DampingWatch::reset(const std::vector<RigidVelocity> &rates)
  {
    rates_at_start_ = rates;
    sums_.assign(model_.bodies.size(), DampingAudit());
    n_steps_ = n_samples_ = 0;
  }

  void DampingWatch::observe_step(const std::vector<BodySums> &sums)
  {
    ++n_steps_;
    for (unsigned int b = 0; b < sums_.size(); ++b)
      {
        sums_[b].net_torque += sums[b].update.damping_torque;
        sums_[b].power += sums[b].update.damping_power;
      }
  }

  void DampingWatch::observe_sample(const std::vector<double>        &mean_speeds,
                                    const std::vector<RigidVelocity> &rates)
  {
    ++n_samples_;
    for (unsigned int b = 0; b < sums_.size(); ++b)
      {
        const Body &body = model_.bodies[b];
        if (!body.turns_on_axis)
          continue;
        // In the sense of the body's own rate, as the mean speed is unsigned.
        const double sense = body.rate < 0 ? -1. : 1.;
        sums_[b].rate_difference +=
          mean_speeds[b] - sense * body.axis.direction.dot(rates[b].omega);
      }
  }

  std::vector<DampingAudit>
  DampingWatch::compute_audit(const std::vector<RigidVelocity> &rates) const
  {
    // A run that fails in its first step has no step to divide by.
    std::vector<DampingAudit> audit = sums_;
    for (unsigned int b = 0; b < audit.size(); ++b)
      {
        audit[b].body = model_.bodies[b].name();
        audit[b].net_torque /= std::max(1U, n_steps_);
        audit[b].power /= std::max(1U, n_steps_);
        audit[b].rate_difference /= std::max(1U, n_samples_);
        audit[b].spin_drift =
          (rates[b].omega - rates_at_start_[b].omega).dot(model_.bodies[b].axis.direction);
      }
    return audit;
  }

  void DampingWatch::serialize(ByteStream &stream)
  {
    stream.pass(n_steps_, n_samples_);
    for (DampingAudit &sum : sums_)
      stream.pass(sum.net_torque, sum.power, sum.rate_difference);
    // The drift is that of the whole run, in however many parts it was made.
    for (RigidVelocity &rate : rates_at_start_)
      stream.pass(rate.velocity, rate.omega);
  }
} // namespace vfife
