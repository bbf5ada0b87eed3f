// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/fem/pair/pair_equilibrium.h>

namespace vfife
{
  double mean_rotation(const FemSpace                  &space,
                       const unsigned int               body,
                       const std::vector<unsigned int> &nodes,
                       const std::vector<double>       &displacements)
  {
    const Body        &b     = space.model().bodies[body];
    const unsigned int first = space.find_part(body)->first_point;
    double             sum = 0, mass = 0;
    for (const unsigned int node : nodes)
      {
        const Vector3 arm = b.axis.direction.cross(space.points()[first + node] - b.axis.point);
        const Eigen::Map<const Vector3> u(displacements.data() + 3 * std::size_t(first + node));
        // u_theta / r of each node; "arm" is a x (x - c), of length r.
        sum += b.node_masses()[node] * u.dot(arm) / arm.squaredNorm();
        mass += b.node_masses()[node];
      }
    return sum / mass;
  }

  double
  lead_of_driven(const FemSpace &space, const double turn, const std::vector<double> &displacements)
  {
    const Transmission &t = *space.model().transmission;
    const double        driven =
      t.driven_sense * (turn + mean_rotation(space, t.driven, t.driven_bore, displacements));
    // A driver without bore turns as prescribed.
    return t.driver_bore.empty()
             ? driven
             : driven - t.ratio() * t.driver_sense *
                          mean_rotation(space, t.driver, t.driver_bore, displacements);
  }
} // namespace vfife
