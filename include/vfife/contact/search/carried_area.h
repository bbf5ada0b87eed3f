// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_contact_search_carried_area_h
#define vfife_contact_search_carried_area_h

#include <vfife/contact/surface/facet_quadrature.h>
#include <vfife/contact/surface/surface_geometry.h>

#include <array>
#include <vector>

namespace vfife
{
  /** How the longer sides of the facets of two surfaces lie to each other where these are near. */
  struct FacetDirections
  {
    bool along = true, across = true; ///< what is to be reckoned with
  };

  /** From facets that face each other nearer than they are wide, the motion taking the slave's
   * undeformed frame into the master's; both where there are none. */
  FacetDirections find_directions(const SurfaceGeometry &slave,
                                  const SurfaceGeometry &master,
                                  const RigidMotion     &slave_to_master);

  /**
   * The slave's area that the nodes of a master carry at most: sum w A_p N_i over the slave's
   * points p on the facets of node i, w the weight of the edge fading, wherever the slave lies.
   * Each point is a spring of the stiffness eps A_p, so eps times this is the contact stiffness at
   * the node. On the average over all places inside it is the node's own tributary area; where the
   * points lie farther apart than the nodes, a single one brings its whole area to the node that it
   * happens to lie on. Derived in doc/theory/contact.md, Both sides of a spring.
   */
  class CarriedArea
  {
  public:
    /** @p rule: the slave's points on a facet; @p edge_fading: part of a border facet. */
    CarriedArea(const std::vector<FacetQuadraturePoint> &rule, double edge_fading);

    /**
     * In one direction: the largest sum of w_j s N(x_j) over points with weights w_j in equal cells
     * of the length s, N a hat function with its feet at +-h, over its mean, which is h; or, at a
     * border of the master, over the half of the hat that there is. @p ratio: s/h. At least 1 and
     * never decreasing.
     */
    double factor(double ratio, bool at_border) const;

    /** Bounds of the area [mm^2] on each node of @p master, by the undeformed facets of both. */
    std::vector<double> bound(const SurfaceGeometry &slave,
                              const SurfaceGeometry &master,
                              const FacetDirections &directions) const;

  private:
    double largest_sum(double ratio, bool at_border) const;

    std::vector<double>                points_, weights_; ///< along one direction, on [0, 1]
    double                             edge_fading_;
    std::array<std::vector<double>, 2> factors_; ///< inside, at a border: equal steps of the ratio
  };
} // namespace vfife

#endif
