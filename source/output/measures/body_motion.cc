// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/process/communicator.h>
#include <vfife/model/body_frame.h>
#include <vfife/model/model.h>
#include <vfife/model/state.h>
#include <vfife/output/measures/body_motion.h>

#include <cmath>

namespace vfife
{
  namespace
  {
    /** Sums over the nodes of a body, r from the axis: now (r) and at time zero (r0). */
    enum Sum
    {
      cross_moment, ///< m a . (r0 x r)
      dot_moment,   ///< m r0 . r
      momentum,     ///< m a . (r x v)
      inertia,      ///< m r . r
      n_sums
    };

    /** From the axis to the point, across the axis [mm]. */
    Vector3 off_axis(const Vector3 &x, const Axis &axis)
    {
      const Vector3 r = x - axis.point;
      return r - r.dot(axis.direction) * axis.direction;
    }

    /**
     * n_sums numbers a body over the nodes that this rank owns; zeros for bodies without bearings.
     */
    std::vector<double> compute_sums(const Model &model, const State &state)
    {
      std::vector<double> sums(n_sums * model.bodies.size(), 0.);
      for (std::size_t b = 0; b < model.bodies.size(); ++b)
        {
          const Body &body = model.bodies[b];
          if (!body.turns_on_axis)
            continue;
          double *sum = &sums[n_sums * b];
          for (const std::uint32_t i : state.partition->owned_nodes(b))
            {
              const unsigned int node = state.partition->global_node[i] - body.first_node;
              const double       m    = body.node_masses()[node];
              const Vector3  r0 = off_axis(body.placement(body.node_positions()[node]), body.axis);
              const Vector3  r  = off_axis(state.node_position(i), body.axis);
              const Vector3 &a  = body.axis.direction;
              sum[cross_moment] += m * a.dot(r0.cross(r));
              sum[dot_moment] += m * r0.dot(r);
              sum[momentum] += m * a.dot(r.cross(state.node_velocity(i)));
              sum[inertia] += m * r.squaredNorm();
            }
        }
      return sums;
    }
  } // namespace

  std::vector<BodyMotion>
  compute_body_motions(const Model &model, const State &state, const Communicator &communicator)
  {
    std::vector<double> sums = compute_sums(model, state);
    communicator.sum(sums);

    std::vector<BodyMotion> motions(model.bodies.size());
    for (std::size_t b = 0; b < model.bodies.size(); ++b)
      {
        const Body &body = model.bodies[b];
        if (!body.turns_on_axis)
          continue;
        const double *sum = &sums[n_sums * b];
        // Without a body_motion the angle that brings r0 nearest to r in the mean over the mass:
        // its tangent is sum m a.(r0 x r) / sum m r0.r.
        motions[b].rotation =
          state.body_motion.size() == model.bodies.size()
            ? compute_turn(body, state.body_motion[b])
            : rotation_about(body.axis.direction, std::atan2(sum[cross_moment], sum[dot_moment]));
        // omega = sum m a . (r x v) / sum m r . r: the rate with the body's own angular momentum
        if (sum[inertia] > 0)
          motions[b].rate = sum[momentum] / sum[inertia] * body.axis.direction;
      }
    return motions;
  }
} // namespace vfife
