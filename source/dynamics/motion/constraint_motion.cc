// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/process/communicator.h>
#include <vfife/base/text/byte_stream.h>
#include <vfife/dynamics/motion/constraint_motion.h>

#include <cmath>

namespace vfife
{
  ConstraintMotion::ConstraintMotion(const Model        &model,
                                     const Partition    &partition,
                                     const Communicator &communicator)
    : communicator_(communicator)
  {
    // Directions come last: a node that is held altogether needs no leads.
    for (const bool directions : {false, true})
      for (const Constraint &constraint : model.constraints)
        if ((constraint.kind == ConstraintKind::directions) == directions)
          add_constraint(constraint, model, partition);
    for (const Body &body : model.bodies)
      axes_.push_back(UpdateAxis::of(body));
  }

  void ConstraintMotion::add_constraint(const Constraint &constraint,
                                        const Model      &model,
                                        const Partition  &partition)
  {
    const bool                              led  = constraint.kind == ConstraintKind::directions;
    const Body                             &body = model.bodies[constraint.body];
    std::vector<std::pair<Group *, Node *>> taken(partition.n_local());
    for (Group &group : groups_)
      for (Node &node : group.nodes)
        taken[node.local] = {&group, &node};

    Group group{&constraint, constraint.kind, constraint.body, body.axis, body.rate, {}};
    for (const unsigned int i : constraint.nodes)
      {
        const std::uint32_t local = partition.local_node[body.first_node + i];
        if (local == Partition::absent)
          continue;
        const double  mass  = body.node_masses()[i];
        const Vector3 start = body.placement(body.node_positions()[i]) - body.axis.point;
        Node          node{local, partition.owned[local] != 0, mass, mass, start};
        for (unsigned int c = 0; c < 3; ++c)
          node.leads[c] = led && constraint.prescribed[c] ? &constraint : nullptr;
        const auto [known_group, known] = taken[local];
        if (known == nullptr)
          {
            group.nodes.push_back(node);
            continue;
          }

        const Constraint *const first = known_group->definition;
        if (led && first->kind == ConstraintKind::held && constraint.displacement.isZero(0.))
          continue;
        bool can_join = led && first->kind == ConstraintKind::directions &&
                        first->cylindrical == constraint.cylindrical;
        for (unsigned int c = 0; c < 3; ++c)
          {
            can_join = can_join && !(node.leads[c] && known->leads[c]);
            if (can_join && node.leads[c])
              known->leads[c] = node.leads[c];
          }
        if (!can_join)
          throw InputError("node " + std::to_string(i) + " of body \"" + body.name() +
                           "\" is in two constraints, \"" + first->name + "\" and \"" +
                           constraint.name + "\", that do not go together");
      }
    groups_.push_back(std::move(group));
  }

  void ConstraintMotion::set_part(const double part)
  {
    part_ = part;
  }

  double ConstraintMotion::factor(const Constraint &constraint,
                                  const double      time,
                                  const MotionFrame frame) const
  {
    if (frame == MotionFrame::fixed)
      return constraint.history.value(time);
    return part_ ? *part_ : constraint.history.value(0.);
  }

  double ConstraintMotion::turned_angle(const Group      &group,
                                        const double      time,
                                        const MotionFrame frame) const
  {
    if (group.kind != ConstraintKind::prescribed_rotation)
      return 0.;
    if (group.definition->angle)
      return *group.definition->angle * factor(*group.definition, time, frame);
    return frame == MotionFrame::fixed ? group.rate * time : 0.;
  }

  Vector3 ConstraintMotion::move_led(const Group       &group,
                                     Node              &node,
                                     const double       time,
                                     const double       dt,
                                     const MotionFrame  frame,
                                     const BodyDamping &damping,
                                     const Vector3     &force) const
  {
    const double half  = 0.5 * damping.zeta * dt;
    node.free_velocity = ((1. - half) * node.old_velocity +
                          dt * (force / node.moved_mass - damping.mesh.at(node.old_position)) +
                          2. * half * damping.rigid.at(node.old_position)) /
                         (1. + half);
    const Vector3   free = node.old_position + dt * node.free_velocity;
    LedDisplacement led;
    for (unsigned int c = 0; c < 3; ++c)
      if (node.leads[c])
        led[c] = node.leads[c]->displacement[c] * factor(*node.leads[c], time + dt, frame);
    const Vector3 start = group.axis.point + node.start;
    return group.definition->cylindrical
             ? place_led(group.axis, start, node.old_position, free, led)
             : place_led(start, free, led);
  }

  void ConstraintMotion::set_masses(const std::vector<double> &masses)
  {
    for (Group &group : groups_)
      for (Node &node : group.nodes)
        node.moved_mass = masses[node.local];
  }

  void ConstraintMotion::clear_masses(State &state) const
  {
    for (const Group &group : groups_)
      for (const Node &node : group.nodes)
        {
          state.position.set_number(node.local, 0.);
          state.velocity.set_number(node.local, 0.);
        }
  }

  void ConstraintMotion::read(const State &state, const MotionFrame frame)
  {
    for (Group &group : groups_)
      if (group.turns_freely())
        for (Node &node : group.nodes)
          {
            const Vector3 r       = state.node_position(node.local) - group.axis.point;
            const Vector3 a       = group.axis.direction;
            const Vector3 start_r = node.start - a.dot(node.start) * a;
            node.angle            = std::atan2(a.dot(start_r.cross(r)), start_r.dot(r));
            node.rate             = 0;
            if (frame == MotionFrame::fixed)
              {
                // The velocity is the chord of the last step: 2 rho sin(rate dt/2)/dt.
                const Vector3 v      = state.node_velocity(node.local);
                const double  rho    = start_r.norm();
                const Vector3 middle = r - 0.5 * state.dt * v;
                const double  sense  = a.dot(middle.cross(v)) < 0 ? -1. : 1.;
                node.rate =
                  sense * 2. / state.dt * std::asin(std::min(1., v.norm() * state.dt / (2. * rho)));
              }
          }
    for (Group &group : groups_)
      if (group.kind == ConstraintKind::rigid_hub)
        share_rotation(group);
  }

  void ConstraintMotion::turn_bodies(const Model &model, State &state) const
  {
    std::vector<double> sums(2 * model.bodies.size(), 0.);
    for (const Group &group : groups_)
      if (group.turns_freely())
        for (const Node &node : group.nodes)
          if (node.owned)
            {
              sums[2 * group.body] += node.angle;
              sums[2 * group.body + 1] += 1.;
            }
    communicator_.sum(sums);
    for (unsigned int b = 0; b < model.bodies.size(); ++b)
      if (sums[2 * b + 1] > 0)
        {
          const Body   &body = model.bodies[b];
          const Matrix3 rotation =
            rotation_about(body.axis.direction, sums[2 * b] / sums[2 * b + 1]);
          const Vector3 arm                = body.placement.translation - body.axis.point;
          state.body_motion[b].rotation    = rotation * body.placement.rotation;
          state.body_motion[b].translation = body.axis.point + rotation * arm;
        }
  }

  void ConstraintMotion::share_rotation(Group &group) const
  {
    // Round-off of the chords would make the nodes of a rigid hub drift apart over many steps.
    std::vector<double> sums(3, 0.);
    for (const Node &node : group.nodes)
      if (node.owned)
        {
          sums[0] += node.angle;
          sums[1] += node.rate;
          sums[2] += 1.;
        }
    communicator_.sum(sums);
    for (Node &node : group.nodes)
      {
        node.angle = sums[0] / sums[2];
        node.rate  = sums[1] / sums[2];
      }
  }

  void ConstraintMotion::save(const NodeField &positions, const NodeField &velocities)
  {
    for (Group &group : groups_)
      for (Node &node : group.nodes)
        {
          node.old_position = positions.value(node.local);
          node.old_velocity = velocities.value(node.local);
        }
  }

  Vector3 ConstraintMotion::turned(const Axis &axis, const Vector3 &start, const double angle)
  {
    const Vector3 &a = axis.direction;
    return axis.point + std::cos(angle) * start + std::sin(angle) * a.cross(start) +
           (1. - std::cos(angle)) * a.dot(start) * a;
  }

  void ConstraintMotion::turn_freely(Group             &group,
                                     const double       dt,
                                     const BodyDamping &damping,
                                     const NodeField   &forces) const
  {
    const Vector3 &a          = group.axis.direction;
    const double   half       = 0.5 * damping.zeta * dt;
    const double   rigid_rate = a.dot(damping.rigid.omega), slip = a.dot(damping.mesh.omega);
    const auto     accelerate = [&](double &rate, const double acceleration) {
      rate =
        ((1. - half) * rate + dt * (acceleration - slip) + 2. * half * rigid_rate) / (1. + half);
    };

    if (group.kind == ConstraintKind::free_rotation)
      {
        for (Node &node : group.nodes)
          {
            const Vector3 e = a.cross(node.old_position - group.axis.point);
            accelerate(node.rate,
                       e.dot(forces.value(node.local)) / (node.moved_mass * e.squaredNorm()));
          }
        return;
      }

    std::vector<double> torque_and_inertia(2, 0.);
    for (const Node &node : group.nodes)
      if (node.owned)
        {
          const Vector3 e = a.cross(node.old_position - group.axis.point);
          torque_and_inertia[0] += e.dot(forces.value(node.local));
          torque_and_inertia[1] += node.moved_mass * e.squaredNorm();
        }
    communicator_.sum(torque_and_inertia);
    for (Node &node : group.nodes)
      accelerate(node.rate, torque_and_inertia[0] / torque_and_inertia[1]);
  }

  void ConstraintMotion::apply(const double                    time,
                               const double                    dt,
                               const MotionFrame               frame,
                               const std::vector<BodyDamping> &damping,
                               const NodeField                &forces,
                               NodeField                      &positions,
                               NodeField                      &velocities,
                               std::vector<BodySums>          &sums)
  {
    for (Group &group : groups_)
      {
        if (group.turns_freely())
          turn_freely(group, dt, damping[group.body], forces);
        const Matrix3 rotation =
          rotation_about(group.axis.direction, turned_angle(group, time + dt, frame));
        for (Node &node : group.nodes)
          {
            Vector3 x;
            if (group.turns_freely())
              {
                node.angle += dt * node.rate;
                x = turned(group.axis, node.start, node.angle);
              }
            else if (group.kind == ConstraintKind::directions)
              x = move_led(
                group, node, time, dt, frame, damping[group.body], forces.value(node.local));
            else
              x = group.axis.point + rotation * node.start;
            const Vector3 v = (x - node.old_position) / dt;
            positions.set(node.local, x);
            velocities.set(node.local, v);
            add_sums(group,
                     node,
                     dt,
                     damping[group.body],
                     forces.value(node.local),
                     x,
                     v,
                     axes_[group.body],
                     sums[group.body]);
          }
      }
  }

  void ConstraintMotion::project(const NodeField &positions,
                                 NodeField       &forces,
                                 const bool       rotation_is_free) const
  {
    const auto lever = [&](const Group &group, const Node &node) {
      return Vector3(group.axis.direction.cross(positions.value(node.local) - group.axis.point));
    };
    for (const Group &group : groups_)
      {
        // A rigid hub is in equilibrium when its nodes' torques add up to zero: each keeps its part
        // of the sum, all in one direction of motion.
        double per_lever = 0;
        if (group.kind == ConstraintKind::rigid_hub)
          {
            std::vector<double> sums(2, 0.);
            for (const Node &node : group.nodes)
              if (node.owned)
                {
                  sums[0] += lever(group, node).dot(forces.value(node.local));
                  sums[1] += lever(group, node).squaredNorm();
                }
            communicator_.sum(sums);
            per_lever = sums[0] / sums[1];
          }
        for (const Node &node : group.nodes)
          {
            Vector3 f = Vector3::Zero();
            if (rotation_is_free && group.kind == ConstraintKind::rigid_hub)
              f = per_lever * lever(group, node);
            else if (rotation_is_free && group.kind == ConstraintKind::free_rotation)
              {
                const Vector3 t = lever(group, node).normalized();
                f               = t.dot(forces.value(node.local)) * t;
              }
            else if (group.kind == ConstraintKind::directions)
              f = project_free(
                group.axis,
                group.definition->cylindrical,
                positions.value(node.local),
                {{node.leads[0] != nullptr, node.leads[1] != nullptr, node.leads[2] != nullptr}},
                forces.value(node.local));
            forces.set(node.local, f);
          }
      }
  }
} // namespace vfife
