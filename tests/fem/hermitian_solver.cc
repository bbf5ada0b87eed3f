// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// Dense indefinite Hermitian matrices: answers, and numbers of negative eigenvalues against
// Eigen's.
#include "../tests.h"

#include <vfife/base/errors.h>
#include <vfife/fem/solvers/hermitian_solver.h>

#include <Eigen/Eigenvalues>

#include <cmath>
#include <complex>

using namespace vfife;
using Eigen::MatrixXcd;

/** Entries of all sizes; @p diagonal times the identity is added. */
MatrixXcd make_hermitian(const Eigen::Index n, const double diagonal)
{
  MatrixXcd A(n, n);
  for (Eigen::Index i = 0; i < n; ++i)
    for (Eigen::Index k = 0; k < n; ++k)
      A(i, k) = {std::sin(1. + 3. * i + 7. * k), std::cos(2. + 5. * i - 11. * k * k)};
  MatrixXcd H = A + A.adjoint();
  H.diagonal().setZero();
  return H + diagonal * MatrixXcd::Identity(n, n);
}

void compare(const std::string &name, const MatrixXcd &A)
{
  const HermitianSolver                          solver(A);
  const Eigen::SelfAdjointEigenSolver<MatrixXcd> eigen(A);
  const auto n_negative = (eigen.eigenvalues().array() < 0.).count();
  check(name + ": negative eigenvalues", solver.n_negative() == n_negative);
  const MatrixXcd B = make_hermitian(A.rows(), 1.).leftCols(3);
  check_below(name + ": answers", (A * solver.solve(B) - B).norm() / B.norm(), 1e-10);
}

int main()
{
  for (const double diagonal : {-100., -20., -3., 0., 5., 30.})
    compare("diagonal " + std::to_string(diagonal), make_hermitian(41, diagonal));
  // No pivot of one row.
  MatrixXcd two = MatrixXcd::Zero(2, 2);
  two(0, 1)     = {0., 2.};
  two(1, 0)     = {0., -2.};
  compare("zero diagonal", two);
  bool refused = false;
  try
    {
      HermitianSolver(MatrixXcd::Zero(3, 3));
    }
  catch (const NumericalError &)
    {
      refused = true;
    }
  check("singular matrix is refused", refused);
  return 0;
}
