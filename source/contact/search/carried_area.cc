// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/contact/search/broad_search.h>
#include <vfife/contact/search/carried_area.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace vfife
{
  namespace
  {
    /** Steps of the table of factors; beyond it a factor grows at most as the ratio. */
    constexpr double       ratio_step = 0.05;
    constexpr unsigned int n_ratios   = 240;

    /** Lengths of a facet along its two directions, the longer one first [mm]. */
    struct FacetSides
    {
      double longer, shorter;
    };

    FacetSides sides(const SurfaceGeometry &surface, const unsigned int facet)
    {
      const auto &k    = surface.corners(facet);
      const auto  side = [&](const unsigned int i) {
        return (surface.reference(k[(i + 1) % 4]) - surface.reference(k[i])).norm();
      };
      const double one = 0.5 * (side(0) + side(2)), two = 0.5 * (side(1) + side(3));
      return {std::max(one, two), std::min(one, two)};
    }

    /** The facets' sides without those that are shorter both ways than others. */
    std::vector<FacetSides> longest_sides(const SurfaceGeometry &surface)
    {
      std::vector<FacetSides> all;
      for (unsigned int f = 0; f < surface.n_facets(); ++f)
        all.push_back(sides(surface, f));
      std::sort(all.begin(), all.end(), [](const FacetSides &a, const FacetSides &b) {
        return a.longer != b.longer ? a.longer > b.longer : a.shorter > b.shorter;
      });
      std::vector<FacetSides> longest;
      for (const FacetSides &s : all)
        if (longest.empty() || s.shorter > longest.back().shorter)
          longest.push_back(s);
      return longest;
    }
  } // namespace

  FacetDirections find_directions(const SurfaceGeometry &slave,
                                  const SurfaceGeometry &master,
                                  const RigidMotion     &slave_to_master)
  {
    const auto corners = [](const SurfaceGeometry &surface, const unsigned int facet) {
      std::array<Vector3, 4> x;
      for (unsigned int k = 0; k < 4; ++k)
        x[k] = surface.reference(surface.corners(facet)[k]);
      return x;
    };
    const auto normal = [](const std::array<Vector3, 4> &x) {
      return Vector3((x[2] - x[0]).cross(x[3] - x[1]).normalized());
    };
    // They face each other within 45 degrees, overlap, and are nearer than they are wide. Those of
    // teeth further on, which see each other too, lie in directions of their own.
    const auto do_face = [&](const std::array<Vector3, 4> &x,
                             const FacetSides             &of_x,
                             const std::array<Vector3, 4> &y,
                             const FacetSides             &of_y) {
      const Vector3 n     = normal(y),
                    way   = 0.25 * (x[0] + x[1] + x[2] + x[3] - y[0] - y[1] - y[2] - y[3]);
      const double height = n.dot(way);
      return normal(x).dot(n) < -std::sqrt(0.5) &&
             std::abs(height) < std::max(of_x.shorter, of_y.shorter) &&
             (way - height * n).norm() < 0.5 * (of_x.longer + of_y.longer);
    };
    const auto longer_direction = [](const std::array<Vector3, 4> &x) {
      const Vector3 one = x[1] - x[0] + x[2] - x[3], two = x[3] - x[0] + x[2] - x[1];
      return Vector3((one.norm() > two.norm() ? one : two).normalized());
    };

    std::vector<Box> boxes;
    for (unsigned int f = 0; f < master.n_facets(); ++f)
      boxes.push_back(Box::around(corners(master, f), 0.));
    const BoxTree             tree(boxes);
    std::vector<unsigned int> near;
    FacetDirections           found = {false, false};
    for (unsigned int f = 0; f < slave.n_facets(); ++f)
      {
        std::array<Vector3, 4> x = corners(slave, f);
        for (Vector3 &corner : x)
          corner = slave_to_master(corner);
        tree.find(Box::around(x, sides(slave, f).longer), near);
        for (const unsigned int m : near)
          {
            const std::array<Vector3, 4> y = corners(master, m);
            if (!do_face(x, sides(slave, f), y, sides(master, m)))
              continue;
            // Nearer to 0 or to 90 degrees.
            (std::abs(longer_direction(x).dot(longer_direction(y))) > std::sqrt(0.5)
               ? found.along
               : found.across) = true;
          }
      }
    return found.along || found.across ? found : FacetDirections();
  }

  CarriedArea::CarriedArea(const std::vector<FacetQuadraturePoint> &rule, const double edge_fading)
    : edge_fading_(edge_fading)
  {
    // A product of rules: the sum over all points with the same xi is the weight along xi.
    for (const FacetQuadraturePoint &q : rule)
      {
        const auto found    = std::find_if(points_.begin(), points_.end(), [&q](const double x) {
          return std::abs(x - q.xi) < 1e-12;
        });
        const std::size_t i = found - points_.begin();
        if (found == points_.end())
          {
            points_.push_back(q.xi);
            weights_.push_back(0.);
          }
        weights_[i] += q.weight;
      }
    // The largest sums so far, so that factors never decrease.
    for (const bool at_border : {false, true})
      {
        double largest = 1.;
        for (unsigned int i = 1; i <= n_ratios; ++i)
          {
            largest = std::max(largest, largest_sum(i * ratio_step, at_border));
            factors_[at_border].push_back(largest);
          }
      }
  }

  double CarriedArea::largest_sum(const double ratio, const bool at_border) const
  {
    // As the hat moves, the sum is piecewise linear and highest where its peak lies on a point.
    // At a border the weights fade within a strip: a point lies somewhere in it, or at its end.
    constexpr unsigned int n_places = 16;
    const double           strip    = at_border ? edge_fading_ : 0.;
    const int              reach    = static_cast<int>(std::ceil(1. / ratio)) + 2;
    double                 largest  = 0.;
    for (const double first : points_)
      for (unsigned int place = 0; place <= (strip > 0. ? n_places : 0); ++place)
        {
          double sum = 0.;
          for (int cell = -reach; cell <= reach; ++cell)
            for (std::size_t j = 0; j < points_.size(); ++j)
              {
                const double x = ratio * (cell + points_[j] - first) + strip * place / n_places;
                if (at_border && x < -1e-12)
                  continue;
                const double t = strip > 0. ? std::min(1., x / strip) : 1.;
                sum += weights_[j] * t * t * (3. - 2. * t) * std::max(0., 1. - std::abs(x));
              }
          largest = std::max(largest, ratio * sum);
        }
    // Over the mean: the area under the hat, or half of it.
    return at_border ? 2. * largest : largest;
  }

  double CarriedArea::factor(const double ratio, const bool at_border) const
  {
    // Rounded up to the table. Beyond it: sum/ratio falls, as the hat becomes narrower.
    const std::vector<double> &factors = factors_[at_border];
    const double               place   = std::ceil(ratio / ratio_step - 1e-9);
    if (place > n_ratios)
      return factors.back() * ratio / (n_ratios * ratio_step);
    return factors[static_cast<std::size_t>(std::max(1., place)) - 1];
  }

  std::vector<double> CarriedArea::bound(const SurfaceGeometry &slave,
                                         const SurfaceGeometry &master,
                                         const FacetDirections &directions) const
  {
    // 1. Around each of the master's nodes: least lengths of the facets, and where it lies.
    struct Place
    {
      FacetSides   least     = {std::numeric_limits<double>::infinity(),
                                std::numeric_limits<double>::infinity()};
      unsigned int n_facets  = 0;
      bool         at_border = false;
    };
    std::vector<Place> places(master.n_nodes());
    for (unsigned int f = 0; f < master.n_facets(); ++f)
      {
        const FacetSides s = sides(master, f);
        for (unsigned int k = 0; k < 4; ++k)
          {
            Place &place = places[master.corners(f)[k]];
            place.least  = {std::min(place.least.longer, s.longer),
                            std::min(place.least.shorter, s.shorter)};
            ++place.n_facets;
            // Side k runs from corner k to the next one.
            const unsigned int sides_of_corner = (1u << k) | (1u << ((k + 3) % 4));
            place.at_border = place.at_border || (master.border_sides(f) & sides_of_corner) != 0;
          }
      }
    // 2. The slave's facet that brings most, its longer side along that of the master or across.
    const std::vector<FacetSides> slave_sides = longest_sides(slave);
    std::vector<double>           areas       = master.node_areas();
    for (unsigned int i = 0; i < master.n_nodes(); ++i)
      {
        const Place &place   = places[i];
        const bool   corner  = place.at_border && place.n_facets == 1;
        double       largest = 1.;
        for (const FacetSides &s : slave_sides)
          for (const bool across : {false, true})
            for (const bool longer_ends : {false, true})
              {
                if (!(across ? directions.across : directions.along))
                  continue;
                // A border ends one of the directions, a corner both.
                const double along_longer  = (across ? s.shorter : s.longer) / place.least.longer,
                             along_shorter = (across ? s.longer : s.shorter) / place.least.shorter;
                largest =
                  std::max(largest,
                           factor(along_longer, corner || (place.at_border && longer_ends)) *
                             factor(along_shorter, corner || (place.at_border && !longer_ends)));
              }
        areas[i] *= largest;
      }
    return areas;
  }
} // namespace vfife
