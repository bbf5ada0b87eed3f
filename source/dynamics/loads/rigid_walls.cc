// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/process/communicator.h>
#include <vfife/dynamics/loads/rigid_walls.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace vfife
{
  RigidWalls::Wall::Wall(const RigidWall &wall)
    : definition(&wall)
    , law(wall.penalty.law(wall.penalty))
    , mass_per_area(std::numeric_limits<double>::infinity())
    , penalty(wall.penalty.value)
    , depth_limit(std::numeric_limits<double>::infinity())
  {
  }

  RigidWalls::RigidWalls(const Model        &model,
                         const Partition    &partition,
                         const Communicator &communicator)
    : communicator_(communicator)
  {
    for (const RigidWall &definition : model.walls)
      {
        // Each node presses with the area of the boundary faces around it whose corners are all of
        // the set; the lightest node for its area bounds penalty and step. All nodes of the model
        // are looked at, those of other ranks too, so that ranks agree.
        const Body &body  = model.bodies[definition.body];
        const auto  areas = compute_nodal_areas(body, definition.nodes, definition.faces);
        Wall        wall(definition);
        double      largest_area = 0;
        for (std::size_t i = 0; i < areas.size(); ++i)
          if (areas[i] > 0)
            {
              const unsigned int node = definition.nodes[i];
              wall.mass_per_area =
                std::min(wall.mass_per_area, body.node_masses()[node] / areas[i]);
              largest_area              = std::max(largest_area, areas[i]);
              const std::uint32_t local = partition.local_node[body.first_node + node];
              if (local != Partition::absent)
                wall.nodes.push_back({local, partition.owned[local] != 0, areas[i], node, i});
            }
        if (!std::isfinite(wall.mass_per_area))
          throw InputError("contact \"" + definition.name +
                           "\": its nodes carry no face of body \"" + body.name() +
                           "\" that a wall could press on");
        // Inside a surface the area of a node is that of a facet.
        if (definition.penalty.from_step)
          wall.depth_limit = 0.5 * std::sqrt(largest_area);
        walls_.push_back(std::move(wall));
      }
  }

  double RigidWalls::vote_on_step(const double step) const
  {
    double dt = step;
    for (const Wall &wall : walls_)
      dt = std::min(dt, wall.options().vote_on_step(step, wall.mass_per_area));
    return dt;
  }

  void RigidWalls::set_penalties(const double dt)
  {
    for (Wall &wall : walls_)
      wall.penalty = wall.options().value_for_step(wall.mass_per_area, dt);
  }

  void RigidWalls::add_relaxation_masses(const double fraction, std::vector<double> &masses) const
  {
    for (const Wall &wall : walls_)
      for (const Node &node : wall.nodes)
        masses[node.local] += wall.options().relaxation_mass(wall.penalty * node.area, fraction);
  }

  void RigidWalls::add_forces(const NodeField &positions, NodeField &forces)
  {
    sums_ = {{0., 0., 0., 0.}};
    for (Wall &wall : walls_)
      {
        //   n ^                       1. depth = -n . (x - p) of every node behind the plane
        //     |                       2. forces by the contact law, penalty times the node's area
        //  ---p--------+---- plane    3. they act along n, friction along the plane
        //              | depth
        //              o x
        const Vector3 &n = wall.definition->normal, &p = wall.definition->point;
        const bool has_friction = wall.definition->friction.acts() && mode_ != FrictionMode::none;
        wall.touching.clear();
        wall.pressed.clear();
        wall.force = wall.energy = wall.penetration = wall.friction_loss = 0;
        wall.friction.setZero();
        for (Node &node : wall.nodes)
          {
            const Vector3 x     = positions.value(node.local);
            const double  depth = -n.dot(x - p);
            if (depth > 0)
              {
                wall.touching.push_back(&node);
                wall.pressed.push_back({depth, wall.penalty * node.area});
              }
            else if (has_friction)
              open(wall, node, x);
          }
        wall.law->evaluate(wall.pressed);

        // All copies of a node take its force; force and energy are sums, which the owner counts.
        for (std::size_t k = 0; k < wall.pressed.size(); ++k)
          {
            Node               &node    = *wall.touching[k];
            const PressedPoint &pressed = wall.pressed[k];
            forces.add(node.local, pressed.pressure * n);
            wall.penetration = std::max(wall.penetration, pressed.penetration);
            if (node.owned)
              {
                wall.force += pressed.pressure;
                wall.energy += pressed.energy;
                sums_[2] += pressed.penetration > wall.depth_limit ? 1. : 0.;
              }
            if (!has_friction)
              continue;
            const Vector3 friction = stick(wall, node, pressed, positions.value(node.local));
            forces.add(node.local, friction);
            if (node.owned)
              wall.friction += friction;
          }
        sums_[0] += wall.force;
        sums_[1] += wall.energy;
        sums_[3] += wall.friction_loss;
      }
    if (!walls_.empty())
      communicator_.sum(sums_.data(), sums_.size());
  }

  std::string RigidWalls::describe_deepest_node(const Model &model) const
  {
    // The deepest of this rank in words, relative to its limit ...
    double             deepest = 0;
    std::ostringstream text;
    for (const Wall &wall : walls_)
      for (std::size_t k = 0; k < wall.pressed.size(); ++k)
        {
          const double ratio = wall.pressed[k].penetration / wall.depth_limit;
          if (!(ratio > deepest))
            continue;
          deepest = ratio;
          text.str("");
          text << "contact \"" << wall.definition->name << "\": body \""
               << model.bodies[wall.definition->body].name() << "\", node "
               << wall.touching[k]->node << ", is " << 1e3 * wall.pressed[k].penetration
               << " um behind the wall (limit " << 1e3 * wall.depth_limit << " um, half a facet)";
        }
    // ... then the rank that has the deepest of all.
    const std::vector<double>      all   = communicator_.all_gather(deepest);
    const std::vector<std::string> texts = communicator_.all_gather(text.str());
    return texts[std::max_element(all.begin(), all.end()) - all.begin()];
  }

  RigidWalls::Results RigidWalls::collect_results() const
  {
    Results results;
    if (walls_.empty())
      return results;
    // Of each wall the normal force and friction.
    std::vector<double> sums;
    for (const Wall &wall : walls_)
      {
        sums.insert(sums.end(), {wall.force, wall.friction[0], wall.friction[1], wall.friction[2]});
        results.penetration = std::max(results.penetration, wall.penetration);
      }
    communicator_.sum(sums);
    results.energy      = sums_[1];
    results.penetration = communicator_.max(results.penetration);
    for (std::size_t w = 0; w < walls_.size(); ++w)
      {
        const double *s = sums.data() + 4 * w;
        const Vector3 friction(s[1], s[2], s[3]);
        results.forces.push_back(s[0] * walls_[w].definition->normal + friction);
        results.force += std::hypot(s[0], friction.norm());
      }
    return results;
  }
} // namespace vfife
