// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include "standing_derivative.h"

#include <vfife/model/body_frame.h>

namespace vfife
{
  std::vector<double> apply_standing_derivative(const FemSpace &space, const std::vector<double> &u)
  {
    std::vector<double> result(u.size(), 0.);
    for (const FemSpace::Part &part : space.parts())
      {
        const Body          &body      = space.model().bodies[part.body];
        const BodyStructure &structure = body.structure();
        // Two sectors on either side have to be different ones, and turn into each other; of
        // quadratic elements' points only nodes are numbered by sectors.
        if (structure.n_sectors() < 5 || part.n_points != body.n_nodes() ||
            !turns_about_sector_axis(body))
          continue;
        // Sectors follow each other in the sense of their own axis, spin has that of the body's.
        const Vector3 axis = compute_sector_axis(body).direction;
        const double  rate = body.rate * body.axis.direction.dot(axis), angle = structure.pitch();
        // The displacement "away" sectors further on, turned back into this sector.
        const auto seen = [&](const unsigned int node, const int away) {
          const std::size_t point = part.first_point + structure.copy(node, away);
          return Vector3(rotation_about(axis, -away * angle) *
                         Eigen::Map<const Vector3>(u.data() + 3 * point));
        };
        // f' = (8 (f_1 - f_-1) - (f_2 - f_-2)) / 12 per sector
        for (unsigned int node = 0; node < body.n_nodes(); ++node)
          Eigen::Map<Vector3>(result.data() + 3 * std::size_t(part.first_point + node)) =
            rate / (12 * angle) *
            (8 * (seen(node, 1) - seen(node, -1)) - (seen(node, 2) - seen(node, -2)));
      }
    return result;
  }
} // namespace vfife
