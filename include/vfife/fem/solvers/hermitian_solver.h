// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_fem_solvers_hermitian_solver_h
#define vfife_fem_solvers_hermitian_solver_h

#include <Eigen/Core>

#include <vector>

namespace vfife
{
  /** L D L^H of a dense Hermitian matrix, which may be indefinite, by LAPACK on this rank alone. */
  class HermitianSolver
  {
  public:
    /** Of @p matrix the lower triangle is read. Throws NumericalError where it is singular. */
    explicit HermitianSolver(Eigen::MatrixXcd matrix);

    /** A^-1 B, a column each. */
    Eigen::MatrixXcd solve(Eigen::MatrixXcd B) const;

    /** Negative eigenvalues. */
    unsigned int n_negative() const;

    double memory() const
    {
      return 16e-6 * factors_.size(); ///< [MB]
    }

  private:
    Eigen::MatrixXcd factors_;
    std::vector<int> pivots_; ///< as zhetrf numbers them
  };
} // namespace vfife

#endif
