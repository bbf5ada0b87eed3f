// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/process/log.h>
#include <vfife/base/text/figure_text.h>
#include <vfife/mesh/body_mesh.h>
#include <vfife/model/model.h>
#include <vfife/study/cases/contact_resolution.h>

#include <algorithm>
#include <sstream>

namespace vfife
{
  namespace
  {
    /** Mean length of the shorter sides of a surface's facets [mm]. */
    double compute_facet_width(const FacetSurface &surface)
    {
      double sum = 0;
      for (const auto &facet : surface.facets)
        {
          const auto side = [&](const unsigned int i) {
            return (surface.positions[facet[(i + 1) % 4]] - surface.positions[facet[i]]).norm();
          };
          sum += 0.5 * std::min(side(0) + side(2), side(1) + side(3));
        }
      return sum / surface.facets.size();
    }
  } // namespace

  ContactResolution::ContactResolution(const Model       &model,
                                       const ContactPair &pair,
                                       const double       contact_width)
    : width(contact_width)
    , facet(
        compute_facet_width(model.bodies[pair.slave_body].mesh().surfaces.at(pair.slave_surface)))
    , spacing(facet / pair.options.points_per_facet.number)
  {
  }

  std::string ContactResolution::describe_points(const std::string &contact) const
  {
    std::ostringstream text;
    set_figure_digits(text, 4);
    text << "contact points lie " << spacing << " mm apart, " << contact << " is " << width
         << " mm wide: pressures are those of single points and the force ripples";
    return text.str();
  }

  double compute_area(const FacetSurface &surface)
  {
    double area = 0;
    for (const auto &k : surface.facets)
      area += 0.5 * (surface.positions[k[2]] - surface.positions[k[0]])
                      .cross(surface.positions[k[3]] - surface.positions[k[1]])
                      .norm();
    return area;
  }

  void warn_of_unused_entries(const Model &model, Log &log)
  {
    for (const ContactPair &pair : model.contacts)
      if (pair.options.regularization_velocity > 0)
        {
          log.warning("contact ",
                      pair.side,
                      ": \"regularization velocity\" is no longer used: friction sticks "
                      "elastically (\"tangential stiffness ratio\")");
          return;
        }
  }
} // namespace vfife
