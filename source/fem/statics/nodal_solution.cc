// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/fem/statics/nodal_solution.h>
#include <vfife/fem/system/bearing_rings.h>
#include <vfife/fem/system/fem_constraints.h>
#include <vfife/fem/system/load_forces.h>
#include <vfife/model/constraints/supports.h>

#include <algorithm>

namespace vfife
{
  std::vector<Reaction> compute_reactions(const FemSpace &space, const StaticResult &result)
  {
    const Model          &model = space.model();
    std::vector<Reaction> reactions(list_supports(model).size());
    const auto            at = [](const std::vector<double> &field, const unsigned int p) {
      return Vector3(Eigen::Map<const Vector3>(field.data() + 3 * std::size_t(p)));
    };
    // 1. Constraints: what is out of balance at their points.
    for (const auto &[p, constraints] : find_point_constraints(space))
      {
        const Vector3 &place = space.points()[p];
        for (const auto &[constraint, part] : constraints.share(at(result.reactions, p), place))
          reactions[constraint - model.constraints.data()].add(place, part);
      }
    // 2. Springs, which follow the constraints: -k u.
    std::size_t s = model.constraints.size();
    for (const Load &load : model.loads)
      if (load.kind == LoadKind::spring)
        {
          for (const auto &[p, stiffness] : find_springs(load, space))
            reactions[s].add(space.points()[p], -stiffness * at(result.displacements, p));
          ++s;
        }
    // 3. Bearings and couplings: preload - K B u on the points of their rings.
    std::vector<double>   forces(result.displacements.size(), 0.);
    const BearingRings    rings(space);
    const Eigen::VectorXd loads = rings.preload() - rings.stiffness([&](const unsigned int body) {
      return result.turns ? model.bodies[body].rate : 0.;
    }) * rings.displacement(result.displacements);
    for (std::size_t r = 0; r < rings.list().size(); ++r)
      {
        const BearingRing &ring = rings.list()[r];
        ring.add_forces(loads.segment<6>(6 * r), forces);
        for (const unsigned int p : ring.points)
          {
            reactions[ring.support].add(space.points()[p], at(forces, p));
            Eigen::Map<Vector3>(forces.data() + 3 * std::size_t(p)).setZero();
          }
      }
    return reactions;
  }

  NodalSolution make_nodal_solution(const StaticSolver &solver, const StaticResult &result)
  {
    const FemSpace            &space = solver.space();
    const Model               &model = space.model();
    const std::vector<double> &u     = result.displacements;
    NodalSolution              solution;
    solution.displacements.assign(3 * std::size_t(model.n_nodes()), 0.);
    for (const FemSpace::Part &part : space.parts())
      {
        // Points of a body are in the order of its nodes.
        const Body &body = model.bodies[part.body];
        std::copy_n(u.begin() + 3 * std::size_t(part.first_point),
                    3 * std::size_t(body.n_nodes()),
                    solution.displacements.begin() + 3 * std::size_t(body.first_node));
      }
    for (std::size_t i = 0; i < u.size(); i += 3)
      solution.largest_displacement =
        std::max(solution.largest_displacement, Eigen::Map<const Vector3>(u.data() + i).norm());
    solution.point_stresses  = compute_stresses(space, u);
    solution.stresses        = take_nodes(space, solution.point_stresses);
    solution.reactions       = compute_reactions(space, result);
    solution.strain_energy   = result.strain_energy;
    solution.n_displacements = u.size();
    solution.n_iterations    = result.n_iterations;
    return solution;
  }
} // namespace vfife
