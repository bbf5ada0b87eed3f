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
    /** Of the approach over the square of the facets' width over the contact's half-width, and over
     * that ratio (doc/theory/contact.md, General models). */
    constexpr double flat_error = .32, patch_error = .1;
    /** Of the approach over that ratio: of the springs alone. */
    constexpr double spring_error = .1;
    /** Of the approach of a flat punch, at most: coarse meshes are too stiff at its edges, springs
     * too soft. */
    constexpr double punch_error = .055;
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

  ContactResolution::ContactResolution(const ContactPair &pair,
                                       const double       contact_width,
                                       const double       facet_width)
    : width(contact_width)
    , facet(facet_width)
    , spacing(facet / pair.options.points_per_facet.number)
  {
  }

  double ContactResolution::find_approach_error(const ContactSurfaceKind surface) const
  {
    // Facets over the half-width. Flat facets stand off the true surface by the square of their
    // width; patches miss the pressure where they are wider than the contact's half.
    const double ratio = facet / (.5 * width);
    if (surface == ContactSurfaceKind::flat_facets)
      return std::max(flat_error * ratio * ratio, spring_error * ratio);
    return ratio > 1. ? patch_error * ratio : 0.;
  }

  double ContactResolution::find_punch_error() const
  {
    return std::min(punch_error, spring_error * facet / (.5 * width));
  }

  std::string ContactResolution::describe_error(const std::string &contact,
                                                const double       error,
                                                const std::string &remedy) const
  {
    std::ostringstream text;
    set_figure_digits(text, 2);
    text << contact << " is " << width << " mm wide, the facets of its slave surface " << facet
         << " mm: the error of its approach is up to " << 100. * error
         << " %. Refine the facets to " << remedy;
    return text.str();
  }

  std::string ContactResolution::describe_points(const std::string &contact) const
  {
    std::ostringstream text;
    set_figure_digits(text, 4);
    text << "contact points lie " << spacing << " mm apart, " << contact << " is " << width
         << " mm wide: pressures at points are inaccurate and the force oscillates with the points";
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
} // namespace vfife
