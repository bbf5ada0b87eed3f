// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/fem/system/torque_forces.h>
#include <vfife/model/load_shares.h>

namespace vfife
{
  void add_torque_forces(const Torque               &torque,
                         const Discretization       &discretization,
                         const Discretization::Part &part,
                         const double                value,
                         std::vector<double>        &forces)
  {
    // Corner nodes come first in a body's points, so that their numbers
    // serve for quadratic elements too.
    const Body               &body   = discretization.model().bodies[torque.body];
    const std::vector<double> shares = compute_torque_shares(torque, body);
    // F_i = T A_i t_i / sum_j A_j r_j, the constant traction of explicit dynamics
    // Of a sector its own nodes, which take what they take of the whole torque.
    const unsigned int n_own = part.n_points - discretization.images().size();
    for (std::size_t i = 0; i < torque.nodes.size(); ++i)
      {
        if (torque.nodes[i] >= n_own)
          continue;
        const Vector3 tangent =
          body.axis.direction
            .cross(body.placement(body.node_positions()[torque.nodes[i]]) - body.axis.point)
            .normalized();
        for (unsigned int c = 0; c < 3; ++c)
          forces[3 * std::size_t(part.first_point + torque.nodes[i]) + c] +=
            value * shares[i] * tangent[c];
      }
  }
} // namespace vfife
