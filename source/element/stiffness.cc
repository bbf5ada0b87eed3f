// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/element/stiffness.h>

#include <Eigen/Cholesky>
#include <Eigen/LU>

namespace vfife
{
  const Choices<StiffnessKind> &stiffness_choices()
  {
    static const Choices<StiffnessKind> choices = {{"incompatible modes",
                                                    StiffnessKind::incompatible_modes},
                                                   {"full", StiffnessKind::full}};
    return choices;
  }


  Eigen::Matrix<double, 6, 6> compute_elasticity(const Material &material)
  {
    Eigen::Matrix<double, 6, 6> D = Eigen::Matrix<double, 6, 6>::Zero();
    D.topLeftCorner<3, 3>().setConstant(material.lambda());
    D.diagonal().head<3>().array() += 2. * material.mu();
    D.diagonal().tail<3>().setConstant(material.mu());
    return D;
  }


  Eigen::MatrixXd compute_strain_matrix(const Eigen::Matrix<double, 3, Eigen::Dynamic> &gradients)
  {
    Eigen::MatrixXd B = Eigen::MatrixXd::Zero(6, 3 * gradients.cols());
    for (int a = 0; a < gradients.cols(); ++a)
      for (int i = 0; i < 3; ++i)
        {
          const int next         = (i + 1) % 3;
          B(i, 3 * a + i)        = gradients(i, a);
          B(3 + i, 3 * a + i)    = gradients(next, a);
          B(3 + i, 3 * a + next) = gradients(i, a);
        }
    return B;
  }


  ElementStrains compute_element_strains(const HexahedronNodes &X, const StiffnessKind kind)
  {
    const Matrix3 centre_jacobian           = compute_jacobian(X, Vector3::Zero());
    const double  centre_determinant        = centre_jacobian.determinant();
    const Matrix3 centre_inverse_transposed = centre_jacobian.inverse().transpose();

    ElementStrains strains;
    strains.has_bubbles = kind == StiffnessKind::incompatible_modes;
    for (unsigned int q = 0; q < 8; ++q)
      {
        const Vector3         xi          = gauss_point(q);
        const HexahedronNodes gradients   = reference_gradients(xi);
        const Matrix3         jacobian    = X * gradients.transpose();
        const double          determinant = jacobian.determinant();
        if (!(determinant > 0.))
          throw NumericalError("An element is folded: its Jacobian determinant is " +
                               std::to_string(determinant) + " mm^3 at an integration point.");
        strains.weight[q]       = determinant;
        strains.displacement[q] = compute_strain_matrix(jacobian.inverse().transpose() * gradients);
        if (strains.has_bubbles)
          {
            const Matrix3 bubble_gradients = (-2. * xi).asDiagonal();
            strains.bubble[q] = compute_strain_matrix(centre_determinant / determinant *
                                                      centre_inverse_transposed * bubble_gradients);
          }
        else
          strains.bubble[q].setZero();
      }
    return strains;
  }


  Eigen::Matrix<double, 9, 24> compute_bubble_recovery(const ElementStrains &strains,
                                                       const Material       &material)
  {
    if (!strains.has_bubbles)
      return Eigen::Matrix<double, 9, 24>::Zero();

    const Eigen::Matrix<double, 6, 6> D  = compute_elasticity(material);
    Eigen::Matrix<double, 9, 9>       bb = Eigen::Matrix<double, 9, 9>::Zero();
    Eigen::Matrix<double, 9, 24>      bu = Eigen::Matrix<double, 9, 24>::Zero();
    for (unsigned int q = 0; q < 8; ++q)
      {
        const Eigen::Matrix<double, 9, 6> weighted =
          strains.weight[q] * strains.bubble[q].transpose() * D;
        bb += weighted * strains.bubble[q];
        bu += weighted * strains.displacement[q];
      }
    return -bb.ldlt().solve(bu);
  }


  Matrix24
  compute_stiffness(const HexahedronNodes &X, const Material &material, const StiffnessKind kind)
  {
    const Eigen::Matrix<double, 6, 6>  D       = compute_elasticity(material);
    const ElementStrains               strains = compute_element_strains(X, kind);
    const Eigen::Matrix<double, 9, 24> bubbles = compute_bubble_recovery(strains, material);

    // The condensed stiffness is that of the strains with the bubbles following the nodes.
    Matrix24 K = Matrix24::Zero();
    for (unsigned int q = 0; q < 8; ++q)
      {
        const Eigen::Matrix<double, 6, 24> B =
          strains.displacement[q] + strains.bubble[q] * bubbles;
        K += strains.weight[q] * B.transpose() * D * B;
      }
    return 0.5 * (K + K.transpose());
  }
} // namespace vfife
