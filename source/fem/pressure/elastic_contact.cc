// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/fem/pressure/elastic_contact.h>

#include <limits>

namespace vfife
{
  Vector3 FlankFoot::bulge() const
  {
    Vector3 sum = Vector3::Zero();
    for (unsigned int k = 0; k < 4; ++k)
      sum += weights[k] * part->bulges[k];
    return sum;
  }

  FlankFoot ElasticFlank::find(const CellFoot &foot) const
  {
    const std::vector<FlankPart> &of_facet = parts[foot.facet];
    if (of_facet.front().corners == unit_square)
      return {&of_facet.front(), foot.weights};
    // Between curved sides of two facets a foot may lie in no part: the nearest one has it.
    FlankFoot best;
    Vector2   place   = Vector2::Zero();
    double    nearest = std::numeric_limits<double>::infinity();
    for (const FlankPart &part : of_facet)
      {
        Vector2 xi;
        find_in_quadrilateral(part.corners, foot.place, xi);
        const double outside = (xi - xi.cwiseMax(0.).cwiseMin(1.)).norm();
        if (outside < nearest)
          {
            nearest   = outside;
            best.part = &part;
            place     = xi;
          }
      }
    best.weights = bilinear_weights(place[0], place[1]);
    return best;
  }
} // namespace vfife
