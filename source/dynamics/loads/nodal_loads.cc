// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/process/communicator.h>
#include <vfife/contact/surface/facet_integrals.h>
#include <vfife/dynamics/loads/nodal_loads.h>
#include <vfife/dynamics/operator/vfife_operator.h>
#include <vfife/model/load_shares.h>

#include <algorithm>
#include <cmath>

namespace vfife
{
  NodalLoads::NodalLoads(const Model &model, VfifeOperator &vfife, const Communicator &communicator)
    : model_(model)
    , operator_(vfife)
    , communicator_(communicator)
  {
    const Partition &partition = vfife.partition();
    for (const Load &load : model.loads)
      {
        // 1. What each node takes of the load: by area, equally, or its mass.
        const Body &body    = model.bodies[load.body];
        const auto  weights = compute_load_shares(load, body);
        Group       group{&load, {}, {}, {}};
        for (std::size_t i = 0; i < load.nodes.size(); ++i)
          {
            const unsigned int  node  = load.nodes[i];
            const std::uint32_t local = partition.local_node[body.first_node + node];
            if (local != Partition::absent)
              group.nodes.push_back({local,
                                     static_cast<std::uint32_t>(i),
                                     partition.owned[local] != 0,
                                     weights[i],
                                     body.placement(body.node_positions()[node])});
          }
        // 2. A moment needs the places of the whole set, a pressure acts on faces, which move.
        if (load.kind == LoadKind::moment)
          group.motion.emplace(weights,
                               find_undeformed_places(body, load.nodes),
                               "load \"" + load.name + "\"");
        if (load.kind == LoadKind::pressure)
          {
            add_faces(load, group);
            has_pressure_ = true;
          }
        groups_.push_back(std::move(group));
      }
    find_spring_frequency();
    // 3. Room for the forces, which half_power() needs after add_forces().
    if (!groups_.empty())
      forces_ = vfife.make_field();
    if (has_pressure_)
      face_forces_ = vfife.make_field();
  }

  void NodalLoads::find_spring_frequency()
  {
    // All springs of a node act on it side by side: their stiffnesses along x, y, z add up, and the
    // stiffest direction has omega^2 = k/m. Over all nodes, so that all ranks agree.
    std::vector<std::vector<Vector3>> stiffness(model_.bodies.size());
    for (const Load &load : model_.loads)
      if (load.kind == LoadKind::spring)
        {
          const Body &body    = model_.bodies[load.body];
          const auto  weights = compute_load_shares(load, body);
          auto       &sums    = stiffness[load.body];
          sums.resize(body.n_nodes(), Vector3::Zero());
          for (std::size_t i = 0; i < load.nodes.size(); ++i)
            {
              const unsigned int node = load.nodes[i];
              sums[node] += weights[i] * load.vector;
              largest_frequency2_ =
                std::max(largest_frequency2_, sums[node].maxCoeff() / body.node_masses()[node]);
            }
        }
  }

  void NodalLoads::add_faces(const Load &load, Group &group) const
  {
    const Body      &body      = model_.bodies[load.body];
    const Partition &partition = operator_.partition();
    // Each face belongs to one element, hence to one rank: sums over ranks count it once.
    for (const BoundaryFace &boundary : find_boundary_faces(body, load.nodes, load.faces))
      if (std::binary_search(partition.elements.begin(),
                             partition.elements.end(),
                             body.first_element + boundary.element))
        {
          Face face;
          for (unsigned int i = 0; i < 4; ++i)
            face.local[i] = partition.local_node[body.first_node + boundary.nodes[i]];
          group.faces.push_back(face);
        }
  }

  double NodalLoads::vote_on_step(const double step) const
  {
    // 4/dt^2 = 4/step^2 + k/m: the squares of frequencies add up at most
    return 1. / std::sqrt(1. / (step * step) + 0.25 * largest_frequency2_);
  }

  void NodalLoads::add_relaxation_masses(const double fraction, std::vector<double> &masses) const
  {
    // One node on a spring k to the ground: omega^2 = k/m <= (2 fraction)^2.
    for (const Group &group : groups_)
      if (group.load->kind == LoadKind::spring)
        for (const Node &node : group.nodes)
          masses[node.local] +=
            group.load->vector.maxCoeff() * node.weight / (4 * fraction * fraction);
  }

  void NodalLoads::add_moment(const Group &group, const Vector3 &moment, const NodeField &positions)
  {
    std::vector<double> sums = MeanMotion::make_sums();
    for (const Node &node : group.nodes)
      if (node.owned)
        group.motion->add(node.of_set, positions.value(node.local), Vector3::Zero(), sums);
    communicator_.sum(sums);
    const MeanMotion::Motion motion = group.motion->solve(sums);
    for (const Node &node : group.nodes)
      forces_.add(node.local, group.motion->force(node.of_set, motion, Vector3::Zero(), moment));
  }

  void
  NodalLoads::add_pressure(const Group &group, const double pressure, const NodeField &positions)
  {
    // -p n dA of the present face, by its corners' shape functions.
    for (const Face &face : group.faces)
      {
        std::array<Vector3, 4> x;
        for (unsigned int i = 0; i < 4; ++i)
          x[i] = positions.value(face.local[i]);
        const std::array<Vector3, 4> normals = integrate_normals(x);
        for (unsigned int i = 0; i < 4; ++i)
          face_forces_.add(face.local[i], -pressure * normals[i]);
      }
  }

  void NodalLoads::add(const Group &group, const double factor, const NodeField &positions)
  {
    const Load &load = *group.load;
    switch (load.kind)
      {
      case LoadKind::force:
      case LoadKind::acceleration:
        for (const Node &node : group.nodes)
          forces_.add(node.local, factor * node.weight * load.vector);
        break;
      case LoadKind::moment:
        add_moment(group, factor * load.vector, positions);
        break;
      case LoadKind::pressure:
        add_pressure(group, factor * load.pressure, positions);
        break;
      case LoadKind::spring: // see add_springs()
        break;
      }
  }

  void NodalLoads::add_springs(const NodeField &positions, NodeField &forces) const
  {
    // -k (x - X) along x, y, z
    for (const Group &group : groups_)
      if (group.load->kind == LoadKind::spring)
        for (const Node &node : group.nodes)
          forces.add(node.local,
                     -node.weight *
                       group.load->vector.cwiseProduct(positions.value(node.local) - node.start));
  }

  double NodalLoads::compute_spring_energy(const NodeField &positions) const
  {
    // Groups are the same on all ranks: without a spring nothing is to be summed.
    double energy = 0;
    bool   found  = false;
    for (const Group &group : groups_)
      if (group.load->kind == LoadKind::spring)
        {
          found = true;
          for (const Node &node : group.nodes)
            if (node.owned)
              {
                const Vector3 way = positions.value(node.local) - node.start;
                energy += 0.5 * node.weight * group.load->vector.dot(way.cwiseAbs2());
              }
        }
    return found ? communicator_.sum(energy) : 0.;
  }

  void NodalLoads::add_spring_reactions(const NodeField       &positions,
                                        std::vector<Reaction> &reactions) const
  {
    std::size_t spring = model_.constraints.size();
    for (const Group &group : groups_)
      if (group.load->kind == LoadKind::spring)
        {
          for (const Node &node : group.nodes)
            if (const Vector3 place = positions.value(node.local); node.owned)
              reactions[spring].add(place,
                                    -node.weight *
                                      group.load->vector.cwiseProduct(place - node.start));
          ++spring;
        }
  }

  void NodalLoads::finish(const NodeField &positions, NodeField &forces)
  {
    // Springs are elastic parts, their energy is the ledger's strain: forces_ has the loads alone.
    // Nodes of other ranks' faces take their forces by the halo, all copies alike.
    add_springs(positions, forces);
    if (has_pressure_)
      {
        operator_.add_over_ranks(face_forces_);
        forces_ += face_forces_;
        face_forces_.set_zero();
      }
    if (!forces_.empty())
      forces += forces_;
  }

  void NodalLoads::add_forces(const double time, const NodeField &positions, NodeField &forces)
  {
    forces_.set_zero();
    for (const Group &group : groups_)
      add(group, group.load->history.value(time), positions);
    finish(positions, forces);
  }

  void NodalLoads::add_part(const double part, const NodeField &positions, NodeField &forces)
  {
    forces_.set_zero();
    for (const Group &group : groups_)
      add(group, part, positions);
    finish(positions, forces);
  }

  double NodalLoads::half_power(const NodeField &velocities) const
  {
    const Partition &partition = operator_.partition();
    double           power     = 0;
    if (!forces_.empty())
      for (const std::uint32_t i : partition.owned_nodes())
        power += 0.5 * forces_.value(i).dot(velocities.value(i));
    return power;
  }
} // namespace vfife
