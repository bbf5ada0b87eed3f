// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_dynamics_operator_whole_partition_h
#define vfife_dynamics_operator_whole_partition_h

#include <memory>

namespace vfife
{
  struct Model;
  struct Partition;

  /** All nodes and elements of a model on this rank, in the order of the model. */
  std::shared_ptr<Partition> make_whole_partition(const Model &model);
} // namespace vfife

#endif
