// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/facet_surface.h>

#include <algorithm>
#include <set>
#include <tuple>

namespace vfife
{
  namespace
  {
    /** One side of a facet, with the nodes of its ends in order of their numbers. */
    struct FacetSide
    {
      unsigned int low, high, facet, side;
      bool         upwards; ///< the facet runs along it from the lower to the higher node

      bool operator<(const FacetSide &other) const
      {
        return std::tie(low, high, facet) < std::tie(other.low, other.high, other.facet);
      }
    };
  } // namespace

  std::vector<unsigned int> list_group_nodes(const FacetSurface &surface, const unsigned int group)
  {
    std::set<unsigned int> nodes;
    for (std::size_t f = 0; f < surface.facets.size(); ++f)
      if (surface.group[f] == group)
        nodes.insert(surface.facets[f].begin(), surface.facets[f].end());
    return {nodes.begin(), nodes.end()};
  }

  void find_neighbours(FacetSurface &surface)
  {
    // corners in the order (0,0), (1,0), (1,1), (0,1): side k runs from corner k to corner k+1
    //     3 ---2--- 2
    //     |         |     counter-clockwise seen from outside; a side is known by its two nodes,
    //     3  facet  1     whichever of its facets names them
    //     |         |
    //     0 ---0--- 1
    std::vector<FacetSide> sides;
    sides.reserve(4 * surface.facets.size());
    for (unsigned int f = 0; f < surface.facets.size(); ++f)
      for (unsigned int k = 0; k < 4; ++k)
        {
          const unsigned int a = surface.facets[f][k], b = surface.facets[f][(k + 1) % 4];
          sides.push_back({std::min(a, b), std::max(a, b), f, k, a < b});
        }
    // Sorted, both copies of a shared side are neighbours in the list.
    std::sort(sides.begin(), sides.end());

    // Each side that two facets share makes them neighbours; the others are the border.
    const unsigned int none = FacetSurface::no_facet;
    surface.neighbours.assign(surface.facets.size(), {{none, none, none, none}});
    for (std::size_t i = 0; i + 1 < sides.size(); ++i)
      {
        const FacetSide &one = sides[i], &two = sides[i + 1];
        if (one.low != two.low || one.high != two.high)
          continue;
        const std::string facets = "facets " + std::to_string(one.facet) + " and " +
                                   std::to_string(two.facet) + " of surface \"" + surface.name +
                                   "\"";
        if (i + 2 < sides.size() && sides[i + 2].low == one.low && sides[i + 2].high == one.high)
          throw InputError(
            facets + " share an edge with a third facet; at most two facets may share an edge");
        // Facets that turn alike run along their common side in opposite senses.
        if (one.upwards == two.upwards)
          throw InputError(
            facets +
            " are not oriented alike: corners must run counter-clockwise seen from outside");
        surface.neighbours[one.facet][one.side] = two.facet;
        surface.neighbours[two.facet][two.side] = one.facet;
      }
  }

  unsigned int group_of(const FacetSurface &surface, const std::size_t facet)
  {
    return surface.group.empty() ? 0 : surface.group[facet];
  }

  unsigned int
  edge_number(const FacetSurface &surface, const std::size_t facet, const unsigned int side)
  {
    if (!surface.edges.empty())
      return surface.edges[facet][side];
    const unsigned int other = surface.neighbours[facet][side];
    return other == FacetSurface::no_facet || group_of(surface, other) != group_of(surface, facet);
  }
} // namespace vfife
