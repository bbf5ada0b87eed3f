// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/process/communicator.h>
#include <vfife/base/text/figure_text.h>
#include <vfife/dynamics/loads/rigid_walls.h>
#include <vfife/model/constraints/node_constraints.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>

namespace vfife
{
  namespace
  {
    /** Penetrations at both ends of a step without what is to be found, the larger one. */
    double
    largest_depth(const double gap, const double rate, const double free_rate, const double dt)
    {
      return -std::min(gap - .5 * dt * rate, gap + .5 * dt * free_rate);
    }
  } // namespace

  RigidWalls::RigidWalls(const Model        &model,
                         const Partition    &partition,
                         const Communicator &communicator)
    : communicator_(communicator)
  {
    for (const RigidWall &definition : model.walls)
      walls_.emplace_back(definition, model.bodies[definition.body], partition);
    collect_places(model);
  }

  void RigidWalls::collect_places(const Model &model)
  {
    for (unsigned int w = 0; w < walls_.size(); ++w)
      for (unsigned int i = 0; i < walls_[w].nodes.size(); ++i)
        places_.push_back({w, i, walls_[w].nodes[i].local});
    std::stable_sort(places_.begin(), places_.end(), [](const Place &a, const Place &b) {
      return a.local < b.local;
    });
    std::map<unsigned int, std::map<unsigned int, NodeConstraints>> constraints;
    for (const PressedWall &wall : walls_)
      if (constraints.count(wall.definition->body) == 0)
        constraints[wall.definition->body] = combine_constraints(model, wall.definition->body);
    for (const Place &place : places_)
      {
        const PressedWall &wall = walls_[place.wall];
        const Node        &node = wall.nodes[place.node];
        inverse_masses_.push_back(free_directions(constraints[wall.definition->body], node.node) /
                                  node.mass);
      }
  }

  double RigidWalls::vote_on_step(const double step) const
  {
    // The pressure bears any step; the springs of nodes that stick do not.
    double dt = step;
    for (const PressedWall &wall : walls_)
      if (wall.friction_law)
        dt = std::min(dt, wall.options().vote_of_stick(step));
    return dt;
  }

  void RigidWalls::set_step(const double dt)
  {
    for (PressedWall &wall : walls_)
      wall.set_step(dt);
  }

  void RigidWalls::set_friction_mode(const FrictionMode mode)
  {
    for (PressedWall &wall : walls_)
      wall.mode = mode;
  }

  std::vector<std::string> RigidWalls::describe_penalties() const
  {
    std::vector<std::string> sentences;
    for (const PressedWall &wall : walls_)
      {
        std::ostringstream text;
        set_figure_digits(text, 4);
        text << "contact penalty of the wall \"" << wall.definition->name << "\" " << wall.penalty
             << " N/mm^3" << (wall.options().is_open() ? " at its narrowest facets" : "");
        sentences.push_back(text.str());
      }
    return sentences;
  }

  void RigidWalls::add_relaxation_masses(const double fraction, std::vector<double> &masses) const
  {
    for (const PressedWall &wall : walls_)
      for (const Node &node : wall.nodes)
        masses[node.local] +=
          wall.options().relaxation_mass(wall.penalty * node.stiffness * node.area, fraction);
  }

  void RigidWalls::begin(const double step)
  {
    sums_ = {};
    for (PressedWall &wall : walls_)
      wall.begin(step);
  }

  void RigidWalls::add_forces(const NodeField &positions, NodeField &forces)
  {
    begin(0.);
    for (PressedWall &wall : walls_)
      wall.find_touches(positions);
    press(
      positions, [](const Node &) { return Vector3(Vector3::Zero()); }, forces);
  }

  void RigidWalls::add_step_forces(const NodeField &positions,
                                   const NodeField &velocities,
                                   const double     dt,
                                   NodeField       &forces)
  {
    begin(dt);
    for (std::size_t first = 0; first < places_.size();)
      {
        std::size_t last = first;
        while (last < places_.size() && places_[last].local == places_[first].local)
          ++last;
        find_step_touches(first, last, positions, velocities, dt, forces);
        first = last;
      }
    press(
      positions,
      [&](const Node &node) { return Vector3(dt * velocities.value(node.local)); },
      forces);
  }

  void RigidWalls::find_step_touches(const std::size_t first,
                                     const std::size_t last,
                                     const NodeField  &positions,
                                     const NodeField  &velocities,
                                     const double      dt,
                                     const NodeField  &forces)
  {
    const std::uint32_t local = places_[first].local;
    const Vector3       x = positions.value(local), v = velocities.value(local);
    const Vector3       free = v + dt * (inverse_masses_[first] * forces.value(local));
    points_.clear();
    bool touches = false;
    for (std::size_t i = first; i < last; ++i)
      {
        const PressedWall &wall = walls_[places_[i].wall];
        const Node        &node = wall.nodes[places_[i].node];
        const Vector3     &n    = wall.definition->normal;
        TouchingPoint      point; // weighs one node alone
        Eigen::Map<Vector3>(point.direction) = n;
        point.slave_weights[0]               = 1.;
        point.area                           = node.area;
        point.stiffness                      = node.stiffness;
        point.gap                            = n.dot(x - wall.definition->point);
        touches = touches || largest_depth(point.gap, n.dot(v), n.dot(free), dt) > 0;
        points_.push_back(point);
      }
    if (touches)
      {
        // The pressures of one node alone, so that all its copies have the same to the last bit.
        solver_.reset(dt, {{v, free, inverse_masses_[first]}});
        for (std::size_t i = first; i < last; ++i)
          {
            const PressedWall &wall = walls_[places_[i].wall];
            solver_.add(points_[i - first], {}, {}, {*wall.law, wall.penalty, wall.damping()});
          }
        solver_.solve(points_);
      }
    for (std::size_t i = first; i < last; ++i)
      {
        PressedWall         &wall  = walls_[places_[i].wall];
        Node                &node  = wall.nodes[places_[i].node];
        const TouchingPoint &point = points_[i - first];
        // A sum, which the owner counts.
        if (node.owned && touches)
          {
            wall.energy += point.energy * node.area;
            wall.lost_power -= (point.pressure - point.elastic) * point.gap_rate * node.area;
          }
        if (point.pressure > 0)
          wall.touches.push_back({&node, std::max(0., -point.gap), point.pressure});
        else if (wall.has_friction())
          wall.open(node, x, dt * v);
      }
  }

  template <typename Way>
  void RigidWalls::press(const NodeField &positions, const Way &way, NodeField &forces)
  {
    for (PressedWall &wall : walls_)
      {
        // Pressure acts along the normal, friction along the plane. All copies of a node take its
        // force; sums of forces are the owner's.
        for (const Touch &touch : wall.touches)
          {
            Node        &node  = *touch.node;
            const double force = touch.pressure * node.area;
            forces.add(node.local, force * wall.definition->normal);
            if (node.owned)
              {
                wall.force += force;
                sums_[2] += touch.depth > wall.depth_limit ? 1. : 0.;
              }
            if (!wall.has_friction())
              continue;
            const Vector3 friction =
              wall.stick(node, touch.pressure, positions.value(node.local), way(node));
            forces.add(node.local, friction);
            if (node.owned)
              wall.friction += friction;
          }
        sums_[0] += wall.force;
        sums_[1] += wall.energy;
        sums_[3] += wall.friction_loss;
        sums_[4] += wall.lost_power;
      }
    if (!walls_.empty())
      communicator_.sum(sums_.data(), sums_.size());
  }

  std::string RigidWalls::describe_deepest_node(const Model &model) const
  {
    // The deepest of this rank in words, relative to its limit, which a soft wall does not have ...
    double             deepest = 0;
    std::ostringstream text;
    set_figure_digits(text, 4);
    for (const PressedWall &wall : walls_)
      for (const Touch &touch : wall.touches)
        {
          const bool   limited = std::isfinite(wall.depth_limit);
          const double ratio   = touch.depth / (limited ? wall.depth_limit : 1e6);
          if (!(ratio > deepest))
            continue;
          deepest = ratio;
          text.str("");
          text << "contact \"" << wall.definition->name << "\": body \""
               << model.bodies[wall.definition->body].name() << "\", node " << touch.node->node
               << ", is " << 1e3 * touch.depth << " um behind the wall";
          if (limited)
            text << " (limit " << 1e3 * wall.depth_limit << " um, half a facet)";
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
    for (const PressedWall &wall : walls_)
      {
        sums.insert(sums.end(), {wall.force, wall.friction[0], wall.friction[1], wall.friction[2]});
        for (const Touch &touch : wall.touches)
          results.penetration = std::max(results.penetration, touch.depth);
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

  void RigidWalls::serialize(ByteStream &stream)
  {
    for (PressedWall &wall : walls_)
      wall.serialize(stream, communicator_);
  }
} // namespace vfife
