// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/contact/surface/edge_relief.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace vfife
{
  namespace
  {
    struct Segment
    {
      Vector3 start, along;

      double square_distance(const Vector3 &x) const
      {
        // The foot on the line, or the end that is nearer.
        const double t = (x - start).dot(along) / along.squaredNorm();
        return (x - start - std::min(1., std::max(0., t)) * along).squaredNorm();
      }
    };

    /** Group and number of an edge. */
    using EdgeKey = std::pair<unsigned int, unsigned int>;

    std::map<EdgeKey, std::vector<Segment>> collect_edges(const FacetSurface &surface)
    {
      std::map<EdgeKey, std::vector<Segment>> edges;
      for (std::size_t f = 0; f < surface.facets.size(); ++f)
        for (unsigned int side = 0; side < 4; ++side)
          {
            const unsigned int number = edge_number(surface, f, side);
            if (number == 0)
              continue;
            const Vector3 &start = surface.positions[surface.facets[f][side]];
            const Vector3 &end   = surface.positions[surface.facets[f][(side + 1) % 4]];
            edges[{group_of(surface, f), number}].push_back({start, end - start});
          }
      return edges;
    }

    double distance_to(const std::vector<Segment> &edge, const Vector3 &x)
    {
      double least = std::numeric_limits<double>::infinity();
      for (const Segment &segment : edge)
        least = std::min(least, segment.square_distance(x));
      return std::sqrt(least);
    }
  } // namespace

  EdgeRelief::EdgeRelief(const FacetSurface &surface, const ContactOptions &options)
  {
    if (!(options.edge_relief_depth > 0.))
      return;
    if (surface.neighbours.size() != surface.facets.size() ||
        (!surface.edges.empty() && surface.edges.size() != surface.facets.size()))
      throw InputError("surface \"" + surface.name +
                       "\": every facet needs its neighbours, and its edges or none");
    // For every facet and every edge of its group (tip, toe, heel): the distances d/width of the
    // corners as c0 + c1 xi + c2 eta + c3 xi eta, kept where they come below 1.
    const auto edges = collect_edges(surface);
    depth_           = options.edge_relief_depth;
    for (std::size_t f = 0; f < surface.facets.size(); ++f)
      {
        const unsigned int group = group_of(surface, f);
        starts_.push_back(static_cast<unsigned int>(distances_.size()));
        for (auto edge = edges.lower_bound({group, 0});
             edge != edges.end() && edge->first.first == group;
             ++edge)
          {
            std::array<double, 4> d;
            for (unsigned int k = 0; k < 4; ++k)
              d[k] = distance_to(edge->second, surface.positions[surface.facets[f][k]]) /
                     options.edge_relief_width;
            // A bilinear function is least at a corner.
            if (*std::min_element(d.begin(), d.end()) < 1.)
              distances_.push_back({{{d[0], d[1] - d[0], d[3] - d[0], d[0] - d[1] + d[2] - d[3]}}});
          }
        most_edges_ =
          std::max(most_edges_, static_cast<unsigned int>(distances_.size()) - starts_.back());
      }
    starts_.push_back(static_cast<unsigned int>(distances_.size()));
  }
} // namespace vfife
