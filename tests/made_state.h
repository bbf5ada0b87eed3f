// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_tests_made_state_h
#define vfife_tests_made_state_h

#include <vfife/dynamics/operator/whole_partition.h>
#include <vfife/model/model.h>
#include <vfife/model/state.h>

#include <functional>

/** Where a node of a body is, given its number in the body and its place at time zero [mm]. */
using PlaceOfNode = std::function<
  vfife::Vector3(const vfife::Body &body, unsigned int node, const vfife::Vector3 &start)>;

/** A state on one rank with every node at its @p place and at rest. */
inline vfife::State made_state(const vfife::Model &model, const PlaceOfNode &place)
{
  vfife::State state;
  state.partition = vfife::make_whole_partition(model);
  state.position = state.velocity = vfife::NodeField(model.n_nodes());
  for (const vfife::Body &body : model.bodies)
    {
      for (unsigned int i = 0; i < body.n_nodes(); ++i)
        state.position.set(body.first_node + i,
                           place(body, i, body.placement(body.node_positions()[i])));
      state.body_motion.push_back(body.placement);
    }
  return state;
}

/** Bodies as they stand at time zero, at rest, without contact. */
inline vfife::State undeformed_state(const vfife::Model &model)
{
  vfife::State state;
  state.partition = vfife::make_whole_partition(model);
  state.position = state.velocity = state.contact_force = vfife::NodeField(model.n_nodes());
  for (const vfife::Body &body : model.bodies)
    for (unsigned int i = 0; i < body.n_nodes(); ++i)
      {
        state.position.set(body.first_node + i, body.placement(body.node_positions()[i]));
        state.velocity.set(body.first_node + i, vfife::Vector3::Zero());
        state.contact_force.set(body.first_node + i, vfife::Vector3::Zero());
      }
  return state;
}

#endif
