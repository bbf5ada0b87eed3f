// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_mesh_primitives_disc_cells_h
#define vfife_mesh_primitives_disc_cells_h

#include <vfife/base/types.h>

#include <array>
#include <vector>

namespace vfife
{
  /** Radius of the corners of the core of a disc or ball over its radius: cells of about equal
   * size. */
  constexpr double core_part = .6;
  /** How far the sides of the core bulge from chords (0) to arcs (1): opens the corners at its
   * edges. */
  constexpr double core_bulge = .5;

  /** The cells of a disc: core of n x n, then rows between the core's border and the circle. */
  struct DiscCells
  {
    std::vector<Vector2>                     nodes;      ///< of the unit disc, the circle last
    std::vector<std::array<unsigned int, 4>> cells;      ///< lexicographic
    unsigned int                             border = 0; ///< nodes around
  };

  /** The core is a bulged square of n x n cells; as many cells as it has border nodes (4 n) lead in
   * rows from its border straight to the circle, at equal angles from -135 degrees on. */
  DiscCells divide_disc(unsigned int n, unsigned int rows);
} // namespace vfife

#endif
