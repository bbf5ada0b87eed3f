// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_fem_solvers_eigen_solver_h
#define vfife_fem_solvers_eigen_solver_h

#include <vfife/fem/solvers/columns.h>

namespace vfife
{
  class DirectSolver;

  /** Pairs of K x = lambda M x, ascending, x^T M x = 1. */
  struct EigenPairs
  {
    std::vector<double>      values;
    std::vector<OwnedVector> vectors;
    unsigned int             n_iterations = 0;
  };

  /**
   * The @p n eigenvalues above @p shift that are nearest to it, by block Krylov-Schur (Anasazi) on
   * (K - shift M)^-1 M; @p factors are those of K - shift M, which must be positive definite.
   * Throws NumericalError where it does not converge. Collective.
   */
  EigenPairs solve_shift_invert(const FemMatrix    &mass,
                                const DirectSolver &factors,
                                double              shift,
                                unsigned int        n,
                                double              tolerance);

  /** M of an eigenvalue problem, with what start vectors depend on. */
  struct MassOperator
  {
    const ColumnOperator &apply;
    OwnedVector           diagonal;      ///< owned entries, zero where nothing moves
    unsigned int          first_row = 0; ///< of them
    const Communicator   &communicator;
  };

  /** The @p n eigenvalues nearest to @p shift, on both sides of it; @p inverse is
   * (K - shift M)^-1 M. */
  EigenPairs solve_shift_invert(const MassOperator   &mass,
                                const ColumnOperator &inverse,
                                double                shift,
                                unsigned int          n,
                                double                tolerance);

  /**
   * The @p n lowest eigenvalues by LOBPCG (Anasazi) with multigrid for K - shift M, which must be
   * positive definite, of a system with padded unknowns. Collective.
   */
  EigenPairs solve_lobpcg(const FemMatrix                &stiffness,
                          const FemMatrix                &mass,
                          const std::vector<OwnedVector> &near_kernel,
                          double                          shift,
                          unsigned int                    n,
                          double                          tolerance);

  /** The same of A = K - shift M and about its inverse. */
  EigenPairs solve_lobpcg(const MassOperator   &mass,
                          const ColumnOperator &A,
                          const ColumnOperator &inverse,
                          double                shift,
                          unsigned int          n,
                          double                tolerance);

  /** |K x - lambda M x| / (max(|lambda|, |scale|) |M x|) of each pair. Collective. */
  std::vector<double> compute_residuals(const FemMatrix  &stiffness,
                                        const FemMatrix  &mass,
                                        const EigenPairs &pairs,
                                        double            scale);
  std::vector<double> compute_residuals(const ColumnOperator &stiffness,
                                        const ColumnOperator &mass,
                                        const Communicator   &communicator,
                                        const EigenPairs     &pairs,
                                        double                scale);

  /** Largest |x_i^T M x_j - delta_ij|. Collective. */
  double compute_orthogonality_defect(const FemMatrix                &mass,
                                      const std::vector<OwnedVector> &vectors);
  double compute_orthogonality_defect(const ColumnOperator           &mass,
                                      const Communicator             &communicator,
                                      const std::vector<OwnedVector> &vectors);
} // namespace vfife

#endif
