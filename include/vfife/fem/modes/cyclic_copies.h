// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_fem_modes_cyclic_copies_h
#define vfife_fem_modes_cyclic_copies_h

#include <vfife/base/types.h>

#include <cstddef>
#include <vector>

namespace vfife
{
  /** Points that turn into each other by a part of a revolution. */
  struct CyclicCopies
  {
    unsigned int n_sectors = 0; ///< 0: no part of a revolution, or only half of one, does it
    /** Copy k of point i of the first sector: points[k * n_per_sector() + i]. Points on the axis
     * are their own copies and left out. */
    std::vector<unsigned int> points;

    std::size_t n_per_sector() const
    {
      return n_sectors == 0 ? 0 : points.size() / n_sectors;
    }
  };

  /**
   * The largest number N >= 3 of equal sectors about the axis through the origin along the unit
   * vector @p axis such that each point, turned by 2 pi/N, meets another one within 1e-6 of the
   * largest distance from the origin (mesh files are written with that many digits). Whatever the
   * order of the points is.
   */
  CyclicCopies find_cyclic_copies(const std::vector<Vector3> &points, const Vector3 &axis);
} // namespace vfife

#endif
