// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// What the dampers of ExplicitSolver are relative to, and what they and drives do in a step.
#include <vfife/dynamics/loop/explicit_solver.h>
#include <vfife/dynamics/motion/mean_speed.h>

#include <algorithm>
#include <tuple>

namespace vfife
{
  void ExplicitSolver::set_damping(const State &state)
  {
    for (unsigned int b = 0; b < model_.bodies.size(); ++b)
      {
        // -zeta m (v - u): u is the rigid motion that supports leave to the body, about its axis at
        // the rate of its momentum or of its mean speed.
        const Body &body  = model_.bodies[b];
        damping_[b].zeta  = options_.mass_damping();
        damping_[b].rigid = rigid_[b];
        if (damping_[b].zeta > 0)
          damping_[b].rigid = references_[b].find(state.time, dt_, state.body_motion[b], rigid_[b]);
        if (damping_[b].zeta > 0 && options_.damping_rate == DampingRate::mean_speed &&
            UpdateAxis::of(body).use_axis && references_[b].turns())
          {
            // A body that nothing holds across its axis turns about its centre.
            RigidVelocity &u      = damping_[b].rigid;
            const Vector3 &axis   = body.axis.direction;
            const Vector3  point  = references_[b].axis().use_axis
                                      ? body.axis.point
                                      : Vector3(sums_[b].update.first_moment / body.mass());
            const Vector3  change = compute_mean_speed_rate(body, state, b, communicator_).omega -
                                   axis.dot(u.omega) * axis;
            u.omega += change;
            u.velocity -= change.cross(point);
          }

        // slip = zeta_k (omega - omega_kinematic) axis x r on the driven body of a gear pair
        damping_[b].mesh = RigidVelocity();
        for (const Transmission &t : model_.transmissions)
          {
            if (t.driven != b)
              continue;
            // The momentum's rate is that of v-, half a step before the state.
            const double rate = body.axis.direction.dot(rigid_[b].omega) -
                                t.driven_sense * t.driven_rate(state.time - 0.5 * dt_);
            damping_[b].mesh.omega    = options_.mesh_damping * rate * body.axis.direction;
            damping_[b].mesh.velocity = -damping_[b].mesh.omega.cross(body.axis.point);
          }
      }
  }

  void ExplicitSolver::add_powers(const double time, StepWork &work) const
  {
    // What drives give through the bearings' dampers and these do not give to the bodies is lost.
    // A drive has no way before time zero.
    const double first = time < dt_ ? time : time - dt_;
    const double last  = time < dt_ ? time + dt_ : time;
    for (const auto &[powers, from, to] :
         {std::tuple<StepPowers *, double, double>(&work.before, first, last),
          std::tuple<StepPowers *, double, double>(&work.after, time, time + dt_)})
      {
        powers->drive   = bearings_.drive_power(from, to);
        powers->contact = contact_.lost_power() + walls_.lost_power();
        powers->damping += bearings_.damper_drive_power(from, to);
        for (const BodySums &sums : sums_)
          {
            powers->damping += sums.update.damping_power;
            powers->mesh += sums.update.mesh_power;
          }
      }
    for (const BodySums &sums : sums_)
      {
        work.before.drive += sums.drive_power_before;
        work.after.drive += sums.drive_power_after;
      }
    if (model_.transmissions.empty())
      return;
    // The driven speed damping's torque takes from the swing what its power takes beyond that of
    // the kinematic rotation: sum m slip . (v - omega_kinematic axis x r).
    work.after.swing      = work.after.mesh;
    const auto first_pair = model_.transmissions.begin();
    for (auto pair = first_pair; pair != model_.transmissions.end(); ++pair)
      {
        const Transmission &t = *pair;
        // Several drivers may share a driven member, whose dampers count once.
        if (std::any_of(first_pair, pair, [&t](const auto &one) { return one.driven == t.driven; }))
          continue;
        const Body  &body = model_.bodies[t.driven];
        const double torque =
          body.axis.direction.dot(damping_[t.driven].mesh.omega) *
          compute_axial_inertia(references_[t.driven].axis(), body.mass(), sums_[t.driven].update);
        work.after.swing -= torque * t.driven_sense * t.driven_rate();
      }
    work.before.swing = work.after.swing;
  }
} // namespace vfife
