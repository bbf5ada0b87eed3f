// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/element/stiffness.h>

#include <Eigen/Cholesky>
#include <Eigen/LU>

#include <array>

namespace vfife
{
  const Choices<StiffnessKind> &stiffness_choices()
  {
    static const Choices<StiffnessKind> choices = {
      {"incompatible modes", StiffnessKind::incompatible_modes},
      {"full integration", StiffnessKind::full},
      {"reduced integration", StiffnessKind::one_point}};
    return choices;
  }

  Eigen::Matrix<double, 6, 6> compute_elasticity(const Material &material)
  {
    // sigma = lambda tr(eps) I + 2 mu eps; engineering shears are twice
    // the tensor's, so mu alone there.
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
          // Row 3 + i is the shear of the axes i and i + 1: xy, yz, zx.
          const int next         = (i + 1) % 3;
          B(i, 3 * a + i)        = gradients(i, a);
          B(3 + i, 3 * a + i)    = gradients(next, a);
          B(3 + i, 3 * a + next) = gradients(i, a);
        }
    return B;
  }

  namespace
  {
    /** det J at the Gauss points [mm^3], all positive. */
    std::array<double, 8> compute_determinants(const HexahedronNodes &X)
    {
      std::array<double, 8> determinants;
      for (unsigned int q = 0; q < 8; ++q)
        {
          determinants[q] = compute_jacobian(X, gauss_point(q)).determinant();
          if (!(determinants[q] > 0.))
            throw NumericalError("An element is folded: its Jacobian determinant is " +
                                 std::to_string(determinants[q]) +
                                 " mm^3 at an integration point.");
        }
      return determinants;
    }

    /**
     * The gradients of the trilinear functions as if the element were the parallelepiped of its
     * centre, but for their means, which are exact: b + gamma_k (x) J0^-T dh_k/dxi / 8.
     */
    HexahedronNodes compute_parallelepiped_gradients(const HexahedronNodes &X,
                                                     const HexahedronNodes &mean,
                                                     const Matrix3 &centre_inverse_transposed,
                                                     const Vector3 &xi)
    {
      // The trilinear function of node a is 1/8 (1 + a . xi + sum_k h_k(a) h_k(xi)).
      HexahedronNodes gradients = mean;
      for (unsigned int k = 0; k < 4; ++k)
        {
          // dh_k/dxi_i: h_k is the product of the two coordinates other than k (h_3: of all three).
          Vector3 slope;
          for (unsigned int i = 0; i < 3; ++i)
            slope[i] = k == 3 ? xi[(i + 1) % 3] * xi[(i + 2) % 3] : k == i ? 0. : xi[3 - k - i];
          Eigen::Matrix<double, 1, 8> h;
          for (unsigned int a = 0; a < 8; ++a)
            h[a] = hourglass_sign(k, a);
          // gamma_k = h_k - c_k . b: no linear field feels it. c_k relative to
          // node 0, since h_k sums to zero.
          const Eigen::Matrix<double, 1, 8> gamma =
            h - (h * (X.colwise() - X.col(0).eval()).transpose()) * mean;
          gradients += centre_inverse_transposed * slope * gamma / 8.;
        }
      return gradients;
    }
  } // namespace

  ElementStrains compute_element_strains(const HexahedronNodes &X, const StiffnessKind kind)
  {
    const Matrix3               centre_jacobian           = compute_jacobian(X, Vector3::Zero());
    const Matrix3               centre_inverse_transposed = centre_jacobian.inverse().transpose();
    const std::array<double, 8> determinants              = compute_determinants(X);
    const HexahedronNodes       mean                      = compute_mean_gradients(X);
    const double                volume                    = compute_volume(X);

    ElementStrains strains;
    strains.has_bubbles = kind != StiffnessKind::full;
    for (unsigned int q = 0; q < 8; ++q)
      {
        // d(1 - xi_a^2)/dxi = -2 xi_a along axis a: column a of this matrix, in space, is the
        // gradient of bubble a, with the J0 of the centre.
        const Vector3 xi               = gauss_point(q);
        const Matrix3 bubble_gradients = centre_inverse_transposed * (-2. * xi).asDiagonal();
        // One point: the bubbles and the patterns see the parallelepiped of J0, whose det J is
        // constant; the real volume replaces 8 det J0.
        if (kind == StiffnessKind::one_point)
          {
            strains.weight[q]       = volume / 8.;
            strains.displacement[q] = compute_strain_matrix(
              compute_parallelepiped_gradients(X, mean, centre_inverse_transposed, xi));
            strains.bubble[q] = compute_strain_matrix(bubble_gradients);
            continue;
          }
        // QM6: J of the point for the nodes; det J0 / det J makes int grad dV of the bubbles
        // zero, which the patch test needs.
        const HexahedronNodes gradients = reference_gradients(xi);
        const Matrix3         jacobian  = X * gradients.transpose();
        strains.weight[q]               = determinants[q];
        strains.displacement[q] = compute_strain_matrix(jacobian.inverse().transpose() * gradients);
        if (strains.has_bubbles)
          strains.bubble[q] = compute_strain_matrix(centre_jacobian.determinant() /
                                                    determinants[q] * bubble_gradients);
        else
          strains.bubble[q].setZero();
      }
    return strains;
  }

  namespace
  {
    /** Kaa alpha + Kau u = 0, no force on the bubbles, for each column of @p strain_at(q): strains
     * of nodal displacements at Gauss point q. */
    template <int n, typename Strain>
    Eigen::Matrix<double, 9, n> balance_bubbles(const ElementStrains &strains,
                                                const Material       &material,
                                                const Strain         &strain_at)
    {
      if (!strains.has_bubbles)
        return Eigen::Matrix<double, 9, n>::Zero();
      const Eigen::Matrix<double, 6, 6> D      = compute_elasticity(material);
      Eigen::Matrix<double, 9, 9>       bb     = Eigen::Matrix<double, 9, 9>::Zero();
      Eigen::Matrix<double, 9, n>       forces = Eigen::Matrix<double, 9, n>::Zero();
      for (unsigned int q = 0; q < 8; ++q)
        {
          const Eigen::Matrix<double, 9, 6> weighted =
            strains.weight[q] * strains.bubble[q].transpose() * D;
          bb += weighted * strains.bubble[q];
          forces += weighted * strain_at(q);
        }
      return -bb.ldlt().solve(forces);
    }
  } // namespace

  Eigen::Matrix<double, 9, 24> compute_bubble_recovery(const ElementStrains &strains,
                                                       const Material       &material)
  {
    return balance_bubbles<24>(strains,
                               material,
                               [&](const unsigned int q) -> const Eigen::Matrix<double, 6, 24> & {
                                 return strains.displacement[q];
                               });
  }

  Eigen::Matrix<double, 9, 1> compute_bubbles(const ElementStrains               &strains,
                                              const Material                     &material,
                                              const Eigen::Matrix<double, 24, 1> &u)
  {
    return balance_bubbles<1>(strains, material, [&](const unsigned int q) {
      return Eigen::Matrix<double, 6, 1>(strains.displacement[q] * u);
    });
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
