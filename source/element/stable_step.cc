// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/element/stable_step.h>

#include <Eigen/Eigenvalues>

#include <cmath>

namespace vfife
{
  double compute_largest_frequency(const Matrix24 &K, const Eigen::Matrix<double, 8, 1> &mass)
  {
    if (!(mass.minCoeff() > 0.))
      throw NumericalError("An element is too distorted: one of its nodes has no mass.");
    // K x = omega^2 M x as the symmetric problem of M^-1/2 K M^-1/2;
    // eigenvalues come in rising order.
    Vector24 scale;
    for (unsigned int a = 0; a < 8; ++a)
      scale.segment<3>(3 * a).setConstant(1. / std::sqrt(mass[a]));
    const Matrix24 scaled = scale.asDiagonal() * K * scale.asDiagonal();
    const Eigen::SelfAdjointEigenSolver<Matrix24> solver(scaled, Eigen::EigenvaluesOnly);
    return std::sqrt(solver.eigenvalues()[23]);
  }
} // namespace vfife
