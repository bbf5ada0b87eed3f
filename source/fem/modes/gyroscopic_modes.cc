// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/complex.h>
#include <vfife/base/errors.h>
#include <vfife/fem/modes/gyroscopic_modes.h>
#include <vfife/fem/solvers/direct_solver.h>
#include <vfife/fem/solvers/sparse_matrix.h>

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>

namespace vfife
{
  namespace
  {
    /** Sum of the basis with coefficients. */
    OwnedVector combine(const std::vector<OwnedVector> &basis, const Eigen::VectorXd &coefficients)
    {
      OwnedVector sum(basis.front().size(), 0.);
      for (std::size_t k = 0; k < basis.size(); ++k)
        for (std::size_t i = 0; i < sum.size(); ++i)
          sum[i] += coefficients[k] * basis[k][i];
      return sum;
    }

    /** An M-orthonormal basis of the span of @p vectors; what depends on others is left out. */
    std::vector<OwnedVector> orthonormal_basis(const SparseMatrix             &mass,
                                               const std::vector<OwnedVector> &vectors)
    {
      // With G = V^T M V = Y diag(g) Y^T, the columns of V Y diag(g)^-1/2 are orthonormal.
      // All vectors have length one before; parts below 1e-4 of that (1e-8 of g) are taken
      // for dependence.
      Eigen::MatrixXd       gram  = mass.project(vectors, vectors);
      const Eigen::VectorXd scale = gram.diagonal().cwiseSqrt().cwiseInverse();
      gram                        = scale.asDiagonal() * gram * scale.asDiagonal();
      const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> parts(gram);
      std::vector<OwnedVector>                             basis;
      for (int k = 0; k < gram.rows(); ++k)
        if (parts.eigenvalues()[k] > 1e-8)
          basis.push_back(combine(vectors,
                                  scale.asDiagonal() * parts.eigenvectors().col(k) /
                                    std::sqrt(parts.eigenvalues()[k])));
      return basis;
    }
  } // namespace

  std::vector<GyroscopicMode> find_gyroscopic_modes(const Assembly                 &assembly,
                                                    const SparseValues             &stiffness,
                                                    const SparseValues             &mass,
                                                    const SparseValues             &coriolis,
                                                    const DirectSolver             &factors,
                                                    const std::vector<OwnedVector> &modes,
                                                    const double                    rigid_rate,
                                                    const unsigned int              n)
  {
    // A small basis first: the modes x, and K^-1 C x, which a wave begins to take up when
    // Coriolis forces set in.
    const SparseMatrix       K(assembly, stiffness), M(assembly, mass), C(assembly, coriolis);
    std::vector<OwnedVector> vectors = modes;
    for (const OwnedVector &mode : modes)
      {
        vectors.push_back(C.apply(mode));
        factors.solve(vectors.back().data(), 1);
      }
    const std::vector<OwnedVector> basis = orthonormal_basis(M, vectors);

    // States (q, q'/scale): all blocks are then of the size of the largest frequency.
    const int             size = basis.size();
    const Eigen::MatrixXd k = K.project(basis, basis), c = C.project(basis, basis);
    const double          scale  = std::sqrt(k.diagonal().cwiseAbs().maxCoeff());
    Eigen::MatrixXd       linear = Eigen::MatrixXd::Zero(2 * size, 2 * size);
    // q'' = -k q - 2 c q' with M = 1 in this basis; k is made symmetric and c skew exactly.
    linear.topRightCorner(size, size)    = scale * Eigen::MatrixXd::Identity(size, size);
    linear.bottomLeftCorner(size, size)  = -.5 / scale * (k + k.transpose());
    linear.bottomRightCorner(size, size) = c.transpose() - c;
    const Eigen::EigenSolver<Eigen::MatrixXd> solver(linear);

    // Eigenvalues come in pairs i omega, -i omega of one wave, and with a growing motion comes its
    // decaying mirror image: only the growing one is looked for.
    std::vector<std::pair<double, int>> order;
    for (int k = 0; k < 2 * size; ++k)
      {
        const Complex value = solver.eigenvalues()[k];
        if (std::abs(value) < rigid_rate)
          continue;
        if (value.real() > 1e-6 * std::abs(value) + 1e-3 * rigid_rate)
          throw NumericalError(
            "with Coriolis forces a motion of the body grows: it is not stable at this speed");
        if (value.imag() > 0)
          order.emplace_back(value.imag(), k);
      }
    std::sort(order.begin(), order.end());
    order.resize(std::min<std::size_t>(order.size(), n));

    // Back to all unknowns; the residual is that of the full problem, so it shows what
    // the basis misses.
    std::vector<GyroscopicMode> waves;
    for (const auto &entry : order)
      {
        const Eigen::VectorXcd x = solver.eigenvectors().col(entry.second).head(size).normalized();
        GyroscopicMode         wave;
        wave.rate            = entry.first;
        wave.real            = combine(basis, x.real());
        wave.imaginary       = combine(basis, x.imag());
        const OwnedVector Kr = K.apply(wave.real), Ki = K.apply(wave.imaginary),
                          Mr = M.apply(wave.real), Mi = M.apply(wave.imaginary),
                          Cr = C.apply(wave.real), Ci = C.apply(wave.imaginary);
        // (K - w^2 M + 2 i w C)(r + i s): real part K r - w^2 M r - 2 w C s, imaginary part K s -
        // w^2 M s + 2 w C r.
        const double w = wave.rate;
        OwnedVector  rest_real(Kr), rest_imaginary(Ki);
        for (std::size_t i = 0; i < Kr.size(); ++i)
          {
            rest_real[i] += -w * w * Mr[i] - 2. * w * Ci[i];
            rest_imaginary[i] += -w * w * Mi[i] + 2. * w * Cr[i];
          }
        const auto square = [&](const OwnedVector &a, const OwnedVector &b) {
          return assembly.dot(a, a) + assembly.dot(b, b);
        };
        const double kinetic =
          w * w * (assembly.dot(wave.real, Mr) + assembly.dot(wave.imaginary, Mi));
        const double elastic = assembly.dot(wave.real, Kr) + assembly.dot(wave.imaginary, Ki);
        wave.kinetic_share   = kinetic / (kinetic + elastic);
        wave.residual = std::sqrt(square(rest_real, rest_imaginary) / square(Mr, Mi)) / (w * w);
        waves.push_back(std::move(wave));
      }
    return waves;
  }
} // namespace vfife
