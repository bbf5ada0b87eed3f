// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include "distributed_loads.h"

#include <vfife/base/process/communicator.h>
#include <vfife/bearing/mean_motion.h>
#include <vfife/model/constraints/held_direction.h>

#include <map>
#include <set>

namespace vfife
{
  namespace
  {
    /** Nodes that other ranks own have no degrees of freedom here. */
    bool owns(const DofLevel &level, const PointDofs &dofs)
    {
      return dofs[0] != dealii::numbers::invalid_dof_index && level.owned().is_element(dofs[0]);
    }
  } // namespace

  DistributedLoads::DistributedLoads(const Model &model, const DistributedSpace &space)
    : model_(model)
    , space_(space)
    , forces_(space.level().make_vector())
  {
  }

  const DistributedVector &DistributedLoads::finish()
  {
    forces_.compress(dealii::VectorOperation::add);
    return forces_;
  }

  bool DistributedLoads::integrates() const
  {
    // As on a space: nodal areas and masses of the body where points are its nodes.
    return space_.level().degree() > 1 || space_.mesh().is_refined();
  }

  Vector3 DistributedLoads::place_of(const Share &share) const
  {
    return {share.place[0], share.place[1], share.place[2]};
  }

  void DistributedLoads::add(const PointDofs &dofs, const Vector3 &force)
  {
    for (unsigned int c = 0; c < 3; ++c)
      space_.level().hanging().distribute_local_to_global(dofs[c], force[c], forces_);
  }

  void DistributedLoads::for_faces(const std::vector<BoundaryFace>         &faces,
                                   const std::function<void(const Face &)> &act) const
  {
    std::set<std::pair<unsigned int, unsigned int>> wanted;
    for (const BoundaryFace &face : faces)
      wanted.emplace(face.element, face.number);
    const DofLevel &level = space_.level();
    level.for_elements([&](const DofLevel::Element &element) {
      for (unsigned int f = 0; f < 6; ++f)
        {
          if (!DistributedMesh::is_on_face(element.place, f) ||
              wanted.count({element.place.element, f}) == 0)
            continue;
          const std::vector<unsigned int> numbers = numbers_on_face(level.degree(), f);
          Face                            face{{}, ElementNodes(3, numbers.size())};
          for (std::size_t i = 0; i < numbers.size(); ++i)
            {
              face.points.push_back(element.points[numbers[i]]);
              face.places.col(i) = value_at(face.points.back(), level.places());
            }
          act(face);
        }
    });
  }

  std::vector<DistributedLoads::Share>
  DistributedLoads::list_nodes(const std::vector<unsigned int> &nodes,
                               const std::vector<double>       &weights) const
  {
    const std::vector<Vector3> places = find_undeformed_places(space_.body(), nodes);
    std::vector<Share>         shares;
    for (std::size_t i = 0; i < nodes.size(); ++i)
      shares.push_back(
        {space_.dofs_of_nodes()[nodes[i]], weights[i], {places[i][0], places[i][1], places[i][2]}});
    return shares;
  }

  std::vector<DistributedLoads::Share>
  DistributedLoads::find_areas(const std::vector<BoundaryFace> &faces) const
  {
    std::map<dealii::types::global_dof_index, Share> of_points;
    const auto                                       add_share = [&](const Share &share) {
      const auto [at, is_new] = of_points.emplace(share.dofs[0], share);
      if (!is_new)
        at->second.weight += share.weight;
    };
    for_faces(faces, [&](const Face &face) {
      for (const FacePoint &at : compute_face_points(face.places))
        for (std::size_t i = 0; i < face.points.size(); ++i)
          add_share({face.points[i],
                     at.normal.norm() * at.N[i],
                     {face.places(0, i), face.places(1, i), face.places(2, i)}});
    });
    std::vector<Share> own;
    for (const auto &point : of_points)
      own.push_back(point.second);
    of_points.clear();
    for (const Share &share : space_.communicator().all_gather(own))
      add_share(share);
    std::vector<Share> shares;
    for (const auto &point : of_points)
      shares.push_back(point.second);
    return shares;
  }

  std::vector<DistributedLoads::Share> DistributedLoads::find_shares(const Load &load) const
  {
    const Body                     &body  = space_.body();
    const std::vector<BoundaryFace> faces = integrates()
                                              ? find_boundary_faces(body, load.nodes, load.faces)
                                              : std::vector<BoundaryFace>();
    if (faces.empty())
      return list_nodes(load.nodes, compute_area_shares(body, load.nodes, load.faces));
    std::vector<Share> shares = find_areas(faces);
    double             sum    = 0;
    for (const Share &share : shares)
      sum += share.weight;
    for (Share &share : shares)
      share.weight /= sum;
    return shares;
  }

  void DistributedLoads::add_pressure(const Load &load, const double factor)
  {
    compute_load_shares(load, space_.body()); // refuses nodes without a face
    for_faces(find_boundary_faces(space_.body(), load.nodes, load.faces), [&](const Face &face) {
      for (const FacePoint &at : compute_face_points(face.places))
        for (std::size_t i = 0; i < face.points.size(); ++i)
          add(face.points[i], -factor * load.pressure * at.N[i] * at.normal);
    });
  }

  void DistributedLoads::add_acceleration(const Load &load, const double factor)
  {
    const Body     &body  = space_.body();
    const DofLevel &level = space_.level();
    if (!integrates())
      {
        for (const Share &share : list_nodes(load.nodes, compute_load_shares(load, body)))
          if (owns(level, share.dofs))
            add(share.dofs, factor * share.weight * load.vector);
        return;
      }
    std::vector<bool> selected(body.n_nodes(), false);
    for (const unsigned int node : load.nodes)
      selected[node] = true;
    level.for_elements([&](const DofLevel::Element &element) {
      const auto         &corners = body.elements()[element.place.element];
      std::array<bool, 8> of_corners;
      for (unsigned int v = 0; v < 8; ++v)
        of_corners[v] = selected[corners[v]];
      const Eigen::VectorXd masses =
        compute_selected_masses(level.element_nodes(element),
                                body.material(element.place.element).density,
                                level.degree(),
                                of_corners);
      for (std::size_t a = 0; a < element.points.size(); ++a)
        if (masses[a] != 0.)
          add(element.points[a], factor * masses[a] * load.vector);
    });
  }

  void DistributedLoads::add_load(const Load &load, const double factor)
  {
    if (load.kind == LoadKind::pressure)
      add_pressure(load, factor);
    else if (load.kind == LoadKind::acceleration)
      add_acceleration(load, factor);
    else if (load.kind == LoadKind::force || load.kind == LoadKind::moment)
      {
        const std::vector<Share> shares = find_shares(load);
        std::vector<double>      weights;
        std::vector<Vector3>     places;
        for (const Share &share : shares)
          {
            weights.push_back(share.weight);
            places.push_back(place_of(share));
          }
        const auto is_mine = [&](const std::size_t i) {
          return owns(space_.level(), shares[i].dofs);
        };
        if (load.kind == LoadKind::force)
          {
            for (std::size_t i = 0; i < shares.size(); ++i)
              if (is_mine(i))
                add(shares[i].dofs, factor * weights[i] * load.vector);
            return;
          }
        const MeanMotion         set(std::move(weights), places, "load \"" + load.name + "\"");
        const MeanMotion::Motion motion = set.at_rest();
        for (std::size_t i = 0; i < shares.size(); ++i)
          if (is_mine(i))
            add(shares[i].dofs, factor * set.force(i, motion, Vector3::Zero(), load.vector));
      }
  }

  void DistributedLoads::add_torque(const Torque &torque, const double value)
  {
    const Body &body       = space_.body();
    const auto  tangent_at = [&](const Share &share) {
      return Vector3(body.axis.direction.cross(place_of(share) - body.axis.point));
    };
    std::vector<Share> shares = list_nodes(torque.nodes, compute_torque_shares(torque, body));
    if (const auto faces = find_boundary_faces(body, torque.nodes); integrates() && !faces.empty())
      {
        shares        = find_areas(faces);
        double moment = 0;
        for (const Share &share : shares)
          moment += share.weight * tangent_at(share).norm();
        for (Share &share : shares)
          share.weight /= moment;
      }
    for (const Share &share : shares)
      {
        const Vector3 tangent = tangent_at(share);
        if (tangent.norm() > on_axis_distance && owns(space_.level(), share.dofs))
          add(share.dofs, value * share.weight * tangent.normalized());
      }
  }
} // namespace vfife
