// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// What constraints exert on their nodes, in motion and at rest.
#include <vfife/dynamics/motion/constraint_motion.h>

namespace vfife
{
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
