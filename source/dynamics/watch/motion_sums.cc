// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/process/communicator.h>
#include <vfife/dynamics/watch/motion_sums.h>
#include <vfife/model/model.h>

namespace vfife
{
  MotionSums sum_motion(const Model                    &model,
                        const std::vector<NodalMotion> &motions,
                        const Communicator             &communicator)
  {
    // Momenta of all bodies, then what each body has of its own.
    constexpr std::size_t n_of_all = 6, n_of_body = 7;
    std::vector<double>   sums(n_of_all, 0.);
    for (const NodalMotion &motion : motions)
      {
        Eigen::Map<Vector3>{sums.data()} += motion.momentum;
        Eigen::Map<Vector3>{sums.data() + 3} += motion.angular_momentum;
        sums.insert(sums.end(), {motion.speed, motion.turning_mass, motion.mass});
        sums.insert(sums.end(), motion.change.begin(), motion.change.end());
        sums.push_back(motion.square_of_change);
      }
    communicator.sum(sums);

    MotionSums result;
    result.momentum         = Eigen::Map<const Vector3>(sums.data());
    result.angular_momentum = Eigen::Map<const Vector3>(sums.data() + 3);
    for (std::size_t b = 0; b < motions.size(); ++b)
      {
        const double *own = sums.data() + n_of_all + n_of_body * b;
        result.mean_speeds.push_back(model.bodies[b].turns_on_axis && own[1] > 0 ? own[0] / own[1]
                                                                                 : 0.);
        // Without the mean of the change it is as in axes that go along.
        result.alternating_energy +=
          (own[6] - Eigen::Map<const Vector3>(own + 3).squaredNorm() / own[2]) / 8;
      }
    return result;
  }
} // namespace vfife
