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
      // Sums in variables of their own stay in registers: the loop then waits for memory alone.
      Vector3 momentum = Eigen::Map<Vector3>(all), angular = Eigen::Map<Vector3>(all + 3),
              change      = Vector3::Zero();
      double        speed = 0., turning_mass = 0., mass = 0., square_of_change = 0.;
      const Vector3 axis = body.axis.direction, point = body.axis.point;
      const bool    turns = body.turns_on_axis;
      for (const std::uint32_t i : nodes)
        {
          const double  m = masses[i];
          const Vector3 x = state.node_position(i), v = state.node_velocity(i);
          const Vector3 of_node = m * v;
          momentum += of_node;
          angular += x.cross(of_node);

          const double square = turns ? axis.cross(x - point).squaredNorm() : 0.;
          if (square > 0)
            {
              speed += m * std::sqrt(v.squaredNorm() / square);
              turning_mass += m;
            }
          const Vector3 to_next = next.value(i) - v;
          mass += m;
          change += m * to_next;
          square_of_change += m * to_next.squaredNorm();
        }
      Eigen::Map<Vector3>{all}     = momentum;
      Eigen::Map<Vector3>{all + 3} = angular;
      own[0]                       = speed;
      own[1]                       = turning_mass;
      own[2]                       = mass;
      Eigen::Map<Vector3>{own + 3} = change;
      own[6]                       = square_of_change;
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
