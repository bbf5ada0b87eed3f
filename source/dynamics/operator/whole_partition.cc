// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/dynamics/operator/whole_partition.h>
#include <vfife/model/model.h>
#include <vfife/model/partition.h>

#include <numeric>

namespace vfife
{
  std::shared_ptr<Partition> make_whole_partition(const Model &model)
  {
    auto partition = std::make_shared<Partition>();
    partition->global_node.resize(model.n_nodes());
    std::iota(partition->global_node.begin(), partition->global_node.end(), 0u);
    partition->local_node = partition->global_node;
    partition->owned.assign(model.n_nodes(), 1);
    for (const Body &body : model.bodies)
      partition->first_local_node.push_back(body.first_node);
    partition->first_local_node.push_back(model.n_nodes());
    partition->elements.resize(model.n_elements());
    std::iota(partition->elements.begin(), partition->elements.end(), 0u);
    return partition;
  }
} // namespace vfife
