// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/process/communicator.h>
#include <vfife/base/text/byte_stream.h>
#include <vfife/base/types.h>
#include <vfife/dynamics/motion/free_rotation.h>

#include <cmath>

namespace vfife
{
  namespace
  {
    Vector3 turned(const Axis &axis, const Vector3 &start, const double angle)
    {
      // Rodrigues: cos s + sin a x s + (1 - cos) (a . s) a
      const Vector3 &a = axis.direction;
      return axis.point + std::cos(angle) * start + std::sin(angle) * a.cross(start) +
             (1. - std::cos(angle)) * a.dot(start) * a;
    }

    /** Angles of the group's nodes less than half a turn from their mean. */
    void count_alike(ConstrainedGroup &group, const Communicator &communicator)
    {
      // About half a turn some nodes have nearly pi and others -pi: all count from the mean
      // direction.
      std::vector<double> sums(2, 0.);
      for (const ConstrainedNode &node : group.nodes)
        if (node.owned && group.has_angle(node))
          {
            sums[0] += std::sin(node.angle);
            sums[1] += std::cos(node.angle);
          }
      communicator.sum(sums);
      const double mean = std::atan2(sums[0], sums[1]);
      for (ConstrainedNode &node : group.nodes)
        if (group.has_angle(node))
          node.angle = count_turns(node.angle, mean);
    }

    void share_rotation(ConstrainedGroup &group, const Communicator &communicator)
    {
      // Round-off of the chords would make the nodes of a rigid hub drift apart over many steps.
      std::vector<double> sums(3, 0.);
      for (const ConstrainedNode &node : group.nodes)
        if (node.owned && group.has_angle(node))
          {
            sums[0] += node.angle;
            sums[1] += node.rate;
            sums[2] += 1.;
          }
      communicator.sum(sums);
      // Without a node off the axis there is nothing to turn.
      if (sums[2] == 0)
        return;
      for (ConstrainedNode &node : group.nodes)
        {
          node.angle = sums[0] / sums[2];
          node.rate  = sums[1] / sums[2];
        }
    }
  } // namespace

  void read_rotation(ConstrainedGroup   &group,
                     const State        &state,
                     const bool          with_rates,
                     const Communicator &communicator)
  {
    for (ConstrainedNode &node : group.nodes)
      {
        node.angle = node.rate = 0;
        if (!group.has_angle(node))
          continue;
        // The angle between the radial parts of the start and of the present place.
        const Vector3 r       = state.node_position(node.local) - group.axis.point;
        const Vector3 a       = group.axis.direction;
        const Vector3 start_r = node.start - a.dot(node.start) * a;
        node.angle            = std::atan2(a.dot(start_r.cross(r)), start_r.dot(r));
        if (with_rates)
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
    count_alike(group, communicator);
    if (group.kind == ConstraintKind::rigid_hub)
      share_rotation(group, communicator);
  }

  void accelerate_rotation(ConstrainedGroup   &group,
                           const double        dt,
                           const BodyDamping  &damping,
                           const NodeField    &forces,
                           const Communicator &communicator)
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
        for (ConstrainedNode &node : group.nodes)
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
    for (const ConstrainedNode &node : group.nodes)
      if (node.owned && group.has_angle(node))
        {
          const Vector3 e = a.cross(node.old_position - group.axis.point);
          torque_and_inertia[0] += e.dot(forces.value(node.local));
          torque_and_inertia[1] += node.moved_mass * e.squaredNorm();
        }
    communicator.sum(torque_and_inertia);
    if (torque_and_inertia[1] == 0)
      return;
    for (ConstrainedNode &node : group.nodes)
      accelerate(node.rate, torque_and_inertia[0] / torque_and_inertia[1]);
  }

  Vector3 turn_on(const Axis &axis, ConstrainedNode &node, const double dt)
  {
    node.angle += dt * node.rate;
    return turned(axis, node.start, node.angle);
  }

  Vector3 find_chord_velocity(const Axis &axis, const ConstrainedNode &node, const double dt)
  {
    // 2 sin(turn/2) e, e = axis x r half way
    const double  turn   = dt * node.rate;
    const Vector3 middle = turned(axis, node.start, node.angle - .5 * turn);
    return 2. * std::sin(.5 * turn) / dt * axis.direction.cross(middle - axis.point);
  }

  void serialize_rotation(ConstrainedGroup   &group,
                          ByteStream         &stream,
                          const Partition    &partition,
                          const Communicator &communicator)
  {
    // Groups differ from rank to rank by the nodes they hold; numbered as in the model, with zeros
    // where no node is of the group, they are the same for any number of ranks.
    std::vector<double> angles(2 * partition.local_node.size(), 0.); // and rates
    const auto          place = [&](const ConstrainedNode &node) {
      return angles.data() + 2 * static_cast<std::size_t>(partition.global_node[node.local]);
    };
    for (const ConstrainedNode &node : group.nodes)
      if (!stream.reads() && node.owned)
        {
          place(node)[0] = node.angle;
          place(node)[1] = node.rate;
        }
    if (!stream.reads())
      communicator.sum(angles);
    stream.pass_known(angles);
    for (ConstrainedNode &node : group.nodes)
      {
        node.angle = place(node)[0];
        node.rate  = place(node)[1];
      }
  }
} // namespace vfife
