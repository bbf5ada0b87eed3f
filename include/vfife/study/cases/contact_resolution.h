// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_study_cases_contact_resolution_h
#define vfife_study_cases_contact_resolution_h

#include <vfife/contact/law/contact_options.h>

#include <string>

namespace vfife
{
  class Log;
  struct ContactPair;
  struct FacetSurface;
  struct Model;

  /** How finely a mesh sees a contact: its width against facets and points of the slave [mm]. */
  struct ContactResolution
  {
    double width   = 0; ///< of the contact across its narrower way
    double facet   = 0; ///< width of the slave's facets
    double spacing = 0; ///< of the points of a facet

    /** By the mean of all facets of the slave. */
    ContactResolution(const Model &model, const ContactPair &pair, double width);
    /** By facets of a given width. */
    ContactResolution(const ContactPair &pair, double width, double facet_width);

    /** Fewer than two points across the contact are single forces. */
    bool has_single_points() const
    {
      return spacing > 0.5 * width;
    }

    /** The distance of the points over the width of the contact, in words: @p contact is "Hertz's
     * contact" or the like. */
    std::string describe_points(const std::string &contact) const;

    /** Largest error of the approach of two bodies, over it, by facets of this width with the
     * penalty of general models: tests/contact/default_penalty has it for spheres and cylinders. */
    double find_approach_error(ContactSurfaceKind surface) const;
    /** The same of a flat punch, whose width is that of the contact. */
    double find_punch_error() const;

    /** An error in words; @p remedy: the facets that are fine enough. */
    std::string
    describe_error(const std::string &contact, double error, const std::string &remedy) const;
  };

  /** Area of a surface's undeformed facets [mm^2]. */
  double compute_area(const FacetSurface &surface);

} // namespace vfife

#endif
