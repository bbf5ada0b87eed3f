// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/fem/fem_options.h>

namespace vfife
{
  namespace
  {
    const Choices<LinearSolverKind> linear_solvers = {{"multigrid", LinearSolverKind::multigrid},
                                                      {"direct", LinearSolverKind::direct}};
    const Choices<EigenSolverKind> eigen_solvers = {{"shift-invert", EigenSolverKind::shift_invert},
                                                    {"lobpcg", EigenSolverKind::lobpcg}};
  } // namespace

  void FemOptions::declare(dealii::ParameterHandler &prm)
  {
    declare_choice(prm,
                   "element",
                   element,
                   fem_element_choices(),
                   "Eight nodes with incompatible modes or plain (locks in bending), or 27 nodes");
    declare_choice(prm, "mass", mass, mass_choices(), "Mass matrix of vibrations and of spin");
    declare_choice(prm,
                   "linear solver",
                   linear_solver,
                   linear_solvers,
                   "Conjugate gradients with algebraic multigrid, or factorization");
    declare_number(prm,
                   "linear tolerance",
                   linear_tolerance,
                   "Residual over load at which conjugate gradients stop",
                   Range::between(1e-14, 1e-2));
    declare_choice(
      prm,
      "eigenvalue solver",
      eigen_solver,
      eigen_solvers,
      "Krylov-Schur with shift and factorization, or LOBPCG with multigrid (less memory)");
    declare_number(prm,
                   "eigenvalue tolerance",
                   eigen_tolerance,
                   "Residual at which a mode is taken",
                   Range::between(1e-13, 1e-3));
    declare_integer(prm, "modes", n_modes, "Number of modes of each body", 1, 10000);
    declare_switch(prm,
                   "count modes",
                   count_modes,
                   "Whether a second factorization counts the modes below the highest one found "
                   "(shift-invert only)");
  }
} // namespace vfife
