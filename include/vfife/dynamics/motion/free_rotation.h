// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_dynamics_motion_free_rotation_h
#define vfife_dynamics_motion_free_rotation_h

#include <vfife/dynamics/motion/constrained_group.h>
#include <vfife/dynamics/motion/nodal_update.h>
#include <vfife/model/state.h>

namespace vfife
{
  class ByteStream;
  class Communicator;

  // Groups whose nodes turn freely on their circles (ConstrainedGroup::turns_freely()), each node
  // with its own angle or all of a rigid hub with one.

  /** Takes angles from the positions of the @p state and, if @p with_rates, angular velocities from
   * those of the nodes; nodes of a rigid hub share their mean. Collective. */
  void read_rotation(ConstrainedGroup   &group,
                     const State        &state,
                     bool                with_rates,
                     const Communicator &communicator);

  /** New angular velocities after a step @p dt [s]. Collective where the group is a rigid hub. */
  void accelerate_rotation(ConstrainedGroup   &group,
                           double              dt,
                           const BodyDamping  &damping,
                           const NodeField    &forces,
                           const Communicator &communicator);

  /** Turns a node with its rate: the new place. */
  Vector3 turn_on(const Axis &axis, ConstrainedNode &node, double dt);

  /** The velocity of the step @p dt [s] with which turn_on() has moved a node, without the
   * difference of two places. */
  Vector3 find_chord_velocity(const Axis &axis, const ConstrainedNode &node, double dt);

  /** For checkpoints: angles and angular velocities by node of the model, for any number of ranks.
   * Collective. */
  void serialize_rotation(ConstrainedGroup   &group,
                          ByteStream         &stream,
                          const Partition    &partition,
                          const Communicator &communicator);
} // namespace vfife

#endif
