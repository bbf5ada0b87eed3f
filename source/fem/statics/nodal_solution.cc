// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/fem/statics/nodal_solution.h>
#include <vfife/fem/statics/reactions.h>

#include <algorithm>

namespace vfife
{
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
