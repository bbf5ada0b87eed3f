// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/process/communicator.h>
#include <vfife/dynamics/watch/alternating_energy.h>
#include <vfife/model/model.h>

namespace vfife
{
  double compute_alternating_energy(const Model               &model,
                                    const std::vector<double> &masses,
                                    const Partition           &partition,
                                    const NodeField           &before,
                                    const NodeField           &after,
                                    const Communicator        &communicator)
  {
    // Of each body mass, momentum and energy of the change; without its mean it is as in axes that
    // go along.
    constexpr std::size_t n = 5;
    std::vector<double>   sums(n * model.bodies.size(), 0.);
    for (unsigned int b = 0; b < model.bodies.size(); ++b)
      for (const std::uint32_t i : partition.owned_nodes(b))
        {
          const Vector3 change = after.value(i) - before.value(i);
          double       *sum    = sums.data() + n * b;
          sum[0] += masses[i];
          for (unsigned int c = 0; c < 3; ++c)
            sum[1 + c] += masses[i] * change[c];
          sum[4] += masses[i] * change.squaredNorm();
        }
    communicator.sum(sums);
    double energy = 0;
    for (const double *sum = sums.data(); sum != sums.data() + sums.size(); sum += n)
      energy += (sum[4] - Eigen::Map<const Vector3>(sum + 1).squaredNorm() / sum[0]) / 8;
    return energy;
  }
} // namespace vfife
