// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/process/communicator.h>
#include <vfife/dynamics/motion/constraint_motion.h>

#include <cmath>

namespace vfife
{
  ConstraintMotion::ConstraintMotion(const Model        &model,
                                     const Partition    &partition,
                                     const Communicator &communicator)
    : communicator_(communicator)
  {
    // Directions come last: a node that is held altogether needs no more.
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
    // 1. What earlier constraints have taken: a node is in one group only.
    const bool  prescribed = constraint.kind == ConstraintKind::directions;
    const Body &body       = model.bodies[constraint.body];
    std::vector<std::pair<Group *, Node *>> taken(partition.n_local());
    for (Group &group : groups_)
      for (Node &node : group.nodes)
        taken[node.local] = {&group, &node};

    // 2. The nodes that this rank holds; those that are new join the group of this constraint.
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
          node.prescribing[c] = prescribed && constraint.prescribed[c] ? &constraint : nullptr;
        const auto [known_group, known] = taken[local];
        if (known == nullptr)
          {
            group.nodes.push_back(node);
            continue;
          }

        // 3. A node that is known stays where it is. Held altogether it needs no more; directions
        // with the same axes join where they prescribe different ones.
        const Constraint *const first = known_group->definition;
        if (prescribed && first->kind == ConstraintKind::held && constraint.displacement.isZero(0.))
          continue;
        bool can_join = prescribed && first->kind == ConstraintKind::directions &&
                        first->cylindrical == constraint.cylindrical;
        for (unsigned int c = 0; c < 3; ++c)
          {
            can_join = can_join && !(node.prescribing[c] && known->prescribing[c]);
            if (can_join && node.prescribing[c])
              known->prescribing[c] = node.prescribing[c];
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
    // The time of a relaxation is none: a part of the loads, or what their histories begin with.
    return part_ ? *part_ : constraint.history.value(0.);
  }

  double ConstraintMotion::turned_angle(const Group      &group,
                                        const double      time,
                                        const MotionFrame frame) const
  {
    if (group.kind != ConstraintKind::prescribed_rotation)
      return 0.;
    // An angle with a history turns in both frames; the body's own rate is what one of them turns
    // with.
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
    // First the motion that forces and damping alone would give, as update_nodes() has it,
    //   v* = ((1 - a) v- + dt (f/m - slip) + 2 a u)/(1 + a),  a = zeta dt/2,  x* = x + dt v*
    const double half  = 0.5 * damping.zeta * dt;
    node.free_velocity = ((1. - half) * node.old_velocity +
                          dt * (force / node.moved_mass - damping.mesh.at(node.old_position)) +
                          2. * half * damping.rigid.at(node.old_position)) /
                         (1. + half);
    const Vector3 free = node.old_position + dt * node.free_velocity;
    // ... then x* goes where prescribed displacements want it at the end of the step.
    PrescribedDisplacement prescribed;
    for (unsigned int c = 0; c < 3; ++c)
      if (node.prescribing[c])
        prescribed[c] =
          node.prescribing[c]->displacement[c] * factor(*node.prescribing[c], time + dt, frame);
    const Vector3 start = group.axis.point + node.start;
    return group.definition->cylindrical
             ? place_prescribed(group.axis, start, node.old_position, free, prescribed)
             : place_prescribed(start, free, prescribed);
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
          // The fourth numbers of the records are 1/m (positions) and m (velocities): at zero the
          // common update adds neither force nor sums.
          state.position.set_number(node.local, 0.);
          state.velocity.set_number(node.local, 0.);
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
        // 1. New angular velocities of free rotations, and the angle of a prescribed one.
        if (group.turns_freely())
          turn_freely(group, dt, damping[group.body], forces);
        const Matrix3 rotation =
          rotation_about(group.axis.direction, turned_angle(group, time + dt, frame));
        for (Node &node : group.nodes)
          {
            // 2. The new place by the kind of the group; the velocity is the chord.
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
            // 3. What the common update, which sees no mass here, has left out of the sums.
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
    // The velocity of a node per angular velocity about the axis, e = axis x r [mm].
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
        // What is left of the force along the directions in which the node may move.
        for (const Node &node : group.nodes)
          {
            // held, prescribed: 0; free rotation: (t . f) t; rigid hub: e_i (sum e . f)/(sum e . e)
            Vector3 f = Vector3::Zero();
            if (rotation_is_free && group.kind == ConstraintKind::rigid_hub)
              f = per_lever * lever(group, node);
            else if (rotation_is_free && group.kind == ConstraintKind::free_rotation)
              {
                const Vector3 t = lever(group, node).normalized();
                f               = t.dot(forces.value(node.local)) * t;
              }
            else if (group.kind == ConstraintKind::directions)
              f = project_free(group.axis,
                               group.definition->cylindrical,
                               positions.value(node.local),
                               {{node.prescribing[0] != nullptr,
                                 node.prescribing[1] != nullptr,
                                 node.prescribing[2] != nullptr}},
                               forces.value(node.local));
            forces.set(node.local, f);
          }
      }
  }
} // namespace vfife
