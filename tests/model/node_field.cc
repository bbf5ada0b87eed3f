// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// Vectors at local nodes, the ranges over them, and a partition that copies of a state share.
#include "../parts.h"
#include "../tests.h"

#include <vfife/model/state.h>

using namespace vfife;

/** Two bodies of 3 and 4 local nodes; this rank counts the first of the first body and the inner
 * two of the second one. */
Partition make_partition()
{
  Partition partition;
  partition.global_node = {0, 2, 3, 5, 6, 7, 9};
  partition.local_node  = {
     0, Partition::absent, 1, 2, Partition::absent, 3, 4, 5, Partition::absent, 6};
  partition.owned            = {1, 0, 0, 0, 1, 1, 0};
  partition.first_local_node = {0, 3, 7};
  return partition;
}

std::vector<std::uint32_t> list(const NodeRange &range)
{
  std::vector<std::uint32_t> nodes;
  for (const std::uint32_t node : range)
    nodes.push_back(node);
  return nodes;
}

void check_ranges()
{
  using List                = std::vector<std::uint32_t>;
  const Partition partition = make_partition();
  check("all nodes", list(partition.nodes()) == List{0, 1, 2, 3, 4, 5, 6});
  check("nodes of a body", list(partition.nodes(1)) == List{3, 4, 5, 6});
  check("owned nodes", list(partition.owned_nodes()) == List{0, 4, 5});
  check("owned nodes of a body",
        list(partition.owned_nodes(0)) == List{0} && list(partition.owned_nodes(1)) == List{4, 5});
  check("owned node by its number in the model",
        partition.find_owned(6) == 4 && partition.find_owned(5) == Partition::absent &&
          partition.find_owned(4) == Partition::absent);

  Partition none = partition;
  none.owned.assign(none.n_local(), 0);
  check("a rank that counts nothing",
        list(none.owned_nodes()).empty() && list(none.owned_nodes(1)).empty());
}

void check_field()
{
  NodeField field(3);
  check("zero at first",
        field.n_nodes() == 3 && field.value(2) == Vector3::Zero() && field.number(2) == 0);
  field.set(1, Vector3(1, 2, 3));
  field.set_number(1, 7);
  field.add(1, Vector3(1, 0, -1));
  field.add(2, Vector3::UnitY());
  check("set and added", field.value(1) == Vector3(2, 2, 2) && field.value(2) == Vector3(0, 1, 0));
  check("the number stays beside the vector", field.number(1) == 7 && field.number(2) == 0);
  const double expected[12] = {0, 0, 0, 0, 2, 2, 2, 7, 0, 1, 0, 0};
  check("records for kernels", std::equal(expected, expected + 12, field.data()));

  NodeField sum = field;
  sum += field;
  check("sum", sum.value(1) == Vector3(4, 4, 4));
  check("difference", (sum - field).value(2) == Vector3(0, 1, 0));
  field.set_zero();
  check("set to zero", field.value(1) == Vector3::Zero() && field.number(1) == 0);
  check("empty", NodeField().empty() && !field.empty());
}

void check_sharing()
{
  State state;
  state.partition = std::make_shared<const Partition>(make_partition());
  state.position  = NodeField(7);
  State copy      = state;
  copy.position.set(0, Vector3::Ones());
  check("copies share the partition and nothing else",
        copy.partition == state.partition && state.node_position(0) == Vector3::Zero());
}

int main()
{
  return run_parts({check_ranges, check_field, check_sharing});
}
