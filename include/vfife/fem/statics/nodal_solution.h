// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_fem_statics_nodal_solution_h
#define vfife_fem_statics_nodal_solution_h

#include <vfife/fem/statics/static_solver.h>
#include <vfife/model/state.h>

#include <vector>

namespace vfife
{
  /** A static solution at the nodes of a model, equal on all ranks; zeros on bodies that are not
   * part of it. */
  struct NodalSolution
  {
    std::vector<double>   displacements;            ///< 3 a node, fixed frame [mm]
    std::vector<Stress>   stresses;                 ///< as compute_node_stresses()
    std::vector<Stress>   point_stresses;           ///< compute_stresses(); none where distributed
    std::vector<Reaction> reactions;                ///< in the order of list_supports()
    double                strain_energy        = 0; ///< StaticResult [mJ]
    double                largest_displacement = 0; ///< of all points [mm]
    std::size_t           n_displacements      = 0; ///< components of all points
    unsigned int          n_iterations         = 0; ///< 0: direct solver
  };

  /** What the supports of the model (list_supports()) exert in a static solution, on the bodies at
   * their undeformed places; zero on bodies that are not part of the space. */
  std::vector<Reaction> compute_reactions(const FemSpace &space, const StaticResult &result);

  NodalSolution make_nodal_solution(const StaticSolver &solver, const StaticResult &result);
} // namespace vfife

#endif
