// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/fem/solvers/hermitian_factor.h>

#include <deal.II/lac/lapack_templates.h>

#include <complex>
#include <utility>

// LAPACK and BLAS take the instructions of the machine, which Eigen, compiled for all of them, does
// not.
namespace vfife
{
  using Integer = dealii::types::blas_int;

  HermitianFactor::HermitianFactor(Eigen::MatrixXcd matrix)
    : L_(std::move(matrix))
  {
    const Integer n    = L_.rows();
    Integer       info = 0;
    dealii::potrf("L", &n, L_.data(), &n, &info);
    positive_ = info == 0;
  }

  Eigen::MatrixXcd HermitianFactor::solve(Eigen::MatrixXcd B) const
  {
    const Integer n = L_.rows(), n_columns = B.cols();
    Integer       info = 0;
    dealii::potrs("L", &n, &n_columns, L_.data(), &n, B.data(), &n, &info);
    return B;
  }

  Eigen::MatrixXcd HermitianFactor::project(Eigen::MatrixXcd B) const
  {
    const Integer n = L_.rows(), n_columns = B.cols();
    Integer       info = 0;
    dealii::trtrs("L", "N", "N", &n, &n_columns, L_.data(), &n, B.data(), &n, &info);
    const std::complex<double> one = 1., zero = 0.;
    Eigen::MatrixXcd           product(n_columns, n_columns);
    dealii::gemm("C",
                 "N",
                 &n_columns,
                 &n_columns,
                 &n,
                 &one,
                 B.data(),
                 &n,
                 B.data(),
                 &n,
                 &zero,
                 product.data(),
                 &n_columns);
    return product;
  }
} // namespace vfife
