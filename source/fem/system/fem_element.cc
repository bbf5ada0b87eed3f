// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/element/stiffness.h>
#include <vfife/fem/system/fem_element.h>

#include <Eigen/LU>

#include <array>
#include <cmath>

namespace vfife
{
  namespace
  {
    StiffnessKind stiffness_of(const FemElement element)
    {
      return element == FemElement::full ? StiffnessKind::full : StiffnessKind::incompatible_modes;
    }

    /** Values and derivatives of the Lagrange polynomials of equal spacing on [-1, 1]. */
    struct Polynomials
    {
      std::vector<double> value, slope;
    };

    Polynomials evaluate(const unsigned int degree, const double x)
    {
      if (degree == 1)
        return {{.5 * (1. - x), .5 * (1. + x)}, {-.5, .5}};
      // Places -1, 0, 1.
      return {{.5 * x * (x - 1.), 1. - x * x, .5 * x * (x + 1.)}, {x - .5, -2. * x, x + .5}};
    }

    struct ReferencePoint
    {
      Eigen::VectorXd N;
      ElementNodes    gradients; ///< to the reference coordinates
      double          weight;
    };

    /** The tensor Gauss rule of degree + 1 points a direction, in the order of gauss_point(). */
    std::vector<ReferencePoint> make_reference_points(const unsigned int degree)
    {
      // Exact to the degree 2 n - 1 along each line: stiffness and mass of a parallelepiped.
      const unsigned int        n     = degree + 1;
      const double              outer = degree == 1 ? 1. / std::sqrt(3.) : std::sqrt(.6);
      const std::vector<double> place =
        degree == 1 ? std::vector<double>{-outer, outer} : std::vector<double>{-outer, 0., outer};
      const std::vector<double> weight =
        degree == 1 ? std::vector<double>{1., 1.} : std::vector<double>{5. / 9., 8. / 9., 5. / 9.};

      std::vector<ReferencePoint> points;
      for (unsigned int q = 0; q < n * n * n; ++q)
        {
          // Points and nodes alike are numbered with x fastest; functions, gradients and weights
          // are products of those of three lines.
          const std::array<unsigned int, 3> at = {{q % n, q / n % n, q / (n * n)}};
          std::array<Polynomials, 3>        p;
          for (unsigned int d = 0; d < 3; ++d)
            p[d] = evaluate(degree, place[at[d]]);
          ReferencePoint point{Eigen::VectorXd(n * n * n),
                               ElementNodes(3, n * n * n),
                               weight[at[0]] * weight[at[1]] * weight[at[2]]};
          for (unsigned int a = 0; a < n * n * n; ++a)
            {
              const unsigned int i = a % n, j = a / n % n, k = a / (n * n);
              point.N[a] = p[0].value[i] * p[1].value[j] * p[2].value[k];
              point.gradients.col(a) << p[0].slope[i] * p[1].value[j] * p[2].value[k],
                p[0].value[i] * p[1].slope[j] * p[2].value[k],
                p[0].value[i] * p[1].value[j] * p[2].slope[k];
            }
          points.push_back(point);
        }
      return points;
    }

    const std::vector<ReferencePoint> &reference_points(const unsigned int n_nodes)
    {
      static const std::vector<ReferencePoint> linear    = make_reference_points(1),
                                               quadratic = make_reference_points(2);
      return n_nodes == 8 ? linear : quadratic;
    }
  } // namespace

  const Choices<FemElement> &fem_element_choices()
  {
    static const Choices<FemElement> choices = {{"incompatible modes",
                                                 FemElement::incompatible_modes},
                                                {"full", FemElement::full},
                                                {"quadratic", FemElement::quadratic}};
    return choices;
  }

  const Choices<MassKind> &mass_choices()
  {
    static const Choices<MassKind> choices = {{"consistent", MassKind::consistent},
                                              {"lumped", MassKind::lumped}};
    return choices;
  }

  std::vector<ElementPoint> compute_element_points(const ElementNodes &X)
  {
    std::vector<ElementPoint> points;
    for (const ReferencePoint &reference : reference_points(X.cols()))
      {
        // J = dX/dxi; gradients to X are J^-T times those to xi.
        const Matrix3 jacobian    = X * reference.gradients.transpose();
        const double  determinant = jacobian.determinant();
        if (!(determinant > 0.))
          throw NumericalError("An element is folded: its Jacobian determinant is " +
                               std::to_string(determinant) + " mm^3 at an integration point.");
        points.push_back({reference.N,
                          jacobian.inverse().transpose() * reference.gradients,
                          determinant * reference.weight});
      }
    return points;
  }

  Eigen::MatrixXd
  compute_fem_stiffness(const ElementNodes &X, const Material &material, const FemElement element)
  {
    if (element != FemElement::quadratic)
      return compute_stiffness(X, material, stiffness_of(element));

    const Eigen::Matrix<double, 6, 6> D = compute_elasticity(material);
    Eigen::MatrixXd                   K = Eigen::MatrixXd::Zero(3 * X.cols(), 3 * X.cols());
    for (const ElementPoint &point : compute_element_points(X))
      {
        // K = sum over points of w B^T D B [N/mm]
        const Eigen::MatrixXd B = compute_strain_matrix(point.gradients);
        K.noalias() += B.transpose() * (point.weight * D * B);
      }
    // Without the part of the round-off that is not symmetric.
    return .5 * (K + K.transpose());
  }

  Eigen::MatrixXd
  compute_mass_coefficients(const ElementNodes &X, const double density, const MassKind kind)
  {
    Eigen::MatrixXd m = Eigen::MatrixXd::Zero(X.cols(), X.cols());
    for (const ElementPoint &point : compute_element_points(X))
      m.noalias() += (density * point.weight) * point.N * point.N.transpose();
    if (kind == MassKind::consistent)
      return m;

    // sum_b m_ab = rho int N_a dV, since the functions sum to one.
    const Eigen::VectorXd rows = m.rowwise().sum();
    if (X.cols() == 8)
      return rows.asDiagonal();
    // Some of the 27 row sums are not positive; the diagonal is, and gets the element's mass.
    const Eigen::VectorXd scaled = m.diagonal() * (rows.sum() / m.diagonal().sum());
    return scaled.asDiagonal();
  }

  Eigen::Matrix<double, 6, Eigen::Dynamic> compute_point_stresses(const ElementNodes    &X,
                                                                  const Material        &material,
                                                                  const FemElement       element,
                                                                  const Eigen::VectorXd &u)
  {
    const Eigen::Matrix<double, 6, 6> D = compute_elasticity(material);
    if (element == FemElement::quadratic)
      {
        const auto                               points = compute_element_points(X);
        Eigen::Matrix<double, 6, Eigen::Dynamic> stresses(6, points.size());
        for (std::size_t q = 0; q < points.size(); ++q)
          stresses.col(q) = D * compute_strain_matrix(points[q].gradients) * u;
        return stresses;
      }
    // The same points in the same order as compute_element_points().
    const ElementStrains              strains = compute_element_strains(X, stiffness_of(element));
    const Eigen::Matrix<double, 9, 1> bubbles = compute_bubble_recovery(strains, material) * u;
    Eigen::Matrix<double, 6, Eigen::Dynamic> stresses(6, 8);
    for (unsigned int q = 0; q < 8; ++q)
      stresses.col(q) = D * (strains.displacement[q] * u + strains.bubble[q] * bubbles);
    return stresses;
  }

  Eigen::MatrixXd expand_coefficients(const Eigen::MatrixXd &coefficients,
                                      const Eigen::Matrix3d &block)
  {
    Eigen::MatrixXd full(3 * coefficients.rows(), 3 * coefficients.cols());
    for (int a = 0; a < coefficients.rows(); ++a)
      for (int b = 0; b < coefficients.cols(); ++b)
        full.block<3, 3>(3 * a, 3 * b) = coefficients(a, b) * block;
    return full;
  }
} // namespace vfife
