// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_fem_submodel_submodel_part_h
#define vfife_fem_submodel_submodel_part_h

#include <vfife/base/types.h>

#include <utility>
#include <vector>

namespace vfife
{
  /** Part of a gear body that a submodel has. */
  enum class SubmodelPart
  {
    teeth, ///< a tooth, the halves beside it and their rim
    web    ///< web and hub of a sector and of five on either side
  };

  /** A linear reading of displacements: the sum of the weights times the displacements of points of
   * a space. */
  using PointReading = std::vector<std::pair<unsigned int, Vector3>>;
} // namespace vfife

#endif
