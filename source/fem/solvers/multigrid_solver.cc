// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include "multigrid.h"

#include <vfife/base/errors.h>
#include <vfife/fem/solvers/multigrid_solver.h>

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wall"
#pragma GCC diagnostic ignored "-Wextra"
#include <AztecOO.h>
#include <Epetra_LinearProblem.h>
#include <Epetra_Vector.h>
#pragma GCC diagnostic pop

#include <sstream>

namespace vfife
{
  struct MultigridSolver::Operators
  {
    Operators(const Assembly                 &assembly,
              const SparseValues             &values,
              const std::vector<OwnedVector> &near_kernel)
      : map(make_map(assembly.pattern(), assembly.communicator()))
      , matrix(make_epetra_matrix(map, assembly.pattern(), values))
      , multigrid(*matrix, near_kernel)
    {
    }

    Epetra_Map                        map;
    std::unique_ptr<Epetra_CrsMatrix> matrix;
    Multigrid                         multigrid;
  };

  MultigridSolver::MultigridSolver(const Assembly                 &assembly,
                                   const SparseValues             &values,
                                   const std::vector<OwnedVector> &near_kernel)
    : operators_(std::make_unique<Operators>(assembly, values, near_kernel))
  {
  }

  MultigridSolver::~MultigridSolver() = default;

  OwnedVector MultigridSolver::solve(const OwnedVector &right_side, const double tolerance)
  {
    Epetra_Vector b(operators_->map), x(operators_->map), residual(operators_->map);
    std::copy(right_side.begin(), right_side.end(), b.Values());

    Epetra_LinearProblem problem(operators_->matrix.get(), &x, &b);
    AztecOO              solver(problem);
    solver.SetPrecOperator(operators_->multigrid.operators.get());
    solver.SetAztecOption(AZ_solver, AZ_cg);
    solver.SetAztecOption(AZ_output, AZ_none);
    // AZ_rhs: the residual is measured by the load.
    solver.SetAztecOption(AZ_conv, AZ_rhs);
    solver.Iterate(1000, tolerance);
    n_iterations_ = solver.NumIters();

    // The recursive residual of the iteration may drift from the true one.
    double rest = 0, size = 0;
    operators_->matrix->Multiply(false, x, residual);
    residual.Update(1., b, -1.);
    residual.Norm2(&rest);
    b.Norm2(&size);
    // Ten times: the residual that drifts a little is no failure.
    if (!(rest <= 10. * tolerance * size))
      {
        std::ostringstream text;
        text << "conjugate gradients stopped after " << n_iterations_
             << " iterations at a residual of " << rest / size << " of the load instead of "
             << tolerance;
        throw NumericalError(text.str());
      }
    return OwnedVector(x.Values(), x.Values() + right_side.size());
  }
} // namespace vfife
