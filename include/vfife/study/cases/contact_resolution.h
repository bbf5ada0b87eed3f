// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_study_cases_contact_resolution_h
#define vfife_study_cases_contact_resolution_h

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
    double facet   = 0; ///< mean length of the shorter sides of the slave's facets
    double spacing = 0; ///< of the points of a facet

    ContactResolution(const Model &model, const ContactPair &pair, double width);

    /** Fewer than two points across the contact are single forces. */
    bool has_single_points() const
    {
      return spacing > 0.5 * width;
    }

    /** The distance of the points over the width of the contact, in words: @p contact is "Hertz's
     * contact" or the like. */
    std::string describe_points(const std::string &contact) const;
  };

  /** Area of a surface's undeformed facets [mm^2]. */
  double compute_area(const FacetSurface &surface);

  /** Warns of entries of the contact that are read and not used, once. */
  void warn_of_unused_entries(const Model &model, Log &log);
} // namespace vfife

#endif
