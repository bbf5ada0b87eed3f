// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/contact/pass/wide_search.h>

#include <algorithm>
#include <array>
#include <limits>
#include <numeric>

namespace vfife
{
  namespace
  {
    /** A point that lies over a facet is preferred to the border of another that is a little
     * nearer. */
    constexpr double border_handicap = 1.5;

    std::array<Vector3, 4> current_corners(const SurfaceGeometry &surface, const unsigned int facet)
    {
      const auto &k = surface.corners(facet);
      return {{surface.node(k[0]), surface.node(k[1]), surface.node(k[2]), surface.node(k[3])}};
    }
  } // namespace

  WideSearch::WideSearch(PassSurfaces &surfaces, const unsigned int master_group)
    : surfaces_(surfaces)
    , group_(surfaces.master.group_facets(master_group))
  {
    boxes_.reserve(group_.size());
    for (const unsigned int f : group_)
      boxes_.push_back(Box::around(current_corners(surfaces_.master, f), 0.));
  }

  bool WideSearch::find_foot(const Vector3 &x,
                             const Vector3 &slave_normal,
                             const double   reach,
                             Projection    &foot)
  {
    std::vector<unsigned int> all(group_.size());
    std::iota(all.begin(), all.end(), 0u);
    return find_foot(x, slave_normal, reach, all, foot);
  }

  bool WideSearch::find_foot(const Vector3             &x,
                             const Vector3             &slave_normal,
                             const double               reach,
                             std::vector<unsigned int> &near,
                             Projection                &foot)
  {
    SurfaceGeometry &master  = surfaces_.master;
    double           nearest = reach;
    std::size_t      found   = near.size();
    for (std::size_t i = 0; i < near.size(); ++i)
      {
        // Farther than the best foot so far, without any projection?
        if (boxes_[near[i]].square_distance(x) > nearest * nearest)
          continue;

        // Newton's method from the middle of the facet, with the height over it.
        const unsigned int facet  = group_[near[i]];
        const FacetState  &state  = master.state(facet);
        const Vector3      normal = state.normal(0.5, 0.5);
        Projection         projection;
        projection.facet  = facet;
        projection.lambda = (x - state.position(0.5, 0.5)).dot(normal) / normal.squaredNorm();
        if (!project_on_facet(state, master.border_sides(facet), x, projection))
          continue;

        // Back sides of the master are no candidates.
        const double xi  = std::min(1., std::max(0., projection.xi));
        const double eta = std::min(1., std::max(0., projection.eta));
        if (state.normal(xi, eta).dot(slave_normal) > 0.)
          continue;

        // The foot counts where it lies on the facet; one beyond it is moved to the border.
        double distance = clamped_distance(state, x, projection);
        if (!projection.inside)
          distance *= border_handicap;
        if (distance <= nearest)
          {
            nearest = distance;
            foot    = projection;
            found   = i;
          }
      }
    if (found == near.size())
      return false;
    std::swap(near.front(), near[found]);
    return true;
  }

  void WideSearch::find_points(PointList &list, const double open_reach, const double depth_reach)
  {
    list.points.clear();
    list.touching.clear();
    SlavePoints           &slave   = surfaces_.slave;
    SurfaceGeometry       &master  = surfaces_.master;
    const SurfaceGeometry &surface = slave.surface();
    const BoxTree          tree(boxes_);

    const double              reach = border_handicap * (std::max(open_reach, depth_reach) +
                                            surface.largest_offset() + master.largest_offset());
    std::vector<unsigned int> near;
    for (const unsigned int facet : surface.group_facets(list.slave_group))
      {
        if (!list.share.has(facet))
          continue;
        // Master facets near the whole slave facet, then the nearest foot of each of its points.
        tree.find(Box::around(current_corners(surface, facet), reach), near);
        if (near.empty())
          continue;
        const Vector3 slave_normal = surface.vector_area(facet);
        for (unsigned int q = 0; q < slave.rule().size(); ++q)
          {
            const Vector3 x = slave.position(facet, q);
            ListedPoint   point;
            if (!find_foot(x, slave_normal, reach, near, point.projection))
              continue;
            // The neighbour decides about points at the very edge of two facets.
            Projection walked = point.projection;
            if (project_walking(master, x, walked))
              point.projection = walked;

            // What the point needs in every step, and its gap; one that lies beyond the border is
            // kept too, as it may come in.
            point.slave_facet  = facet;
            point.rule_point   = q;
            point.area         = slave.area(facet, q);
            point.slave_offset = slave.offset(facet, q);
            point.pressure     = 0.;
            point.gap          = std::numeric_limits<double>::infinity();
            if (point.projection.inside)
              {
                point.gap = surfaces_.gap(point.projection, point.slave_offset);
                if (point.gap >= open_reach || point.gap <= -depth_reach)
                  continue;
              }
            list.points.push_back(point);
          }
      }
    // None sleeps yet.
    list.awake_at.assign(list.points.size(), -std::numeric_limits<double>::infinity());
  }
} // namespace vfife
