// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_contact_pass_slave_points_h
#define vfife_contact_pass_slave_points_h

#include <vfife/contact/law/contact_options.h>
#include <vfife/contact/search/carried_area.h>
#include <vfife/contact/surface/facet_quadrature.h>
#include <vfife/contact/surface/surface_geometry.h>

#include <vector>

namespace vfife
{
  /** A slave surface with the quadrature points of its facets: their areas, offsets and stiffness.
   * Facet and place in the rule of a facet name a point. */
  class SlavePoints
  {
  public:
    /** @p area_factor scales all areas (one half for each of two passes). Throws InputError as
     * SurfaceGeometry does. */
    SlavePoints(const FacetSurface &slave, const ContactOptions &options, double area_factor);

    const SurfaceGeometry &surface() const
    {
      return surface_;
    }
    /** See SurfaceGeometry::bind. */
    void bind(const SurfaceMotion &motion)
    {
      surface_.bind(motion);
    }

    /** Points of a facet. */
    const std::vector<FacetQuadraturePoint> &rule() const
    {
      return rule_;
    }
    /** Number of a point among those of all facets. */
    std::size_t number(const unsigned int facet, const unsigned int rule_point) const
    {
      return static_cast<std::size_t>(facet) * rule_.size() + rule_point;
    }

    /** Current position on the facet [mm], undeformed area [mm^2], offset of the true surface [mm].
     */
    Vector3 position(const unsigned int facet, const unsigned int rule_point) const
    {
      const auto &k = surface_.corners(facet);
      const auto &N = rule_[rule_point].shape;
      return N[0] * surface_.node(k[0]) + N[1] * surface_.node(k[1]) + N[2] * surface_.node(k[2]) +
             N[3] * surface_.node(k[3]);
    }
    double area(const unsigned int facet, const unsigned int rule_point) const
    {
      return areas_[number(facet, rule_point)];
    }
    double offset(const unsigned int facet, const unsigned int rule_point) const
    {
      return offsets_[number(facet, rule_point)];
    }

    /** Penalty at a point over the contact's [-]; 1 at first. */
    double stiffness(const unsigned int facet, const unsigned int rule_point) const
    {
      return stiffness_[number(facet, rule_point)];
    }
    double largest_stiffness(unsigned int facet) const;
    /** Makes the stiffness proportional to 1/h, h the width of a facet; 1 at @p least_width [mm].
     */
    void vary_stiffness(double least_width);
    /** Sets one stiffness per point of a group, the same for all groups. Throws InputError on
     * another number of values. */
    void set_stiffness(const std::vector<double> &of_group_points);

    /** Area of points that a node carries at most [mm^2] (CarriedArea): a node of this surface, and
     * one of @p master, whose points fade over the part @p edge_fading of a border facet. */
    std::vector<double> carried_areas() const;
    std::vector<double> carried_areas_on(const SurfaceGeometry &master,
                                         double                 edge_fading,
                                         const FacetDirections &directions) const;

  private:
    SurfaceGeometry                   surface_;
    std::vector<FacetQuadraturePoint> rule_;
    double                            area_factor_;
    std::vector<double>               areas_, offsets_, stiffness_; ///< by number()
  };
} // namespace vfife

#endif
