// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_fem_solvers_multigrid_solver_h
#define vfife_fem_solvers_multigrid_solver_h

#include <vfife/fem/solvers/columns.h>

#include <memory>

namespace vfife
{
  /**
   * Conjugate gradients, preconditioned by smoothed aggregation (deal.II's PreconditionAMG) whose
   * coarse spaces hold the rigid motions. For positive definite matrices of a system with padded
   * unknowns. Collective.
   */
  class MultigridSolver
  {
  public:
    /**
     * @p near_kernel: owned parts of the six rigid motions of each body. Throws InputError where
     * deal.II has no such preconditioner.
     */
    MultigridSolver(const FemMatrix &matrix, const std::vector<OwnedVector> &near_kernel);
    ~MultigridSolver();
    MultigridSolver(const MultigridSolver &)            = delete;
    MultigridSolver &operator=(const MultigridSolver &) = delete;

    /**
     * Solves until the residual is @p tolerance of the right side. Throws NumericalError with the
     * residual reached when that takes more than 1000 iterations or breaks down.
     */
    OwnedVector solve(const OwnedVector &right_side, double tolerance);

    unsigned int n_iterations() const
    {
      return n_iterations_;
    }

    /** The matrix. */
    const ColumnOperator &matrix() const;

    /** One cycle of multigrid: about the inverse of the matrix. */
    const ColumnOperator &cycle() const;

  private:
    struct Operators;

    std::unique_ptr<Operators> operators_;
    unsigned int               n_iterations_ = 0;
  };
} // namespace vfife

#endif
