// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/dynamics/loop/start_state.h>
#include <vfife/dynamics/operator/vfife_operator.h>
#include <vfife/model/model.h>
#include <vfife/model/state.h>

namespace vfife
{
  void
  start_undeformed(const Model &model, const VfifeOperator &vfife, const double dt, State &state)
  {
    const Partition &partition = vfife.partition();
    state.partition            = std::make_shared<const Partition>(partition);
    state.time                 = 0;
    state.step                 = 0;
    state.dt                   = dt;
    state.position             = vfife.make_field();
    state.velocity             = vfife.make_field();
    state.body_motion.clear();
    for (unsigned int b = 0; b < model.bodies.size(); ++b)
      {
        const Body &body = model.bodies[b];
        state.body_motion.push_back(body.placement);
        for (const std::uint32_t i : partition.nodes(b))
          {
            const Vector3 &X = body.node_positions()[partition.global_node[i] - body.first_node];
            state.position.set(i, body.placement(X));
            state.position.set_number(i, 1. / vfife.masses()[i]);
            state.velocity.set_number(i, vfife.masses()[i]);
          }
      }
    set_initial_velocities(model, dt, state);
  }

  void set_initial_velocities(const Model &model, const double dt, State &state)
  {
    const Partition &partition = *state.partition;
    for (unsigned int b = 0; b < model.bodies.size(); ++b)
      {
        const Body   &body = model.bodies[b];
        const Matrix3 back = rotation_about(body.axis.direction, -body.rate * dt);
        for (const std::uint32_t i : partition.nodes(b))
          {
            // The chord of the step before time zero: central differences then start without an
            // error of first order.
            const Vector3 r = state.node_position(i) - body.axis.point;
            state.velocity.set(i, body.velocity + (r - back * r) / dt);
            if (!body.initial_velocity.empty())
              state.velocity.add(i,
                                 body.initial_velocity[partition.global_node[i] - body.first_node]);
          }
      }
  }
} // namespace vfife
