// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/process/communicator.h>
#include <vfife/dynamics/motion/mean_speed.h>
#include <vfife/model/body.h>
#include <vfife/model/state.h>

#include <cmath>

namespace vfife
{
  RigidVelocity compute_mean_speed_rate(const Body         &body,
                                        const State        &state,
                                        const unsigned int  b,
                                        const Communicator &communicator)
  {
    // Eq. (8) of the paper: omega = sum m |v|/r / sum m; nodes on the axis have no rate.
    std::vector<double> sums(2, 0.);
    for (const std::uint32_t i : state.partition->owned_nodes(b))
      {
        const double square =
          body.axis.direction.cross(state.node_position(i) - body.axis.point).squaredNorm();
        if (!(square > 0))
          continue;
        const double mass = body.node_masses()[state.partition->global_node[i] - body.first_node];
        sums[0] += mass * std::sqrt(state.node_velocity(i).squaredNorm() / square);
        sums[1] += mass;
      }
    communicator.sum(sums);

    RigidVelocity rate;
    // A mean of speeds has no sign: it turns as the body did at the start. As a field u(x) =
    // velocity + omega x x with the axis at rest.
    rate.omega    = (body.rate < 0 ? -1. : 1.) * sums[0] / sums[1] * body.axis.direction;
    rate.velocity = -rate.omega.cross(body.axis.point);
    return rate;
  }
} // namespace vfife
