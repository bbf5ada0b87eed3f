// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_contact_surface_facet_integrals_h
#define vfife_contact_surface_facet_integrals_h

#include <vfife/base/types.h>

#include <array>

namespace vfife
{
  /**
   * The integrals of the four shape functions times the normal over the bilinear face through four
   * places in turn [mm^2]: what a unit pressure does to its corners. Exact: the vector element of
   * area is linear over the face.
   */
  std::array<Vector3, 4> integrate_normals(const std::array<Vector3, 4> &corners);

  /** The shorter one of the mean lengths of opposite sides [mm]. */
  double facet_width(const std::array<Vector3, 4> &corners);

  /** The integrals of the shape functions over the face [mm^2], those along the side from corner 0
   * to 1 fastest; exact for plane faces. */
  std::array<double, 4> integrate_areas(const std::array<Vector3, 4> &corners);
} // namespace vfife

#endif
