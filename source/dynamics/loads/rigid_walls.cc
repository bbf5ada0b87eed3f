// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/process/communicator.h>
#include <vfife/base/text/figure_text.h>
#include <vfife/contact/law/facet_penalty.h>
#include <vfife/contact/surface/facet_integrals.h>
#include <vfife/dynamics/loads/rigid_walls.h>
#include <vfife/model/constraints/node_constraints.h>
#include <vfife/model/load_shares.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <sstream>

namespace vfife
{
  namespace
  {
    /** Of each node of a wall its area and the sum over its faces of penalty times area [mm^2],
     * [N/mm]. */
    struct NodalSprings
    {
      std::vector<double> areas, stiffness;
    };

    NodalSprings find_springs(const RigidWall &wall, const Body &body)
    {
      const Material     &material = body.material_under(wall.nodes, "wall \"" + wall.name + "\"");
      const double        E = material.youngs_modulus, nu = material.poissons_ratio;
      const double        modulus = E / (1. - nu * nu);
      std::vector<double> areas(body.n_nodes(), 0.), stiffness(body.n_nodes(), 0.);
      const auto         &x = body.node_positions();
      for (const BoundaryFace &face : find_boundary_faces(body, wall.nodes, wall.faces))
        {
          const std::array<Vector3, 4> corners = {
            {x[face.nodes[0]], x[face.nodes[1]], x[face.nodes[2]], x[face.nodes[3]]}};
          const double penalty    = compute_facet_penalty(modulus, facet_width(corners));
          const auto   integrals  = integrate_areas(corners);
          const double of_node[4] = {integrals[0], integrals[1], integrals[3], integrals[2]};
          for (unsigned int k = 0; k < 4; ++k)
            {
              areas[face.nodes[k]] += of_node[k];
              stiffness[face.nodes[k]] += penalty * of_node[k];
            }
        }
      NodalSprings springs;
      for (const unsigned int node : wall.nodes)
        {
          springs.areas.push_back(areas[node]);
          springs.stiffness.push_back(stiffness[node]);
        }
      return springs;
    }

    /** Penetrations at both ends of a step without what is to be found, the larger one. */
    double
    largest_depth(const double gap, const double rate, const double free_rate, const double dt)
    {
      return -std::min(gap - .5 * dt * rate, gap + .5 * dt * free_rate);
    }
  } // namespace

  RigidWalls::Wall::Wall(const RigidWall &wall)
    : definition(&wall)
    , law(wall.penalty.law(wall.penalty))
    , friction_law(wall.friction.acts() ? wall.friction.make_law() : nullptr)
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
        // the set. All nodes of the model are looked at, those of other ranks too, so that ranks
        // agree.
        const Body        &body    = model.bodies[definition.body];
        const NodalSprings springs = find_springs(definition, body);
        const bool         derived = definition.penalty.is_open();
        Wall               wall(definition);
        double             largest_area = 0;
        for (std::size_t i = 0; i < springs.areas.size(); ++i)
          if (const double area = springs.areas[i]; area > 0)
            {
              wall.mass_per_area =
                std::min(wall.mass_per_area, body.node_masses()[definition.nodes[i]] / area);
              largest_area = std::max(largest_area, area);
              if (derived)
                wall.penalty = std::max(wall.penalty, springs.stiffness[i] / area);
            }
        if (!std::isfinite(wall.mass_per_area))
          throw InputError("contact \"" + definition.name +
                           "\": the nodes contain no face of body \"" + body.name() +
                           "\". Select all nodes of the faces on which the wall acts");
        for (std::size_t i = 0; i < springs.areas.size(); ++i)
          {
            const unsigned int  node  = definition.nodes[i];
            const std::uint32_t local = partition.local_node[body.first_node + node];
            if (springs.areas[i] > 0 && local != Partition::absent)
              wall.nodes.push_back(
                {local,
                 partition.owned[local] != 0,
                 springs.areas[i],
                 derived ? springs.stiffness[i] / (springs.areas[i] * wall.penalty) : 1.,
                 body.node_masses()[node],
                 node,
                 i});
          }
        // Inside a surface the area of a node is that of a facet.
        if (derived)
          wall.depth_limit = 0.5 * std::sqrt(largest_area);
        walls_.push_back(std::move(wall));
      }
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
    for (const Wall &wall : walls_)
      if (constraints.count(wall.definition->body) == 0)
        constraints[wall.definition->body] = combine_constraints(model, wall.definition->body);
    for (const Place &place : places_)
      {
        const Wall &wall = walls_[place.wall];
        const Node &node = wall.nodes[place.node];
        inverse_masses_.push_back(free_directions(constraints[wall.definition->body], node.node) /
                                  node.mass);
      }
  }

  double RigidWalls::vote_on_step(const double step) const
  {
    // The pressure bears any step; the springs of nodes that stick do not.
    double dt = step;
    for (const Wall &wall : walls_)
      if (wall.friction_law)
        dt = std::min(dt, wall.options().vote_of_stick(step));
    return dt;
  }

  void RigidWalls::set_step(const double dt)
  {
    for (Wall &wall : walls_)
      for (Node &node : wall.nodes)
        node.tangential =
          std::min(wall.definition->friction.stiffness_ratio * wall.penalty * node.stiffness,
                   PenaltyOptions::stick_value(node.mass / node.area, dt));
  }

  std::vector<std::string> RigidWalls::describe_penalties() const
  {
    std::vector<std::string> sentences;
    for (const Wall &wall : walls_)
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
    for (const Wall &wall : walls_)
      for (const Node &node : wall.nodes)
        masses[node.local] +=
          wall.options().relaxation_mass(wall.penalty * node.stiffness * node.area, fraction);
  }

  void RigidWalls::clear_results()
  {
    sums_ = {};
    for (Wall &wall : walls_)
      {
        wall.touches.clear();
        wall.force = wall.energy = wall.friction_loss = wall.lost_power = 0;
        wall.friction.setZero();
      }
  }

  void RigidWalls::add_forces(const NodeField &positions, NodeField &forces)
  {
    //   n ^                       1. depth = -n . (x - p) of every node behind the plane
    //     |                       2. pressures by the contact law
    //  ---p--------+---- plane    3. they act along n, friction along the plane
    //              | depth
    //              o x
    clear_results();
    step_              = 0;
    const auto at_rest = [](const Node &) { return Vector3(Vector3::Zero()); };
    for (Wall &wall : walls_)
      {
        const Vector3            &n = wall.definition->normal, &p = wall.definition->point;
        std::vector<PressedPoint> pressed;
        for (Node &node : wall.nodes)
          {
            const Vector3 x     = positions.value(node.local);
            const double  depth = -n.dot(x - p);
            if (depth > 0)
              {
                wall.touches.push_back({&node, depth, 0.});
                pressed.push_back({depth, wall.penalty * node.stiffness});
              }
            else if (has_friction(wall))
              open(wall, node, x, Vector3::Zero());
          }
        wall.law->evaluate(pressed);
        for (std::size_t i = 0; i < pressed.size(); ++i)
          {
            const Node &node         = *wall.touches[i].node;
            wall.touches[i].pressure = pressed[i].pressure;
            wall.energy += node.owned ? pressed[i].energy * node.area : 0.;
          }
      }
    press(positions, at_rest, forces);
  }

  void RigidWalls::add_step_forces(const NodeField &positions,
                                   const NodeField &velocities,
                                   const double     dt,
                                   NodeField       &forces)
  {
    clear_results();
    step_ = dt;
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
        const Wall    &wall = walls_[places_[i].wall];
        const Node    &node = wall.nodes[places_[i].node];
        const Vector3 &n    = wall.definition->normal;
        TouchingPoint  point; // weighs one node alone
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
            const Wall &wall = walls_[places_[i].wall];
            solver_.add(points_[i - first], {}, {}, {*wall.law, wall.penalty, wall.damping()});
          }
        solver_.solve(points_);
      }
    for (std::size_t i = first; i < last; ++i)
      {
        Wall                &wall  = walls_[places_[i].wall];
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
        else if (has_friction(wall))
          open(wall, node, x, dt * v);
      }
  }

  template <typename Way>
  void RigidWalls::press(const NodeField &positions, const Way &way, NodeField &forces)
  {
    for (Wall &wall : walls_)
      {
        // All copies of a node take its force; sums of forces are the owner's.
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
            if (!has_friction(wall))
              continue;
            const Vector3 friction =
              stick(wall, node, touch.pressure, positions.value(node.local), way(node));
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
    for (const Wall &wall : walls_)
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
    for (const Wall &wall : walls_)
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
} // namespace vfife
