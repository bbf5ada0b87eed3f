// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_dynamics_motion_constrained_group_h
#define vfife_dynamics_motion_constrained_group_h

#include <vfife/dynamics/motion/prescribed_place.h>
#include <vfife/model/model.h>

#include <cstdint>
#include <vector>

namespace vfife
{
  /** A node that constraints hold or lead, of this rank. */
  struct ConstrainedNode
  {
    std::uint32_t local;
    bool          owned;
    double        mass;       ///< lumped
    double        moved_mass; ///< see ConstraintMotion::set_masses()
    Vector3       start;      ///< undeformed position at time zero relative to the axis point
    Vector3       old_position = Vector3::Zero(), old_velocity = Vector3::Zero();
    double        angle = 0, rate = 0; ///< free rotations

    HeldDirections held;                            ///< of nodes led in directions
    Vector3        free_velocity = Vector3::Zero(); ///< without the prescribed displacements
    int            shared        = -1;              ///< index among nodes in several constraints
  };

  /** The nodes of one constraint, which says by its kind how they move. */
  struct ConstrainedGroup
  {
    const Constraint            *definition;
    ConstraintKind               kind;
    unsigned int                 body;
    Axis                         axis;
    std::vector<ConstrainedNode> nodes;

    bool turns_freely() const
    {
      return kind == ConstraintKind::free_rotation || kind == ConstraintKind::rigid_hub;
    }

    /** Whether the node has an angle about the axis. On the axis itself there is none: a node
     * there stays where it is, whatever turns around it. */
    bool has_angle(const ConstrainedNode &node) const
    {
      return axis.direction.cross(node.start).norm() > on_axis_distance;
    }
  };
} // namespace vfife

#endif
