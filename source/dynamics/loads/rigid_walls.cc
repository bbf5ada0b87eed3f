// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/process/communicator.h>
#include <vfife/dynamics/loads/rigid_walls.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace vfife
{
  RigidWalls::RigidWalls(const Model        &model,
                         const Partition    &partition,
                         const Communicator &communicator)
    : communicator_(communicator)
  {
    for (const RigidWall &definition : model.walls)
      {
        const Body &body  = model.bodies[definition.body];
        const auto  areas = compute_nodal_areas(body, definition.nodes);
        Wall        wall{
          &definition, std::numeric_limits<double>::infinity(), definition.penalty, 0, 0, 0, {}};
        for (std::size_t i = 0; i < areas.size(); ++i)
          if (areas[i] > 0)
            {
              const unsigned int node = definition.nodes[i];
              wall.mass_per_area =
                std::min(wall.mass_per_area, body.node_masses()[node] / areas[i]);
              const std::uint32_t local = partition.local_node[body.first_node + node];
              if (local != Partition::absent)
                wall.nodes.push_back({local, partition.owned[local] != 0, areas[i]});
            }
        if (!std::isfinite(wall.mass_per_area))
          throw InputError("contact \"" + definition.name +
                           "\": its nodes carry no face of body \"" + body.name() +
                           "\" that a wall could press on");
        walls_.push_back(std::move(wall));
      }
  }

  double RigidWalls::vote_on_step(const double step) const
  {
    double dt = step;
    for (const Wall &wall : walls_)
      {
        const RigidWall &w = *wall.definition;
        dt =
          std::min(dt,
                   w.penalty_from_step
                     ? step * std::sqrt(1. - 0.25 * w.penalty_fraction)
                     : 1. / std::sqrt(1. / (step * step) + 0.25 * w.penalty / wall.mass_per_area));
      }
    return dt;
  }

  void RigidWalls::set_penalties(const double dt)
  {
    for (Wall &wall : walls_)
      if (wall.definition->penalty_from_step)
        wall.penalty = wall.definition->penalty_fraction * wall.mass_per_area / (dt * dt);
  }

  void RigidWalls::add_relaxation_masses(const double fraction, std::vector<double> &masses) const
  {
    for (const Wall &wall : walls_)
      for (const Node &node : wall.nodes)
        masses[node.local] += wall.penalty * node.area / (4 * fraction * fraction);
  }

  void RigidWalls::add_forces(const NodeField &positions, NodeField &forces)
  {
    for (Wall &wall : walls_)
      {
        wall.force = wall.energy = wall.penetration = 0;
        const Vector3 &n = wall.definition->normal, &p = wall.definition->point;
        for (const Node &node : wall.nodes)
          {
            const double depth = -n.dot(positions.value(node.local) - p);
            if (!(depth > 0))
              continue;
            const double force = wall.penalty * node.area * depth;
            forces.add(node.local, force * n);
            wall.penetration = std::max(wall.penetration, depth);
            if (node.owned)
              {
                wall.force += force;
                wall.energy += 0.5 * force * depth;
              }
          }
      }
  }

  RigidWalls::Results RigidWalls::collect_results() const
  {
    Results results;
    if (walls_.empty())
      return results;
    std::vector<double> sums(2, 0.);
    for (const Wall &wall : walls_)
      {
        sums[0] += wall.force;
        sums[1] += wall.energy;
        results.penetration = std::max(results.penetration, wall.penetration);
      }
    communicator_.sum(sums);
    results.force       = sums[0];
    results.energy      = sums[1];
    results.penetration = communicator_.max(results.penetration);
    return results;
  }
} // namespace vfife
