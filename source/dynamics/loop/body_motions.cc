// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/process/communicator.h>
#include <vfife/base/text/byte_stream.h>
#include <vfife/dynamics/loop/body_motions.h>
#include <vfife/dynamics/motion/mean_speed.h>
#include <vfife/model/model.h>
#include <vfife/model/state.h>

#include <algorithm>

namespace vfife
{
  BodyMotions::BodyMotions(const Model               &model,
                           const DynamicsOptions     &options,
                           const std::vector<double> &masses,
                           const Communicator        &communicator)
    : model_(model)
    , options_(options)
    , masses_(masses)
    , communicator_(communicator)
    , rates_(model.bodies.size())
    , damping_(model.bodies.size())
    , sums_(model.bodies.size())
  {
    for (unsigned int b = 0; b < model.bodies.size(); ++b)
      references_.emplace_back(model, b);
  }

  std::vector<UpdateAxis> BodyMotions::axes() const
  {
    std::vector<UpdateAxis> axes;
    for (const DampingReference &reference : references_)
      axes.push_back(reference.axis());
    return axes;
  }

  void BodyMotions::begin(const State &state)
  {
    for (unsigned int b = 0; b < model_.bodies.size(); ++b)
      {
        const UpdateAxis &line = axis(b);
        BodySums          sums;
        for (const std::uint32_t i : state.partition->owned_nodes(b))
          add_node_moments(
            line, masses_[i], state.node_position(i), state.node_velocity(i), sums.update);
        sum_over_ranks(sums, communicator_);
        rates_[b] = compute_momentum_rate(line, model_.bodies[b].mass(), sums.update);
      }
    take_places(state);
  }

  void BodyMotions::take_places(const State &state)
  {
    for (DampingReference &reference : references_)
      reference.take_place(state, masses_, communicator_);
  }

  std::vector<double> BodyMotions::axial_rates() const
  {
    std::vector<double> rates;
    for (unsigned int b = 0; b < model_.bodies.size(); ++b)
      rates.push_back(model_.bodies[b].axis.direction.dot(rates_[b].omega));
    return rates;
  }

  void BodyMotions::set_damping(const State &state, const double dt)
  {
    for (unsigned int b = 0; b < model_.bodies.size(); ++b)
      {
        // -zeta m (v - u): u is the rigid motion that supports leave to the body, about its axis at
        // the rate of its momentum or of its mean speed.
        const Body &body  = model_.bodies[b];
        damping_[b].zeta  = options_.mass_damping();
        damping_[b].rigid = rates_[b];
        if (damping_[b].zeta > 0)
          damping_[b].rigid = references_[b].find(state.time, dt, state.body_motion[b], rates_[b]);
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
            const double rate = body.axis.direction.dot(rates_[b].omega) -
                                t.driven_sense * t.driven_rate(state.time - 0.5 * dt);
            damping_[b].mesh.omega    = options_.mesh_damping * rate * body.axis.direction;
            damping_[b].mesh.velocity = -damping_[b].mesh.omega.cross(body.axis.point);
          }
      }
  }

  void BodyMotions::add_powers(StepWork &work) const
  {
    for (StepPowers *powers : {&work.before, &work.after})
      for (const BodySums &sums : sums_)
        {
          powers->damping += sums.update.damping_power;
          powers->mesh += sums.update.mesh_power;
        }
    for (const BodySums &sums : sums_)
      {
        work.before.drive += sums.drive_power_before;
        work.after.drive += sums.drive_power_after;
      }
    if (!model_.transmissions.empty())
      work.before.swing = work.after.swing = find_swing_power(work.after.mesh);
  }

  double BodyMotions::find_swing_power(const double mesh_power) const
  {
    // The driven speed damping's torque takes from the swing what its power takes beyond that of
    // the kinematic rotation: sum m slip . (v - omega_kinematic axis x r).
    double     swing      = mesh_power;
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
        swing -= torque * t.driven_sense * t.driven_rate();
      }
    return swing;
  }

  void BodyMotions::advance(const double dt, State &state)
  {
    for (unsigned int b = 0; b < model_.bodies.size(); ++b)
      {
        const Body &body = model_.bodies[b];
        rates_[b] = compute_momentum_rate(references_[b].axis(), body.mass(), sums_[b].update);

        // y -> pivot + step (y + drift - pivot): turned about the axis, or, of a body that flies,
        // moved along and turned about where its centre of mass is at the end of the step
        RigidMotion  &motion = state.body_motion[b];
        const Vector3 turn   = dt * rates_[b].omega;
        const double  angle  = turn.norm();
        const Matrix3 step =
          angle > 0 ? rotation_about(turn / angle, angle) : Matrix3(Matrix3::Identity());
        const bool    on_axis = references_[b].axis().use_axis;
        const Vector3 pivot =
          on_axis ? body.axis.point : Vector3(sums_[b].update.first_moment / body.mass());
        const Vector3 drift =
          on_axis ? Vector3(Vector3::Zero()) : Vector3(dt * rates_[b].at(pivot));
        motion.rotation    = step * motion.rotation;
        motion.translation = pivot + step * (motion.translation + drift - pivot);
      }
  }

  void BodyMotions::serialize_rates(ByteStream &stream)
  {
    for (RigidVelocity &rate : rates_)
      stream.pass(rate.velocity, rate.omega);
  }

  void BodyMotions::serialize_places(ByteStream &stream)
  {
    for (DampingReference &reference : references_)
      reference.serialize(stream);
  }
} // namespace vfife
