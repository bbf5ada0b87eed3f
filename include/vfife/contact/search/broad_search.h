// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_contact_search_broad_search_h
#define vfife_contact_search_broad_search_h

#include <vfife/contact/surface/surface_geometry.h>

#include <memory>
#include <utility>
#include <vector>

namespace vfife
{
  /** Axis-parallel box [mm]. */
  struct Box
  {
    Vector3 low, high;

    /** Box around some points, grown by @p margin on all sides. */
    template <typename Points>
    static Box around(const Points &points, const double margin)
    {
      Box box = {points[0], points[0]};
      for (const Vector3 &p : points)
        {
          box.low  = box.low.cwiseMin(p);
          box.high = box.high.cwiseMax(p);
        }
      box.low.array() -= margin;
      box.high.array() += margin;
      return box;
    }

    /** Square of the distance to a point, 0 inside [mm^2]. */
    double square_distance(const Vector3 &x) const
    {
      return (low - x).cwiseMax(x - high).cwiseMax(Vector3::Zero()).squaredNorm();
    }
  };

  /** An R-tree of boxes. */
  class BoxTree
  {
  public:
    explicit BoxTree(const std::vector<Box> &boxes);
    ~BoxTree();
    BoxTree(BoxTree &&) noexcept;

    /** Numbers of the boxes that overlap @p box, sorted, replacing what @p found holds. */
    void find(const Box &box, std::vector<unsigned int> &found) const;

    bool overlaps(const Box &box) const;

  private:
    struct Tree;
    std::unique_ptr<Tree> tree_;
  };

  /** Which groups (teeth) of two surfaces come near each other under the rigid motions of their
   * bodies. */
  class BroadSearch
  {
  public:
    BroadSearch(const SurfaceGeometry &slave, const SurfaceGeometry &master);

    /**
     * Pairs (slave group, master group), sorted, of which some facets' undeformed boxes come nearer
     * than @p margin [mm] on the way from one place to another. Motions take the slave's undeformed
     * frame into the master's. The margin must cover the deformation.
     */
    std::vector<std::pair<unsigned int, unsigned int>>
    find_pairs(const RigidMotion &from, const RigidMotion &to, double margin) const;

  private:
    struct Sphere
    {
      Vector3 centre;
      double  radius;
    };
    static std::vector<Sphere> group_spheres(const SurfaceGeometry &surface);

    bool facets_near(unsigned int       slave_group,
                     unsigned int       master_group,
                     const RigidMotion &slave_to_master,
                     double             margin) const;

    std::vector<std::vector<std::array<Vector3, 4>>>
                                     slave_facets_; ///< corners, by group, body frame
    std::vector<std::vector<Sphere>> slave_facet_spheres_;
    std::vector<Sphere>              slave_spheres_, master_spheres_;
    std::vector<Box>                 master_boxes_; ///< of groups, body frame
    std::vector<BoxTree>             master_trees_;
  };
} // namespace vfife

#endif
