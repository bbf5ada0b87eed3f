// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/fem/modes/cyclic_copies.h>

#include <deal.II/base/point.h>
#include <deal.II/numerics/rtree.h>

#include <algorithm>
#include <cmath>

namespace vfife
{
  namespace
  {
    constexpr double       tolerance = 1e-6; ///< of the largest distance from the origin
    constexpr unsigned int none      = -1;

    dealii::Point<3> point_of(const Vector3 &x)
    {
      return {x[0], x[1], x[2]};
    }

    /** Points by their places. */
    class PointFinder
    {
    public:
      explicit PointFinder(const std::vector<Vector3> &points)
      {
        std::vector<Entry> entries;
        for (unsigned int i = 0; i < points.size(); ++i)
          {
            entries.emplace_back(point_of(points[i]), i);
            size_ = std::max(size_, points[i].norm());
          }
        tree_ = dealii::pack_rtree(entries);
      }

      double size() const
      {
        return size_;
      }

      /** The point at @p x, or `none`. */
      unsigned int find(const Vector3 &x) const
      {
        std::vector<Entry> nearest;
        tree_.query(boost::geometry::index::nearest(point_of(x), 1), std::back_inserter(nearest));
        return !nearest.empty() && nearest[0].first.distance(point_of(x)) <= tolerance * size_
                 ? nearest[0].second
                 : none;
      }

    private:
      using Entry = std::pair<dealii::Point<3>, unsigned int>;
      dealii::RTree<Entry> tree_;
      double               size_ = 0;
    };

    /** Where each point goes by the part 1/n of a revolution; empty unless each meets one. */
    std::vector<unsigned int> find_next(const std::vector<Vector3> &points,
                                        const Vector3              &axis,
                                        const unsigned int          n,
                                        const PointFinder          &finder)
    {
      const Matrix3             turn = rotation_about(axis, 2. * pi / n);
      std::vector<unsigned int> next;
      for (const Vector3 &x : points)
        {
          next.push_back(finder.find(turn * x));
          if (next.back() == none)
            return {};
        }
      return next;
    }
  } // namespace

  CyclicCopies find_cyclic_copies(const std::vector<Vector3> &points, const Vector3 &axis)
  {
    const PointFinder finder(points);
    const double      near   = tolerance * finder.size();
    const auto        radius = [&](const Vector3 &x) { return (x - axis.dot(x) * axis).norm(); };

    // 1. N divides the number of points on the circle of any point beside the axis.
    const auto beside = std::find_if(points.begin(), points.end(), [&](const Vector3 &x) {
      return radius(x) > near;
    });
    if (beside == points.end())
      return {};
    const auto on_circle =
      static_cast<unsigned int>(std::count_if(points.begin(), points.end(), [&](const Vector3 &x) {
        return std::abs(radius(x) - radius(*beside)) <= near &&
               std::abs(axis.dot(x - *beside)) <= near;
      }));

    // 2. The largest divisor for which all points have a copy.
    CyclicCopies              copies;
    std::vector<unsigned int> next;
    for (unsigned int n = on_circle; n >= 3 && next.empty(); --n)
      if (on_circle % n == 0)
        {
          next             = find_next(points, axis, n, finder);
          copies.n_sectors = n;
        }
    if (next.empty())
      return {};

    // 3. A first sector: one point of each orbit, in their order; then its copies, one turn each.
    std::vector<bool>         taken(points.size(), false);
    std::vector<unsigned int> sector;
    for (unsigned int i = 0; i < points.size(); ++i)
      if (!taken[i] && radius(points[i]) > near)
        {
          sector.push_back(i);
          for (unsigned int k = 0, j = i; k < copies.n_sectors; ++k, j = next[j])
            taken[j] = true;
        }
    for (unsigned int k = 0; k < copies.n_sectors; ++k)
      {
        copies.points.insert(copies.points.end(), sector.begin(), sector.end());
        for (unsigned int &i : sector)
          i = next[i];
      }
    return copies;
  }
} // namespace vfife
