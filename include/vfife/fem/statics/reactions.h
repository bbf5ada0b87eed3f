// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_fem_statics_reactions_h
#define vfife_fem_statics_reactions_h

#include <vfife/fem/statics/static_solver.h>
#include <vfife/model/state.h>

#include <vector>

namespace vfife
{
  /** What the supports of the model (list_supports()) exert in a static solution, on the bodies at
   * their undeformed places; zero on bodies that are not part of the space. */
  std::vector<Reaction> compute_reactions(const FemSpace &space, const StaticResult &result);
} // namespace vfife

#endif
