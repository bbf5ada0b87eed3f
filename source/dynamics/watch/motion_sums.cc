// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/process/communicator.h>
#include <vfife/dynamics/watch/motion_sums.h>
#include <vfife/model/model.h>

#include <cmath>

namespace vfife
{
  namespace
  {
    /** Of one body: mean speed times mass and the mass that has one; mass, momentum and energy of
     * the change of the velocities. */
    constexpr std::size_t n_of_all = 6, n_of_body = 7;

    /** @p all: momentum and angular momentum of all bodies, @p own: what is the body's. */
    void add_body(const Body                &body,
                  const NodeRange           &nodes,
                  const State               &state,
                  const NodeField           &next,
                  const std::vector<double> &masses,
                  double                    *all,
                  double                    *own)
    {
      for (const std::uint32_t i : nodes)
        {
          const double  mass     = masses[i];
          const Vector3 x        = state.node_position(i);
          const Vector3 v        = state.node_velocity(i);
          const Vector3 momentum = mass * v;
          Eigen::Map<Vector3>(all) += momentum;
          Eigen::Map<Vector3>(all + 3) += x.cross(momentum);

          const double square =
            body.turns_on_axis ? body.axis.direction.cross(x - body.axis.point).squaredNorm() : 0.;
          if (square > 0)
            {
              own[0] += mass * std::sqrt(v.squaredNorm() / square);
              own[1] += mass;
            }
          const Vector3 change = next.value(i) - v;
          own[2] += mass;
          for (unsigned int c = 0; c < 3; ++c)
            own[3 + c] += mass * change[c];
          own[6] += mass * change.squaredNorm();
        }
    }
  } // namespace

  MotionSums sum_motion(const Model               &model,
                        const State               &state,
                        const NodeField           &next,
                        const std::vector<double> &masses,
                        const Communicator        &communicator)
  {
    std::vector<double> sums(n_of_all + n_of_body * model.bodies.size(), 0.);
    for (unsigned int b = 0; b < model.bodies.size(); ++b)
      add_body(model.bodies[b],
               state.partition->owned_nodes(b),
               state,
               next,
               masses,
               sums.data(),
               sums.data() + n_of_all + n_of_body * b);
    communicator.sum(sums);

    MotionSums motion;
    motion.momentum         = Eigen::Map<const Vector3>(sums.data());
    motion.angular_momentum = Eigen::Map<const Vector3>(sums.data() + 3);
    for (const double *own = sums.data() + n_of_all; own != sums.data() + sums.size();
         own += n_of_body)
      {
        motion.mean_speeds.push_back(own[1] > 0 ? own[0] / own[1] : 0.);
        // Without the mean of the change it is as in axes that go along.
        motion.alternating_energy +=
          (own[6] - Eigen::Map<const Vector3>(own + 3).squaredNorm() / own[2]) / 8;
      }
    return motion;
  }
} // namespace vfife
