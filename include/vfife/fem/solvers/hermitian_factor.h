// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_fem_solvers_hermitian_factor_h
#define vfife_fem_solvers_hermitian_factor_h

#include <Eigen/Core>

namespace vfife
{
  /** L L^H of a dense Hermitian matrix by LAPACK on this rank alone. */
  class HermitianFactor
  {
  public:
    /** Of @p matrix the lower triangle is read. */
    explicit HermitianFactor(Eigen::MatrixXcd matrix);

    /** Whether the matrix is positive definite; otherwise there is no factor. */
    bool is_positive() const
    {
      return positive_;
    }

    /** L L^H X = B, a column each. */
    Eigen::MatrixXcd solve(Eigen::MatrixXcd B) const;

    /** B^H (L L^H)^-1 B. */
    Eigen::MatrixXcd project(Eigen::MatrixXcd B) const;

    double memory() const
    {
      return 16e-6 * L_.size(); ///< [MB]
    }

  private:
    Eigen::MatrixXcd L_;
    bool             positive_;
  };
} // namespace vfife

#endif
