// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/process/communicator.h>
#include <vfife/base/text/byte_stream.h>
#include <vfife/contact/law/penalty_options.h>
#include <vfife/contact/surface/facet_integrals.h>
#include <vfife/dynamics/loads/pressed_wall.h>
#include <vfife/model/load_shares.h>

#include <algorithm>
#include <limits>

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
  } // namespace

  PressedWall::PressedWall(const RigidWall &wall, const Body &body, const Partition &partition)
    : definition(&wall)
    , law(wall.penalty.law(wall.penalty))
    , friction_law(wall.friction.acts() ? wall.friction.make_law() : nullptr)
    , mass_per_area(std::numeric_limits<double>::infinity())
    , penalty(wall.penalty.value)
    , depth_limit(std::numeric_limits<double>::infinity())
  {
    // Each node presses with the area of the boundary faces around it whose corners are all of the
    // set. All nodes of the model are looked at, those of other ranks too, so that ranks agree.
    const NodalSprings springs      = find_springs(wall, body);
    const bool         derived      = wall.penalty.is_open();
    double             largest_area = 0;
    for (std::size_t i = 0; i < springs.areas.size(); ++i)
      if (const double area = springs.areas[i]; area > 0)
        {
          mass_per_area = std::min(mass_per_area, body.node_masses()[wall.nodes[i]] / area);
          largest_area  = std::max(largest_area, area);
          if (derived)
            penalty = std::max(penalty, springs.stiffness[i] / area);
        }
    if (!std::isfinite(mass_per_area))
      throw InputError("contact \"" + wall.name + "\": the nodes contain no face of body \"" +
                       body.name() + "\". Select all nodes of the faces on which the wall acts");
    for (std::size_t i = 0; i < springs.areas.size(); ++i)
      {
        const unsigned int  node  = wall.nodes[i];
        const std::uint32_t local = partition.local_node[body.first_node + node];
        if (springs.areas[i] > 0 && local != Partition::absent)
          nodes.push_back({local,
                           partition.owned[local] != 0,
                           springs.areas[i],
                           derived ? springs.stiffness[i] / (springs.areas[i] * penalty) : 1.,
                           body.node_masses()[node],
                           node,
                           i});
      }
    // Inside a surface the area of a node is that of a facet.
    if (derived)
      depth_limit = 0.5 * std::sqrt(largest_area);
  }

  void PressedWall::set_step(const double dt)
  {
    for (Node &node : nodes)
      node.tangential = std::min(definition->friction.stiffness_ratio * penalty * node.stiffness,
                                 PenaltyOptions::stick_value(node.mass / node.area, dt));
  }

  void PressedWall::begin(const double time)
  {
    evaluated_step = time;
    touches.clear();
    force = energy = friction_loss = lost_power = 0;
    friction.setZero();
  }

  void PressedWall::find_touches(const NodeField &positions)
  {
    //   n ^                       1. depth = -n . (x - p) of every node behind the plane
    //     |                       2. pressures by the contact law
    //  ---p--------+---- plane
    //              | depth
    //              o x
    const Vector3            &n = definition->normal, &p = definition->point;
    std::vector<PressedPoint> pressed;
    for (Node &node : nodes)
      {
        const Vector3 x     = positions.value(node.local);
        const double  depth = -n.dot(x - p);
        if (depth > 0)
          {
            touches.push_back({&node, depth, 0.});
            pressed.push_back({depth, penalty * node.stiffness});
          }
        else if (has_friction())
          open(node, x, Vector3::Zero());
      }
    law->evaluate(pressed);
    for (std::size_t i = 0; i < pressed.size(); ++i)
      {
        const Node &node    = *touches[i].node;
        touches[i].pressure = pressed[i].pressure;
        energy += node.owned ? pressed[i].energy * node.area : 0.;
      }
  }

  void PressedWall::open(Node &node, const Vector3 &x, const Vector3 &way)
  {
    if (mode == FrictionMode::follows)
      {
        // The spring lets go, after its force has acted on half of the way since the evaluation
        // before, as all forces of central differences do.
        if (node.owned && node.sticks)
          {
            const Vector3 &n       = definition->normal;
            const Vector3  stretch = x - way - node.anchor;
            const Vector3  along   = way - n.dot(way) * n;
            friction_loss += node.energy + .5 * node.tangential * node.area * stretch.dot(along);
          }
        node.sticks  = false;
        node.elastic = node.energy = 0;
      }
    else if (!node.sticks)
      {
        // Where a load step begins, for nodes that may come to touch within it.
        node.sticks = true;
        node.anchor = x;
      }
  }

  Vector3
  PressedWall::stick(Node &node, const double pressure, const Vector3 &x, const Vector3 &way)
  {
    // A node that comes to touch does so on the way since the evaluation before.
    if (!node.sticks)
      node.anchor = x - way;
    node.sticks = true;
    // As between two bodies (StickSlip::stick), pressures being forces here.
    const FrictionLaw   &law          = *friction_law;
    const Vector3       &n            = definition->normal;
    const Vector3        stretch      = x - node.anchor;
    const Vector3        displacement = stretch - n.dot(stretch) * n;
    const double         speed        = law.depends_on_speed() && evaluated_step > 0
                                          ? (way - n.dot(way) * n).norm() / evaluated_step
                                          : 0.;
    const SliderResponse response =
      slide(law, {pressure, speed, node.tangential, node.elastic, node.area}, displacement.norm());
    const Vector3 elastic = response.elastic_part * displacement;
    if (node.owned)
      energy += response.energy;
    if (mode == FrictionMode::follows)
      {
        if (node.owned)
          friction_loss += response.loss;
        if (response.slid > 0)
          node.anchor = x - elastic;
        node.elastic = response.elastic;
        node.energy  = response.energy;
      }
    return -(node.tangential * node.area) * elastic;
  }

  void PressedWall::serialize(ByteStream &stream, const Communicator &communicator)
  {
    if (!friction_law)
      return;
    constexpr std::size_t n = 6; // numbers a node: whether it sticks, where, displacement, energy
    // One owner a node: adding the others' zeros changes no digit.
    std::vector<double> all(n * definition->nodes.size(), 0.);
    if (!stream.reads())
      {
        for (const Node &node : nodes)
          if (node.owned && node.sticks)
            {
              double *values = all.data() + n * node.index;
              values[0]      = 1;
              std::copy_n(node.anchor.data(), 3, values + 1);
              values[4] = node.elastic;
              values[5] = node.energy;
            }
        communicator.sum(all);
      }
    stream.pass_known(all);
    if (stream.reads())
      for (Node &node : nodes)
        {
          const double *values = all.data() + n * node.index;
          node.sticks          = values[0] > 0;
          node.anchor          = Vector3(values[1], values[2], values[3]);
          node.elastic         = values[4];
          node.energy          = values[5];
        }
  }
} // namespace vfife
