// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/dynamics/equilibrium/standing_pattern.h>
#include <vfife/mesh/body_mesh.h>
#include <vfife/model/body_frame.h>

#include <array>

namespace vfife
{
  namespace
  {
    /** Sectors used on either side, and the least number of sectors for them to be different. */
    constexpr unsigned int reach = 2, least_sectors = 2 * reach + 1;

    bool has_pattern(const Body &body)
    {
      // Only a body that turns has a pattern, and only equal sectors that the spin turns into each
      // other have equal nodes.
      return body.turns_on_axis && body.rate != 0. &&
             body.structure().n_sectors() >= least_sectors && turns_about_sector_axis(body);
    }
  } // namespace

  StandingPattern::StandingPattern(const Model &model, const Communicator &communicator)
    : model_(model)
    , communicator_(communicator)
  {
  }

  void StandingPattern::update(const State &state)
  {
    nodes_.clear();
    const Partition &partition = *state.partition;
    for (unsigned int b = 0; b < model_.bodies.size(); ++b)
      {
        const Body &body = model_.bodies[b];
        if (!has_pattern(body))
          continue;
        // 1. Neighbouring sectors may be on other ranks: everybody gets the whole body, once.
        std::vector<double> positions(3 * static_cast<std::size_t>(body.n_nodes()), 0.);
        for (const std::uint32_t i : partition.owned_nodes(b))
          Eigen::Map<Vector3>(positions.data() + 3 * (partition.global_node[i] - body.first_node)) =
            state.node_position(i) - body.axis.point;
        communicator_.sum(positions);

        // 2. What turns a sector's neighbours onto it.
        const Vector3                      axis  = compute_sector_axis(body).direction;
        const double                       rate  = body.rate * body.axis.direction.dot(axis);
        const double                       angle = body.structure().pitch();
        std::array<Matrix3, 2 * reach + 1> back;
        for (unsigned int s = 0; s < back.size(); ++s)
          back[s] = rotation_about(axis, -angle * (static_cast<double>(s) - reach));

        for (const std::uint32_t i : partition.nodes(b))
          {
            const unsigned int node = partition.global_node[i] - body.first_node;
            // 3. The images of this node in the sectors around, turned back onto this one: they
            // differ by the change of the displacement only.
            std::array<Vector3, 2 * reach + 1> y;
            for (unsigned int s = 0; s < y.size(); ++s)
              {
                const std::size_t image =
                  body.structure().copy(node, static_cast<int>(s) - static_cast<int>(reach));
                y[s] = back[s] * Eigen::Map<const Vector3>(positions.data() + 3 * image);
              }
            // 4. u' and u'' by central differences of fourth order; v = Omega u' and
            // a = Omega^2 (u'' + 2 e x u').
            const Vector3 slope = (8. * (y[3] - y[1]) - (y[4] - y[0])) / (12. * angle);
            const Vector3 curvature =
              (16. * (y[3] + y[1]) - (y[4] + y[0]) - 30. * y[2]) / (12. * angle * angle);
            nodes_.push_back({i, rate * slope, rate * rate * (curvature + 2. * axis.cross(slope))});
          }
      }
  }

  void StandingPattern::add_turn(const State       &state,
                                 const unsigned int b,
                                 const double       rate,
                                 const double       torque)
  {
    const Body                &body      = model_.bodies[b];
    const std::vector<double> &mass      = body.node_masses();
    const Partition           &partition = *state.partition;
    const auto                 arm       = [&](const std::uint32_t i) {
      return Vector3(body.axis.direction.cross(state.node_position(i) - body.axis.point));
    };
    double inertia = 0;
    for (const std::uint32_t i : partition.owned_nodes(b))
      inertia += mass[partition.global_node[i] - body.first_node] * arm(i).squaredNorm();
    const double acceleration = torque / communicator_.sum(inertia);
    for (const std::uint32_t i : partition.nodes(b))
      nodes_.push_back({i, rate * arm(i), acceleration * arm(i)});
  }

  void StandingPattern::add_forces(const std::vector<double> &masses, NodeField &forces) const
  {
    for (const Node &node : nodes_)
      forces.add(node.local, -masses[node.local] * node.acceleration);
  }

  void StandingPattern::add_velocities(NodeField &velocities) const
  {
    for (const Node &node : nodes_)
      velocities.add(node.local, node.velocity);
  }
} // namespace vfife
