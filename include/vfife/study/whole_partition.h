// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_study_whole_partition_h
#define vfife_study_whole_partition_h

#include <memory>

namespace vfife
{
  struct Model;
  struct Partition;

  /** All nodes and elements of a model on this rank. */
  std::shared_ptr<Partition> make_whole_partition(const Model &model);
} // namespace vfife

#endif
