// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/fem/solvers/hermitian_solver.h>

#include <deal.II/lac/lapack_support.h>

#include <complex>
#include <type_traits>
#include <utility>

using Complex = std::complex<double>;
static_assert(std::is_same_v<dealii::types::blas_int, int>, "pivots are kept as integers");

// deal.II declares no LAPACK functions of indefinite Hermitian matrices.
extern "C"
{
  void DEAL_II_FORTRAN_MANGLE(zhetrf, ZHETRF)(const char *uplo,
                                              const int  *n,
                                              Complex    *a,
                                              const int  *lda,
                                              int        *pivots,
                                              Complex    *work,
                                              const int  *n_work,
                                              int        *info);
  void DEAL_II_FORTRAN_MANGLE(zhetrs, ZHETRS)(const char    *uplo,
                                              const int     *n,
                                              const int     *n_right_sides,
                                              const Complex *a,
                                              const int     *lda,
                                              const int     *pivots,
                                              Complex       *b,
                                              const int     *ldb,
                                              int           *info);
}

namespace vfife
{
  HermitianSolver::HermitianSolver(Eigen::MatrixXcd matrix)
    : factors_(std::move(matrix))
    , pivots_(factors_.rows())
  {
    constexpr int        block = 64; // columns that LAPACK works on at once
    const int            n = factors_.rows(), n_work = block * n;
    std::vector<Complex> work(n_work);
    int                  info = 0;
    DEAL_II_FORTRAN_MANGLE(zhetrf, ZHETRF)
    ("L", &n, factors_.data(), &n, pivots_.data(), work.data(), &n_work, &info);
    if (info != 0)
      throw NumericalError("the stiffness of a sector's borders is singular (LAPACK info = " +
                           std::to_string(info) + ")");
  }

  Eigen::MatrixXcd HermitianSolver::solve(Eigen::MatrixXcd B) const
  {
    const int n = factors_.rows(), n_columns = B.cols();
    int       info = 0;
    DEAL_II_FORTRAN_MANGLE(zhetrs, ZHETRS)
    ("L", &n, &n_columns, factors_.data(), &n, pivots_.data(), B.data(), &n, &info);
    return B;
  }

  unsigned int HermitianSolver::n_negative() const
  {
    // Blocks of two rows, with negative pivots, have one eigenvalue of each sign (Bunch and Kaufman
    // 1977).
    unsigned int n = 0;
    for (std::size_t i = 0; i < pivots_.size(); ++i)
      if (pivots_[i] < 0)
        {
          ++n;
          ++i;
        }
      else if (factors_(i, i).real() < 0)
        ++n;
    return n;
  }
} // namespace vfife
