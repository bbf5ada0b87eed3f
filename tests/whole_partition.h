// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_tests_whole_partition_h
#define vfife_tests_whole_partition_h

#include <vfife/model/model.h>
#include <vfife/model/state.h>

#include <functional>
#include <memory>
#include <numeric>

/** All nodes and elements of a model on one rank, in the model's order. */
inline std::shared_ptr<const vfife::Partition> whole_partition(const vfife::Model &model)
{
  vfife::Partition partition;
  partition.global_node.resize(model.n_nodes());
  std::iota(partition.global_node.begin(), partition.global_node.end(), 0u);
  partition.local_node = partition.global_node;
  partition.owned.assign(model.n_nodes(), 1);
  for (const vfife::Body &body : model.bodies)
    partition.first_local_node.push_back(body.first_node);
  partition.first_local_node.push_back(model.n_nodes());
  partition.elements.resize(model.n_elements());
  std::iota(partition.elements.begin(), partition.elements.end(), 0u);
  return std::make_shared<const vfife::Partition>(partition);
}

/** Where a node of a body is, given its number in the body and its place at time zero [mm]. */
using PlaceOfNode = std::function<
  vfife::Vector3(const vfife::Body &body, unsigned int node, const vfife::Vector3 &start)>;

/** A state on one rank with every node at its @p place and at rest. */
inline vfife::State made_state(const vfife::Model &model, const PlaceOfNode &place)
{
  vfife::State state;
  state.partition = whole_partition(model);
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
  state.partition = whole_partition(model);
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
