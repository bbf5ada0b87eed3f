// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// What constrained nodes add to momenta, energies and powers.
#include <vfife/dynamics/motion/constraint_motion.h>

namespace vfife
{
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
} // namespace vfife
