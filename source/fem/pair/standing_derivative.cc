// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include "standing_derivative.h"

#include <vfife/mesh/body_mesh.h>
#include <vfife/model/body_frame.h>

namespace vfife
{
  std::vector<double> apply_standing_derivative(const Discretization      &discretization,
                                                const std::vector<double> &u)
  {
    std::vector<double> result(u.size(), 0.);
    for (const Discretization::Part &part : discretization.parts())
      {
        const Body        &body = discretization.model().bodies[part.body];
        const unsigned int n    = body.mesh().n_sectors;
        // Two sectors on either side have to be different ones, and turn into each other.
        if (n < 5 || part.n_points % n != 0 || !turns_about_sector_axis(body))
          continue;
        // Sectors follow each other in the sense of their own axis, spin has that of the body's.
        const Vector3      axis       = compute_sector_axis(body).direction;
        const double       rate       = body.rate * body.axis.direction.dot(axis);
        const unsigned int per_sector = part.n_points / n;
        const double       angle      = 2 * pi / n;
        // What lies "away" sectors further along, its vector turned back into this sector.
        const auto seen = [&](const unsigned int k, const unsigned int i, const int away) {
          const unsigned int sector = (k + n + away) % n;
          const std::size_t  point  = part.first_point + std::size_t(sector) * per_sector + i;
          return Vector3(rotation_about(axis, -away * angle) *
                         Eigen::Map<const Vector3>(u.data() + 3 * point));
        };
        // f' = (8 (f_1 - f_-1) - (f_2 - f_-2)) / 12 per sector
        for (unsigned int k = 0; k < n; ++k)
          for (unsigned int i = 0; i < per_sector; ++i)
            Eigen::Map<Vector3>(result.data() +
                                3 * (part.first_point + std::size_t(k) * per_sector + i)) =
              rate / (12 * angle) *
              (8 * (seen(k, i, 1) - seen(k, i, -1)) - (seen(k, i, 2) - seen(k, i, -2)));
      }
    return result;
  }
} // namespace vfife
