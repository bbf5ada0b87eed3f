// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/contact/search/broad_search.h>

// Boost 1.74 prints a note about a header of its own otherwise.
#define BOOST_ALLOW_DEPRECATED_HEADERS
#include <boost/geometry/geometries/box.hpp>
#include <boost/geometry/geometries/point.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <boost/geometry/strategies/strategies.hpp>
#include <boost/iterator/function_output_iterator.hpp>

#include <algorithm>

namespace vfife
{
  namespace bg = boost::geometry;

  namespace
  {
    using TreePoint = bg::model::point<double, 3, bg::cs::cartesian>;
    using TreeBox   = bg::model::box<TreePoint>;
    using TreeValue = std::pair<TreeBox, unsigned int>;

    TreeBox tree_box(const Box &box)
    {
      return {TreePoint(box.low[0], box.low[1], box.low[2]),
              TreePoint(box.high[0], box.high[1], box.high[2])};
    }

    std::vector<TreeValue> tree_values(const std::vector<Box> &boxes)
    {
      std::vector<TreeValue> values;
      values.reserve(boxes.size());
      for (const Box &box : boxes)
        values.emplace_back(tree_box(box), static_cast<unsigned int>(values.size()));
      return values;
    }

    /** Sphere around the corners' box. */
    template <typename Sphere, typename Points>
    Sphere sphere_around(const Points &corners)
    {
      const Box box    = Box::around(corners, 0.);
      Sphere    sphere = {0.5 * (box.low + box.high), 0.};
      for (const Vector3 &x : corners)
        sphere.radius = std::max(sphere.radius, (x - sphere.centre).norm());
      return sphere;
    }

    std::array<Vector3, 4> reference_corners(const SurfaceGeometry &surface,
                                             const unsigned int     facet)
    {
      const auto &k = surface.corners(facet);
      return {{surface.reference(k[0]),
               surface.reference(k[1]),
               surface.reference(k[2]),
               surface.reference(k[3])}};
    }
  } // namespace

  struct BoxTree::Tree
  {
    explicit Tree(const std::vector<TreeValue> &values)
      : rtree(values)
    {
    }

    bg::index::rtree<TreeValue, bg::index::linear<16>> rtree;
  };

  BoxTree::BoxTree(const std::vector<Box> &boxes)
    : tree_(std::make_unique<Tree>(tree_values(boxes)))
  {
  }

  BoxTree::~BoxTree() = default;

  BoxTree::BoxTree(BoxTree &&) noexcept = default;

  void BoxTree::find(const Box &box, std::vector<unsigned int> &found) const
  {
    found.clear();
    tree_->rtree.query(bg::index::intersects(tree_box(box)),
                       boost::make_function_output_iterator(
                         [&found](const TreeValue &value) { found.push_back(value.second); }));
    std::sort(found.begin(), found.end());
  }

  bool BoxTree::overlaps(const Box &box) const
  {
    const auto &rtree = tree_->rtree;
    return rtree.qbegin(bg::index::intersects(tree_box(box))) != rtree.qend();
  }

  BroadSearch::BroadSearch(const SurfaceGeometry &slave, const SurfaceGeometry &master)
    : slave_spheres_(group_spheres(slave))
    , master_spheres_(group_spheres(master))
  {
    // The slave's facets with their spheres, by group; the master's as a tree and a box each group.
    slave_facets_.resize(slave.n_groups());
    slave_facet_spheres_.resize(slave.n_groups());
    for (unsigned int g = 0; g < slave.n_groups(); ++g)
      for (const unsigned int f : slave.group_facets(g))
        {
          slave_facets_[g].push_back(reference_corners(slave, f));
          slave_facet_spheres_[g].push_back(sphere_around<Sphere>(slave_facets_[g].back()));
        }
    for (unsigned int g = 0; g < master.n_groups(); ++g)
      {
        std::vector<Box> boxes;
        for (const unsigned int f : master.group_facets(g))
          boxes.push_back(Box::around(reference_corners(master, f), master.largest_offset()));
        master_trees_.emplace_back(boxes);
        Box all = boxes.empty() ? Box{Vector3::Zero(), Vector3::Zero()} : boxes.front();
        for (const Box &box : boxes)
          all = {all.low.cwiseMin(box.low), all.high.cwiseMax(box.high)};
        master_boxes_.push_back(all);
      }
  }

  std::vector<BroadSearch::Sphere> BroadSearch::group_spheres(const SurfaceGeometry &surface)
  {
    std::vector<Sphere> spheres(surface.n_groups(), {Vector3::Zero(), -1.});
    for (unsigned int g = 0; g < surface.n_groups(); ++g)
      {
        std::vector<Vector3> corners;
        for (const unsigned int f : surface.group_facets(g))
          for (const unsigned int n : surface.corners(f))
            corners.push_back(surface.reference(n));
        if (!corners.empty())
          spheres[g] = sphere_around<Sphere>(corners);
      }
    return spheres;
  }

  std::vector<std::pair<unsigned int, unsigned int>>
  BroadSearch::find_pairs(const RigidMotion &from, const RigidMotion &to, const double margin) const
  {
    // A point at r from a group's centre goes no farther than the centre and the turn times r.
    const double                                       turn = (to.rotation - from.rotation).norm();
    std::vector<std::pair<unsigned int, unsigned int>> pairs;
    for (unsigned int s = 0; s < slave_spheres_.size(); ++s)
      {
        if (slave_spheres_[s].radius < 0.)
          continue; // no facets in this group
        const Vector3 centre = from(slave_spheres_[s].centre);
        const double  way =
          (to(slave_spheres_[s].centre) - centre).norm() + turn * slave_spheres_[s].radius;
        // Spheres of groups, far cheaper, before any facet is looked at.
        for (unsigned int m = 0; m < master_spheres_.size(); ++m)
          {
            const double reach =
              slave_spheres_[s].radius + master_spheres_[m].radius + margin + way;
            if (master_spheres_[m].radius >= 0. &&
                (centre - master_spheres_[m].centre).squaredNorm() <= reach * reach &&
                facets_near(s, m, from, margin + way))
              pairs.emplace_back(s, m);
          }
      }
    return pairs;
  }

  bool BroadSearch::facets_near(const unsigned int slave_group,
                                const unsigned int master_group,
                                const RigidMotion &slave_to_master,
                                const double       margin) const
  {
    for (std::size_t i = 0; i < slave_facets_[slave_group].size(); ++i)
      {
        // The slave facet's sphere against the box of the master's group, then its own box against
        // the tree of the master's facets.
        const Sphere &sphere = slave_facet_spheres_[slave_group][i];
        if (master_boxes_[master_group].square_distance(slave_to_master(sphere.centre)) >
            (sphere.radius + margin) * (sphere.radius + margin))
          continue;
        std::array<Vector3, 4> moved;
        for (unsigned int k = 0; k < 4; ++k)
          moved[k] = slave_to_master(slave_facets_[slave_group][i][k]);
        if (master_trees_[master_group].overlaps(Box::around(moved, margin)))
          return true;
      }
    return false;
  }
} // namespace vfife
