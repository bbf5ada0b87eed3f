// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/contact/pass/slave_points.h>

#include <algorithm>
#include <string>

namespace vfife
{
  SlavePoints::SlavePoints(const FacetSurface   &slave,
                           const ContactOptions &options,
                           const double          area_factor)
    : surface_(slave, options.surface, EdgeRelief(slave, options))
    , rule_(facet_quadrature(options.discretization, options.points_per_facet.number))
    , area_factor_(area_factor)
  {
    // Undeformed areas, once for all: the energy of the contact then depends on gaps alone. A
    // corner has the integral of its shape function.
    const bool at_corners = options.discretization == ContactDiscretization::nodes;
    for (unsigned int f = 0; f < surface_.n_facets(); ++f)
      for (unsigned int i = 0; i < rule_.size(); ++i)
        {
          const FacetQuadraturePoint &q = rule_[i];
          areas_.push_back(area_factor * (at_corners
                                            ? surface_.corner_areas(f)[i]
                                            : q.weight * surface_.area_element(f, q.xi, q.eta)));
          offsets_.push_back(surface_.offset(f, q.xi, q.eta));
        }
    stiffness_.assign(areas_.size(), 1.);
  }

  double SlavePoints::largest_stiffness(const unsigned int facet) const
  {
    double largest = 0;
    for (unsigned int i = 0; i < rule_.size(); ++i)
      largest = std::max(largest, stiffness(facet, i));
    return largest;
  }

  void SlavePoints::vary_stiffness(const double least_width)
  {
    stiffness_.clear();
    for (unsigned int f = 0; f < surface_.n_facets(); ++f)
      stiffness_.insert(stiffness_.end(), rule_.size(), least_width / surface_.facet_width(f));
  }

  void SlavePoints::set_stiffness(const std::vector<double> &of_group_points)
  {
    for (unsigned int g = 0; g < surface_.n_groups(); ++g)
      {
        const std::vector<unsigned int> &facets = surface_.group_facets(g);
        if (facets.size() * rule_.size() != of_group_points.size())
          throw InputError("stiffness of a contact: expected one value per point of a group (" +
                           std::to_string(facets.size() * rule_.size()) + "), got " +
                           std::to_string(of_group_points.size()));
        for (std::size_t k = 0; k < facets.size(); ++k)
          std::copy_n(of_group_points.begin() + k * rule_.size(),
                      rule_.size(),
                      stiffness_.begin() + number(facets[k], 0));
      }
  }

  std::vector<double> SlavePoints::carried_areas() const
  {
    std::vector<double> areas = surface_.node_areas();
    for (double &area : areas)
      area *= area_factor_;
    return areas;
  }

  std::vector<double> SlavePoints::carried_areas_on(const SurfaceGeometry &master,
                                                    const double           edge_fading,
                                                    const FacetDirections &directions) const
  {
    std::vector<double> areas = CarriedArea(rule_, edge_fading).bound(surface_, master, directions);
    for (double &area : areas)
      area *= area_factor_;
    return areas;
  }
} // namespace vfife
