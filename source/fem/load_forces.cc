// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/fem/load_forces.h>
#include <vfife/model/load_shares.h>

namespace vfife
{
  void add_load_forces(const Load                 &load,
                       const Discretization       &discretization,
                       const Discretization::Part &part,
                       const double                factor,
                       std::vector<double>        &forces)
  {
    const Body &body  = discretization.model().bodies[load.body];
    const auto  point = [&](const unsigned int node) { return part.first_point + node; };
    const auto  add   = [&](const unsigned int node, const Vector3 &force) {
      Eigen::Map<Vector3>(forces.data() + 3 * std::size_t(point(node))) += factor * force;
    };
    const auto place = [&](const unsigned int node) {
      return discretization.points()[point(node)];
    };
    const std::vector<double> shares = compute_load_shares(load, body);
    switch (load.kind)
      {
      case LoadKind::force:
      case LoadKind::acceleration:
        for (std::size_t i = 0; i < load.nodes.size(); ++i)
          add(load.nodes[i], shares[i] * load.vector);
        break;
      case LoadKind::moment:
        {
          MomentSums sums;
          for (std::size_t i = 0; i < load.nodes.size(); ++i)
            sums.add(shares[i], place(load.nodes[i]));
          const auto [centre, turn] = sums.solve(load.vector, load.name);
          for (std::size_t i = 0; i < load.nodes.size(); ++i)
            add(load.nodes[i], shares[i] * turn.cross(place(load.nodes[i]) - centre));
          break;
        }
      case LoadKind::pressure:
        for (const BoundaryFace &face : find_boundary_faces(body, load.nodes))
          {
            const auto   &n = face.nodes;
            const Vector3 area =
              compute_vector_area(place(n[0]), place(n[1]), place(n[2]), place(n[3]));
            for (const unsigned int node : n)
              add(node, -0.25 * load.pressure * area);
          }
        break;
      case LoadKind::spring: // see find_springs()
        break;
      }
  }

  std::vector<std::pair<unsigned int, Matrix3>> find_springs(const Discretization &discretization)
  {
    std::vector<std::pair<unsigned int, Matrix3>> springs;
    const Model                                  &model = discretization.model();
    for (const Load &load : model.loads)
      {
        const Discretization::Part *part = discretization.find_part(load.body);
        if (load.kind != LoadKind::spring || part == nullptr)
          continue;
        if (discretization.sector_angle() > 0)
          throw InputError("spring \"" + load.name +
                           "\": springs to the ground need the whole body, not one sector of it");
        const std::vector<double> shares = compute_load_shares(load, model.bodies[load.body]);
        for (std::size_t i = 0; i < load.nodes.size(); ++i)
          springs.emplace_back(part->first_point + load.nodes[i],
                               Matrix3((shares[i] * load.vector).asDiagonal()));
      }
    return springs;
  }
} // namespace vfife
