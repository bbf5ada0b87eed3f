// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/mesh/primitives/disc_cells.h>

#include <cmath>

namespace vfife
{
  namespace
  {
    /** Point of the unit disc for a point of the square [-1, 1]^2: concentric squares become bulged
     * squares. */
    Vector2 disc_core_point(const Vector2 &square)
    {
      // half-way between the square of half-side m and the arc of radius m over its side
      const double m = square.cwiseAbs().maxCoeff();
      if (m == 0.)
        return Vector2::Zero();
      const bool    wide  = std::abs(square[0]) >= std::abs(square[1]);
      const double  major = wide ? square[0] : square[1], minor = wide ? square[1] : square[0];
      const double  angle = pi / 4. * minor / m;
      const Vector2 arc   = wide ? Vector2(std::copysign(std::cos(angle), major), std::sin(angle))
                                 : Vector2(std::sin(angle), std::copysign(std::cos(angle), major));
      const double  bulge = core_bulge * m;
      return (1. - bulge) * square / std::sqrt(2.) + bulge * m * arc;
    }
  } // namespace

  DiscCells divide_disc(const unsigned int n, const unsigned int rows)
  {
    //   o-------o    n = 2: the core of n x n cells, its 4 n border nodes in turn from the corner
    //   |\o-o-o/|    at (-1, -1), and rows of as many cells from there to the circle, whose nodes
    //   | o o o |    lie at equal angles from -135 degrees on.
    //   |/o-o-o\|
    //   o-------o
    DiscCells  disc;
    const auto node = [n](const unsigned int i, const unsigned int j) { return j * (n + 1) + i; };
    for (unsigned int j = 0; j <= n; ++j)
      for (unsigned int i = 0; i <= n; ++i)
        disc.nodes.push_back(core_part * disc_core_point({2. * i / n - 1., 2. * j / n - 1.}));
    for (unsigned int j = 0; j < n; ++j)
      for (unsigned int i = 0; i < n; ++i)
        disc.cells.push_back({{node(i, j), node(i + 1, j), node(i, j + 1), node(i + 1, j + 1)}});

    // border of the core, where the first row starts
    std::vector<unsigned int> previous; // counter-clockwise from the corner (-1, -1)
    for (unsigned int i = 0; i < n; ++i)
      previous.push_back(node(i, 0));
    for (unsigned int j = 0; j < n; ++j)
      previous.push_back(node(n, j));
    for (unsigned int i = n; i > 0; --i)
      previous.push_back(node(i, n));
    for (unsigned int j = n; j > 0; --j)
      previous.push_back(node(0, j));
    disc.border = previous.size();

    // rows: from the core's border to the circle, at equal angles
    const std::vector<unsigned int> core = previous;
    for (unsigned int row = 1; row <= rows; ++row)
      {
        std::vector<unsigned int> next;
        for (unsigned int k = 0; k < disc.border; ++k)
          {
            const double  angle = -.75 * pi + 2. * pi * k / disc.border, part = double(row) / rows;
            const Vector2 circle(std::cos(angle), std::sin(angle));
            const Vector2 point = (1. - part) * disc.nodes[core[k]] + part * circle;
            next.push_back(disc.nodes.size());
            disc.nodes.push_back(point);
          }
        for (unsigned int k = 0; k < disc.border; ++k)
          {
            const unsigned int l = (k + 1) % disc.border;
            disc.cells.push_back({{previous[k], next[k], previous[l], next[l]}});
          }
        previous = next;
      }
    return disc;
  }
} // namespace vfife
