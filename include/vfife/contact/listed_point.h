// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_contact_listed_point_h
#define vfife_contact_listed_point_h

#include <vfife/contact/search/local_search.h>

namespace vfife
{
  /** A quadrature point of a slave facet that may touch, with its last projection. */
  struct ListedPoint
  {
    unsigned int slave_facet, rule_point;
    Projection   projection;
    double       area;          ///< [mm^2]
    double       slave_offset;  ///< [mm]
    double       gap, pressure; ///< of the last evaluation [mm], [MPa]
  };
} // namespace vfife

#endif
