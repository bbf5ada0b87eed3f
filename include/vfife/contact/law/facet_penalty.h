// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_contact_law_facet_penalty_h
#define vfife_contact_law_facet_penalty_h

namespace vfife
{
  /** The penalty of contacts of general models is this times E* over h, E* the modulus of what
   * gives way and h the width of the facet that is pressed (doc/theory/contact.md, Penalty). */
  constexpr double facet_penalty_over_stiffness = 5.;

  /** eps [N/mm^3] of a facet of the @p width [mm] where E* is @p modulus [MPa]. */
  inline double compute_facet_penalty(const double modulus, const double width)
  {
    return facet_penalty_over_stiffness * modulus / width;
  }
} // namespace vfife

#endif
