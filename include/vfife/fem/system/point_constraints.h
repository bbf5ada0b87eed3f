// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_fem_system_point_constraints_h
#define vfife_fem_system_point_constraints_h

#include <vfife/fem/system/fem_space.h>
#include <vfife/model/constraints/node_constraints.h>

#include <map>

namespace vfife
{
  /** The checked constraints of all points of a space that have any, by point; as
   * combine_constraints(), with the points of quadratic elements between the nodes. */
  std::map<unsigned int, NodeConstraints> find_point_constraints(const FemSpace &space);
} // namespace vfife

#endif
