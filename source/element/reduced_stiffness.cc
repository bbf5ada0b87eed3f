// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/element/frame.h>
#include <vfife/element/reduced_stiffness.h>

#include <Eigen/LU>

namespace vfife
{
  namespace
  {
    using Matrix12x24 = Eigen::Matrix<double, 12, 24>;

    HexahedronNodes gradients_of(const ReducedStiffness &reduced)
    {
      HexahedronNodes b;
      for (unsigned int a = 0; a < 8; ++a)
        for (unsigned int j = 0; j < 3; ++j)
          b(j, a) = reduced.gradient[a][j];
      return b;
    }

    /** gamma_k(a), one row a pattern. */
    Eigen::Matrix<double, 4, 8> patterns_of(const ReducedStiffness &reduced)
    {
      Eigen::Matrix<double, 4, 8> gamma;
      for (unsigned int k = 0; k < 4; ++k)
        for (unsigned int a = 0; a < 8; ++a)
          {
            gamma(k, a) = hourglass_sign(k, a);
            for (unsigned int j = 0; j < 3; ++j)
              gamma(k, a) -= reduced.pattern_coefficient[k][j] * reduced.gradient[a][j];
          }
      return gamma;
    }

    /** V B^T D B of the mean gradients. */
    Matrix24 mean_stiffness(const ReducedStiffness &reduced, const Material &material)
    {
      const Eigen::MatrixXd B = compute_strain_matrix(gradients_of(reduced));
      return reduced.volume * B.transpose() * compute_elasticity(material) * B;
    }

    /** 3 k + i, 3 a + i: the same factors for each component. */
    Matrix12x24 for_each_component(const Eigen::Matrix<double, 4, 8> &factors)
    {
      Matrix12x24 matrix = Matrix12x24::Zero();
      for (unsigned int k = 0; k < 4; ++k)
        for (unsigned int a = 0; a < 8; ++a)
          for (unsigned int i = 0; i < 3; ++i)
            matrix(3 * k + i, 3 * a + i) = factors(k, a);
      return matrix;
    }
  } // namespace

  ReducedStiffness compute_reduced_stiffness(const HexahedronNodes &X,
                                             const Material        &material,
                                             const StiffnessKind    kind)
  {
    // The numbers of the mean strain: V, b(a), and c_kj = sum_a h_k(a) X_j(a),
    // the linear part of the patterns.
    const Matrix24        K     = compute_stiffness(X, material, kind);
    const HexahedronNodes b     = compute_mean_gradients(X);
    const Matrix3         triad = compute_triad(X);

    ReducedStiffness reduced;
    reduced.volume = compute_volume(X);
    for (unsigned int a = 0; a < 8; ++a)
      for (unsigned int j = 0; j < 3; ++j)
        reduced.gradient[a][j] = b(j, a);
    for (unsigned int k = 0; k < 4; ++k)
      for (unsigned int j = 0; j < 3; ++j)
        {
          // Relative to node 0, since the signs sum to zero: less cancellation far from the origin.
          reduced.pattern_coefficient[k][j] = 0.;
          for (unsigned int a = 1; a < 8; ++a)
            reduced.pattern_coefficient[k][j] += hourglass_sign(k, a) * (X(j, a) - X(j, 0));
        }
    for (unsigned int i = 0; i < 3; ++i)
      for (unsigned int j = 0; j < 3; ++j)
        reduced.triad[i][j] = triad(i, j);

    // Fields w_l dual to the patterns, gamma_k . w_l = delta_kl: H is what K minus its mean part
    // does to them.
    const Eigen::Matrix<double, 4, 8> gamma = patterns_of(reduced);
    const Eigen::Matrix4d             gram  = gamma * gamma.transpose();
    // With W = (gamma gamma^T)^-1 gamma, gamma_k . w_l = delta_kl
    // holds; G W^T = I, so W K' W^T = H.
    const Matrix12x24                   W = for_each_component(gram.inverse() * gamma);
    const Eigen::Matrix<double, 12, 12> H =
      W * (K - mean_stiffness(reduced, material)) * W.transpose();
    // Round-off leaves H symmetric only nearly; the kernels read its upper triangle, row by row.
    double *entry = reduced.hourglass_stiffness;
    for (unsigned int row = 0; row < 12; ++row)
      for (unsigned int column = row; column < 12; ++column)
        *entry++ = 0.5 * (H(row, column) + H(column, row));
    return reduced;
  }

  Matrix24 expand(const ReducedStiffness &reduced, const Material &material)
  {
    Eigen::Matrix<double, 12, 12> H;
    const double                 *entry = reduced.hourglass_stiffness;
    for (unsigned int row = 0; row < 12; ++row)
      for (unsigned int column = row; column < 12; ++column)
        H(row, column) = H(column, row) = *entry++;
    const Matrix12x24 G = for_each_component(patterns_of(reduced));
    return mean_stiffness(reduced, material) + G.transpose() * H * G;
  }

  void write_constants(const ReducedStiffness &reduced, const Material &material, double *out)
  {
    for (unsigned int a = 1; a < 8; ++a)
      for (unsigned int j = 0; j < 3; ++j)
        *out++ = reduced.gradient[a][j];
    for (unsigned int k = 0; k < 4; ++k)
      for (unsigned int j = 0; j < 3; ++j)
        *out++ = reduced.pattern_coefficient[k][j];
    *out++ = reduced.volume * material.lambda();
    *out++ = reduced.volume * 2. * material.mu();
    for (const double entry : reduced.hourglass_stiffness)
      *out++ = entry;
    for (unsigned int i = 0; i < 3; ++i)
      for (unsigned int j = 0; j < 3; ++j)
        *out++ = reduced.triad[i][j];
  }
} // namespace vfife
