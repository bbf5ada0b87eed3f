// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// Nodes that turn freely on their circles, each with its own angle or all of a rigid hub with one.
#include <vfife/base/counted_angle.h>
#include <vfife/base/process/communicator.h>
#include <vfife/base/text/byte_stream.h>
#include <vfife/dynamics/motion/constraint_motion.h>

#include <cmath>
#include <limits>

namespace vfife
{
  void ConstraintMotion::read(const State &state, const MotionFrame frame)
  {
    for (Group &group : groups_)
      if (group.turns_freely())
        for (Node &node : group.nodes)
          {
            node.angle = node.rate = 0;
            if (!group.has_angle(node))
              continue;
            // The angle between the radial parts of the start and of the present place.
            const Vector3 r       = state.node_position(node.local) - group.axis.point;
            const Vector3 a       = group.axis.direction;
            const Vector3 start_r = node.start - a.dot(node.start) * a;
            node.angle            = std::atan2(a.dot(start_r.cross(r)), start_r.dot(r));
            if (frame == MotionFrame::fixed)
              {
                // The velocity is the chord of the last step: 2 rho sin(rate dt/2)/dt.
                // That step went from r - dt v to r: at its middle the moment of v about the axis
                // has the sense of the turn.
                const Vector3 v      = state.node_velocity(node.local);
                const double  rho    = start_r.norm();
                const Vector3 middle = r - 0.5 * state.dt * v;
                const double  sense  = a.dot(middle.cross(v)) < 0 ? -1. : 1.;
                node.rate =
                  sense * 2. / state.dt * std::asin(std::min(1., v.norm() * state.dt / (2. * rho)));
              }
          }
    for (Group &group : groups_)
      {
        if (group.turns_freely())
          count_alike(group);
        if (group.kind == ConstraintKind::rigid_hub)
          share_rotation(group);
      }
  }

  void ConstraintMotion::count_alike(Group &group) const
  {
    // About half a turn some nodes have nearly pi and others -pi: all count from the mean
    // direction.
    std::vector<double> sums(2, 0.);
    for (const Node &node : group.nodes)
      if (node.owned && group.has_angle(node))
        {
          sums[0] += std::sin(node.angle);
          sums[1] += std::cos(node.angle);
        }
    communicator_.sum(sums);
    const double mean = std::atan2(sums[0], sums[1]);
    for (Node &node : group.nodes)
      if (group.has_angle(node))
        node.angle = count_turns(node.angle, mean);
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

  void ConstraintMotion::share_rotation(Group &group) const
  {
    // Round-off of the chords would make the nodes of a rigid hub drift apart over many steps.
    std::vector<double> sums(3, 0.);
    for (const Node &node : group.nodes)
      if (node.owned && group.has_angle(node))
        {
          sums[0] += node.angle;
          sums[1] += node.rate;
          sums[2] += 1.;
        }
    communicator_.sum(sums);
    // Without a node off the axis there is nothing to turn.
    if (sums[2] == 0)
      return;
    for (Node &node : group.nodes)
      {
        node.angle = sums[0] / sums[2];
        node.rate  = sums[1] / sums[2];
      }
  }

  Vector3 ConstraintMotion::turn_on(const Group &group, Node &node, const double dt)
  {
    node.angle += dt * node.rate;
    return turned(group.axis, node.start, node.angle);
  }

  Vector3 ConstraintMotion::find_way(const Group   &group,
                                     const Node    &node,
                                     const double   dt,
                                     const Vector3 &chord) const
  {
    // What the node has gone where it is free, without the difference of two places.
    Vector3 v = chord;
    if (group.turns_freely())
      {
        // 2 sin(turn/2) e, e = axis x r half way
        const double  turn   = dt * node.rate;
        const Vector3 middle = turned(group.axis, node.start, node.angle - .5 * turn);
        v = 2. * std::sin(.5 * turn) / dt * group.axis.direction.cross(middle - group.axis.point);
      }
    else if (group.kind == ConstraintKind::directions)
      v += project_free(group.axis, node.old_position, node.held, node.free_velocity - chord);
    // More than round-off is a turn that place_prescribed() has made beside it.
    const double size = 2. * node.old_position.norm() + node.start.norm();
    return (v - chord).norm() * dt <= 64. * std::numeric_limits<double>::epsilon() * size ? v
                                                                                          : chord;
  }

  Vector3 ConstraintMotion::turned(const Axis &axis, const Vector3 &start, const double angle)
  {
    // Rodrigues: cos s + sin a x s + (1 - cos) (a . s) a
    const Vector3 &a = axis.direction;
    return axis.point + std::cos(angle) * start + std::sin(angle) * a.cross(start) +
           (1. - std::cos(angle)) * a.dot(start) * a;
  }

  void ConstraintMotion::turn_freely(Group             &group,
                                     const double       dt,
                                     const BodyDamping &damping,
                                     const NodeField   &forces) const
  {
    // Central differences of the angle, damped as update_nodes() damps velocities,
    //   rate+ = ((1 - a) rate- + dt (acceleration - slip) + 2 a omega)/(1 + a),  a = zeta dt/2
    const Vector3 &a          = group.axis.direction;
    const double   half       = 0.5 * damping.zeta * dt;
    const double   rigid_rate = a.dot(damping.rigid.omega), slip = a.dot(damping.mesh.omega);
    const auto     accelerate = [&](double &rate, const double acceleration) {
      rate =
        ((1. - half) * rate + dt * (acceleration - slip) + 2. * half * rigid_rate) / (1. + half);
    };

    // Each node by its own torque and inertia: acceleration = e . f/(m e . e), e = axis x r.
    if (group.kind == ConstraintKind::free_rotation)
      {
        for (Node &node : group.nodes)
          {
            if (!group.has_angle(node))
              continue;
            const Vector3 e = a.cross(node.old_position - group.axis.point);
            accelerate(node.rate,
                       e.dot(forces.value(node.local)) / (node.moved_mass * e.squaredNorm()));
          }
        return;
      }

    // A rigid hub by those of all its nodes, on all ranks.
    std::vector<double> torque_and_inertia(2, 0.);
    for (const Node &node : group.nodes)
      if (node.owned && group.has_angle(node))
        {
          const Vector3 e = a.cross(node.old_position - group.axis.point);
          torque_and_inertia[0] += e.dot(forces.value(node.local));
          torque_and_inertia[1] += node.moved_mass * e.squaredNorm();
        }
    communicator_.sum(torque_and_inertia);
    if (torque_and_inertia[1] == 0)
      return;
    for (Node &node : group.nodes)
      accelerate(node.rate, torque_and_inertia[0] / torque_and_inertia[1]);
  }

  void ConstraintMotion::serialize(ByteStream &stream, const Partition &partition)
  {
    // Groups differ from rank to rank by the nodes they hold; numbered as in the model, with zeros
    // where no node is of the group, they are the same for any number of ranks.
    std::vector<double> angles; // and rates, by node of the model
    const auto          place = [&](const Node &node) {
      return angles.data() + 2 * static_cast<std::size_t>(partition.global_node[node.local]);
    };
    for (Group &group : groups_)
      {
        if (!group.turns_freely())
          continue;
        angles.assign(2 * partition.local_node.size(), 0.);
        for (const Node &node : group.nodes)
          if (!stream.reads() && node.owned)
            {
              place(node)[0] = node.angle;
              place(node)[1] = node.rate;
            }
        if (!stream.reads())
          communicator_.sum(angles);
        stream.pass_known(angles);
        for (Node &node : group.nodes)
          {
            node.angle = place(node)[0];
            node.rate  = place(node)[1];
          }
      }
  }
} // namespace vfife
