// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/process/communicator.h>
#include <vfife/dynamics/motion/constraint_motion.h>
#include <vfife/dynamics/motion/free_rotation.h>

#include <cmath>
#include <limits>

namespace vfife
{
  ConstraintMotion::ConstraintMotion(const Model        &model,
                                     const Partition    &partition,
                                     const Communicator &communicator)
    : communicator_(communicator)
    , model_(model)
  {
    for (const Constraint &constraint : model.constraints)
      {
        const Body &body = model.bodies[constraint.body];
        groups_.push_back({&constraint, constraint.kind, constraint.body, body.axis, {}});
      }
    for (unsigned int b = 0; b < model.bodies.size(); ++b)
      {
        add_nodes(b, partition);
        axes_.push_back(UpdateAxis::of(model.bodies[b]));
      }
    compare_first_values();
  }

  void ConstraintMotion::compare_first_values() const
  {
    // What contradicts itself in full, as a static solution reads values, and at time zero, as a
    // run does, is refused before anything is computed.
    for (const NodeConstraints &constraints : compared_)
      try
        {
          constraints.compute_displacement([](const Constraint &) { return 1.; });
        }
      catch (const InputError &)
        {
          constraints.compute_displacement(
            [](const Constraint &one) { return one.history.value(0.); });
        }
  }

  void ConstraintMotion::add_nodes(const unsigned int b, const Partition &partition)
  {
    const Body &body = model_.bodies[b];
    for (auto &[i, constraints] : combine_constraints(model_, b))
      {
        // All ranks compare the values of all nodes: what is wrong is found by all of them.
        if (constraints.has_values_to_compare())
          compared_.push_back(constraints);
        const std::uint32_t local = partition.local_node[body.first_node + i];
        if (local == Partition::absent)
          continue;
        Node node                 = {};
        node.local                = local;
        node.owned                = partition.owned[local] != 0;
        node.mass                 = body.node_masses()[i];
        node.moved_mass           = node.mass;
        node.start                = body.placement(body.node_positions()[i]) - body.axis.point;
        const Constraint &leading = constraints.leading();
        if (constraints.constraints().size() > 1)
          {
            node.shared = static_cast<int>(shared_.size());
            shared_.push_back(constraints);
          }
        if (leading.kind == ConstraintKind::directions)
          node.held = constraints.independent();
        groups_[&leading - model_.constraints.data()].nodes.push_back(std::move(node));
      }
  }

  void ConstraintMotion::read(const State &state, const MotionFrame frame)
  {
    for (Group &group : groups_)
      if (group.turns_freely())
        read_rotation(group, state, frame == MotionFrame::fixed, communicator_);
  }

  void ConstraintMotion::turn_bodies(const Model &model, State &state) const
  {
    // Body by body what an angle's tangent is the ratio of: of a hub the sum of its free nodes'
    // angles (small) over their number, of a shaft in bearings a . (r0 x r) over r0 . r of all
    // nodes, across the axis.
    std::vector<double> sums(2 * model.bodies.size(), 0.);
    for (const Group &group : groups_)
      if (group.turns_freely() && !model.bodies[group.body].floats)
        for (const Node &node : group.nodes)
          if (node.owned && group.has_angle(node))
            {
              sums[2 * group.body] += node.angle;
              sums[2 * group.body + 1] += 1.;
            }
    for (unsigned int b = 0; b < model.bodies.size(); ++b)
      if (model.bodies[b].floats)
        for (const std::uint32_t i : state.partition->owned_nodes(b))
          {
            const Body        &body = model.bodies[b];
            const unsigned int node = state.partition->global_node[i] - body.first_node;
            const Vector3     &a    = body.axis.direction;
            const Vector3      r0   = body.placement(body.node_positions()[node]) - body.axis.point,
                          r         = state.node_position(i) - body.axis.point;
            sums[2 * b] += a.dot(r0.cross(r));
            sums[2 * b + 1] += r0.dot(r) - a.dot(r0) * a.dot(r);
          }
    communicator_.sum(sums);
    // The placement at time zero, turned about the axis by that angle.
    for (unsigned int b = 0; b < model.bodies.size(); ++b)
      if (sums[2 * b + 1] != 0)
        {
          const Body  &body = model.bodies[b];
          const double angle =
            body.floats ? std::atan2(sums[2 * b], sums[2 * b + 1]) : sums[2 * b] / sums[2 * b + 1];
          const Matrix3 rotation           = rotation_about(body.axis.direction, angle);
          const Vector3 arm                = body.placement.translation - body.axis.point;
          state.body_motion[b].rotation    = rotation * body.placement.rotation;
          state.body_motion[b].translation = body.axis.point + rotation * arm;
        }
  }

  void ConstraintMotion::serialize(ByteStream &stream, const Partition &partition)
  {
    for (Group &group : groups_)
      if (group.turns_freely())
        serialize_rotation(group, stream, partition, communicator_);
  }

  void ConstraintMotion::set_part(const double part)
  {
    part_ = part;
  }

  double ConstraintMotion::factor(const Constraint &constraint) const
  {
    return factors_[&constraint - model_.constraints.data()];
  }

  void ConstraintMotion::update_factors(const double time, const MotionFrame frame)
  {
    // The time of a relaxation is none: a part of the loads, or what their histories begin with.
    factors_.clear();
    for (const Constraint &constraint : model_.constraints)
      factors_.push_back(frame == MotionFrame::fixed ? constraint.history.value(time)
                         : part_                     ? *part_
                                                     : constraint.history.value(0.));
    for (const NodeConstraints &constraints : compared_)
      constraints.compute_displacement([this](const Constraint &one) { return factor(one); });
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
      return *group.definition->angle * factor(*group.definition);
    return frame == MotionFrame::fixed ? model_.bodies[group.body].driven_turn(time) : 0.;
  }

  Vector3 ConstraintMotion::move_led(const Group       &group,
                                     Node              &node,
                                     const double       dt,
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
    std::array<double, 3> values = {};
    for (std::size_t k = 0; k < node.held.size(); ++k)
      values[k] = node.held[k].value * factor(*node.held[k].constraint);
    return place_prescribed(
      group.axis, group.axis.point + node.start, node.old_position, free, node.held, values);
  }

  void ConstraintMotion::set_masses(const std::vector<double> &masses)
  {
    for (Group &group : groups_)
      for (Node &node : group.nodes)
        node.moved_mass = masses[node.local];
  }

  void ConstraintMotion::set_axes(const std::vector<UpdateAxis> &axes)
  {
    axes_ = axes;
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
    update_factors(time + dt, frame);
    for (Group &group : groups_)
      {
        // 1. New angular velocities of free rotations, and the angle of a prescribed one.
        if (group.turns_freely())
          accelerate_rotation(group, dt, damping[group.body], forces, communicator_);
        const Matrix3 rotation =
          rotation_about(group.axis.direction, turned_angle(group, time + dt, frame));
        for (Node &node : group.nodes)
          {
            // 2. The new place by the kind of the group; the velocity is the chord, which in a
            // relaxation keeps digits that places have not.
            Vector3 x;
            if (group.turns_freely())
              x = turn_on(group.axis, node, dt);
            else if (group.kind == ConstraintKind::directions)
              x = move_led(group, node, dt, damping[group.body], forces.value(node.local));
            else
              x = group.axis.point + rotation * node.start;
            Vector3 v = (x - node.old_position) / dt;
            if (frame == MotionFrame::rotating)
              v = find_way(group, node, dt, v);
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

  Vector3 ConstraintMotion::find_way(const Group   &group,
                                     const Node    &node,
                                     const double   dt,
                                     const Vector3 &chord) const
  {
    // What the node has gone where it is free, without the difference of two places.
    Vector3 v = chord;
    if (group.turns_freely())
      v = find_chord_velocity(group.axis, node, dt);
    else if (group.kind == ConstraintKind::directions)
      v += project_free(group.axis, node.old_position, node.held, node.free_velocity - chord);
    // More than round-off is a turn that place_prescribed() has made beside it.
    const double size = 2. * node.old_position.norm() + node.start.norm();
    return (v - chord).norm() * dt <= 64. * std::numeric_limits<double>::epsilon() * size ? v
                                                                                          : chord;
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
              if (node.owned && group.has_angle(node))
                {
                  sums[0] += lever(group, node).dot(forces.value(node.local));
                  sums[1] += lever(group, node).squaredNorm();
                }
            communicator_.sum(sums);
            if (sums[1] > 0)
              per_lever = sums[0] / sums[1];
          }
        // What is left of the force along the directions in which the node may move.
        for (const Node &node : group.nodes)
          {
            // held, prescribed: 0; free rotation: (t . f) t; rigid hub: e_i (sum e . f)/(sum e . e)
            Vector3 f = Vector3::Zero();
            if (rotation_is_free && group.kind == ConstraintKind::rigid_hub)
              f = per_lever * lever(group, node);
            else if (rotation_is_free && group.turns_freely() && group.has_angle(node))
              {
                const Vector3 t = lever(group, node).normalized();
                f               = t.dot(forces.value(node.local)) * t;
              }
            else if (group.kind == ConstraintKind::directions)
              f = project_free(group.axis,
                               positions.value(node.local),
                               node.held,
                               forces.value(node.local));
            forces.set(node.local, f);
          }
      }
  }

  void ConstraintMotion::add_sums(const Group       &group,
                                  const Node        &node,
                                  const double       dt,
                                  const BodyDamping &damping,
                                  const Vector3     &force,
                                  const Vector3     &x,
                                  const Vector3     &v,
                                  const UpdateAxis  &axis,
                                  BodySums          &sums)
  {
    // Sums are added up over ranks: copies of a node would count it twice.
    if (!node.owned)
      return;
    // Energy and momenta as update_nodes() counts them, with v = (v- + v+)/2 for powers of dampers.
    const auto add_drive = [&](const Vector3 &reaction) {
      sums.drive_power_before += reaction.dot(node.old_velocity);
      sums.drive_power_after += reaction.dot(v);
    };
    const Vector3 mean = 0.5 * (node.old_velocity + v);
    sums.update.kinetic += 0.5 * node.mass * node.old_velocity.dot(v);
    add_node_moments(axis, node.mass, x, v, sums.update);
    if (group.turns_freely() || group.kind == ConstraintKind::directions)
      {
        // Where the node is free to turn or to move its damping does work.
        const Vector3 relative = mean - damping.rigid.at(node.old_position);
        sums.update.damping_power += damping.zeta * node.mass * relative.dot(mean);
        sums.update.mesh_power += node.mass * damping.mesh.at(node.old_position).dot(mean);
        sums.update.damping_torque -=
          damping.zeta * node.mass *
          group.axis.direction.cross(node.old_position - group.axis.point).dot(relative);
      }
    if (group.kind == ConstraintKind::directions)
      // What prescribed displacements have added to the motion under forces and damping.
      // m (1 + a)/dt (v+ - v*): the force that makes v+ of v* in the damped update, a = zeta dt/2
      add_drive(node.mass * (1. + 0.5 * damping.zeta * dt) / dt * (v - node.free_velocity));
    else if (group.kind == ConstraintKind::prescribed_rotation)
      {
        // The drive's force is what inertia asks for beyond the forces: m (v+ - v-)/dt - f.
        const Vector3 reaction = node.mass / dt * (v - node.old_velocity) - force;
        add_drive(reaction);
        sums.drive_torque +=
          group.axis.direction.dot((node.old_position - group.axis.point).cross(reaction));
      }
  }

  void ConstraintMotion::add_motion(const NodeField          &velocities,
                                    std::vector<NodalMotion> &motions) const
  {
    for (const Group &group : groups_)
      for (const Node &node : group.nodes)
        if (node.owned)
          motions[group.body].add(axes_[group.body],
                                  node.mass,
                                  node.old_position,
                                  node.old_velocity,
                                  velocities.value(node.local));
  }

  void ConstraintMotion::add_reaction(const Group           &group,
                                      const Node            &node,
                                      const Vector3         &place,
                                      const Vector3         &reaction,
                                      std::vector<Reaction> &reactions) const
  {
    const auto of = [&](const Constraint *constraint) -> Reaction & {
      return reactions[constraint - model_.constraints.data()];
    };
    if (node.shared < 0)
      of(group.definition).add(place, reaction);
    else
      for (const auto &[constraint, part] : shared_[node.shared].share(reaction, place))
        of(constraint).add(place, part);
  }

  void ConstraintMotion::add_reactions(const double                    dt,
                                       const std::vector<BodyDamping> &damping,
                                       const NodeField                &forces,
                                       const NodeField                &velocities,
                                       std::vector<Reaction>          &reactions) const
  {
    for (const Group &group : groups_)
      for (const Node &node : group.nodes)
        if (node.owned)
          {
            // m (v+ - v-)/dt = f + reaction - zeta m (v - u) - m slip, v = (v- + v+)/2; what is on
            // a prescribed path is not damped.
            const Vector3      v       = velocities.value(node.local);
            const BodyDamping &of_body = damping[group.body];
            Vector3 reaction = node.mass / dt * (v - node.old_velocity) - forces.value(node.local);
            if (group.turns_freely() || group.kind == ConstraintKind::directions)
              reaction += node.mass * (of_body.zeta * (0.5 * (node.old_velocity + v) -
                                                       of_body.rigid.at(node.old_position)) +
                                       of_body.mesh.at(node.old_position));
            add_reaction(group, node, node.old_position, reaction, reactions);
          }
  }

  void ConstraintMotion::add_static_reactions(const NodeField       &positions,
                                              const NodeField       &forces,
                                              const NodeField       &projected,
                                              std::vector<Reaction> &reactions) const
  {
    for (const Group &group : groups_)
      for (const Node &node : group.nodes)
        if (node.owned)
          add_reaction(group,
                       node,
                       positions.value(node.local),
                       projected.value(node.local) - forces.value(node.local),
                       reactions);
  }
} // namespace vfife
