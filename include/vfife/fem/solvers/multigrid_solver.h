// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_fem_solvers_multigrid_solver_h
#define vfife_fem_solvers_multigrid_solver_h

#include <vfife/fem/solvers/columns.h>

#include <deal.II/dofs/dof_handler.h>

#include <functional>
#include <memory>

namespace dealii
{
  template <typename>
  class AffineConstraints;
  template <typename>
  class FullMatrix;
} // namespace dealii

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

    /** Matrix of a cell, in the order of its degrees of freedom. */
    using CellMatrix = std::function<dealii::FullMatrix<double>(
      const dealii::DoFHandler<3>::active_cell_iterator &)>;

    /** Of a matrix that is summed over the cells of this rank, T^T A T with @p lines of T; the
     * three degrees of freedom of a point follow each other. */
    MultigridSolver(const dealii::DoFHandler<3>             &dofs,
                    const dealii::AffineConstraints<double> &lines,
                    const CellMatrix                        &cell_matrix,
                    const std::vector<OwnedVector>          &near_kernel,
                    const Communicator                      &communicator);
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

  /** Throws NumericalError with the residual reached (over the load) where conjugate gradients have
   * stopped far above @p tolerance. */
  void check_conjugate_gradients(double residual, unsigned int n_iterations, double tolerance);
} // namespace vfife

#endif
