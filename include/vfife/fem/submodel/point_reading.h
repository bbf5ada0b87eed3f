// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_fem_submodel_point_reading_h
#define vfife_fem_submodel_point_reading_h

#include <vfife/base/types.h>

#include <utility>
#include <vector>

namespace vfife
{
  /** A linear reading of displacements: the sum of the weights times the displacements of points of
   * a space. */
  using PointReading = std::vector<std::pair<unsigned int, Vector3>>;
} // namespace vfife

#endif
