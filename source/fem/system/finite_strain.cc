// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/element/stiffness.h>
#include <vfife/fem/system/finite_strain.h>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include <cmath>

namespace vfife
{
  namespace
  {
    using Vector9 = Eigen::Matrix<double, 9, 1>;

    /** The entries of a 3 x 3 matrix, column by column. */
    Vector9 entries(const Matrix3 &matrix)
    {
      return Eigen::Map<const Vector9>(matrix.data());
    }

    /** W = mu |U - 1|^2 + lambda/2 tr(U - 1)^2. */
    StrainState
    biot_state(const Matrix3 &H, const double lambda, const double mu, const bool with_tangent)
    {
      // U - 1 by the eigenvectors V of Green's strain: its stretches less one follow from e without
      // a difference of near numbers, and so does R = F U^-1.
      const Matrix3 green = .5 * (H + H.transpose() + H.transpose() * H);
      const Eigen::SelfAdjointEigenSolver<Matrix3> axes(green);
      const Matrix3                               &V      = axes.eigenvectors();
      const Vector3                                strain = axes.eigenvalues().unaryExpr(
        [](const double e) { return 2. * e / (1. + std::sqrt(1. + 2. * e)); });
      const Vector3 inverse = (1. + strain.array()).inverse();
      const Matrix3 RV      = (Matrix3::Identity() + H) * V * inverse.asDiagonal();
      const double  trace   = strain.sum();

      StrainState state;
      state.energy = mu * strain.squaredNorm() + .5 * lambda * trace * trace;
      // P = R (2 mu (U - 1) + lambda tr(U - 1) 1)
      const Vector3 principal = 2. * mu * strain + Vector3::Constant(lambda * trace);
      state.stress            = RV * principal.asDiagonal() * V.transpose();
      if (!with_tangent)
        return state;
      // With W = mu |F|^2 - 2 mu tr U + lambda/2 tr(U - 1)^2: d tr U/dF = R, and dR/dF has the
      // three twists R V T_k V^T, T_k the unit skew matrix of a plane, times 2/(s_i + s_j) of its
      // stretches, as eigenmatrices.
      const Vector9 R = entries(RV * V.transpose());
      state.tangent   = 2. * mu * Matrix9::Identity() + lambda * R * R.transpose();
      for (unsigned int i = 0; i < 3; ++i)
        {
          const unsigned int j    = (i + 1) % 3;
          Matrix3            skew = Matrix3::Zero();
          skew(i, j)              = std::sqrt(.5);
          skew(j, i)              = -std::sqrt(.5);
          const Vector9 twist     = entries(RV * skew * V.transpose());
          state.tangent += (lambda * trace - 2. * mu) * 2. / (2. + strain[i] + strain[j]) * twist *
                           twist.transpose();
        }
      return state;
    }

    /** W = mu |E|^2 + lambda/2 tr(E)^2, E = (F^T F - 1)/2. */
    StrainState
    green_state(const Matrix3 &H, const double lambda, const double mu, const bool with_tangent)
    {
      const Matrix3 F      = Matrix3::Identity() + H;
      const Matrix3 E      = .5 * (H + H.transpose() + H.transpose() * H);
      const Matrix3 second = lambda * E.trace() * Matrix3::Identity() + 2. * mu * E;

      StrainState state;
      state.energy = mu * E.squaredNorm() + .5 * lambda * E.trace() * E.trace();
      state.stress = F * second;
      if (!with_tangent)
        return state;
      for (unsigned int c = 0; c < 9; ++c)
        {
          // dP = dF S + F (lambda tr(dE) 1 + 2 mu dE) for one entry of dF
          Matrix3 change       = Matrix3::Zero();
          change.data()[c]     = 1.;
          const Matrix3 half   = F.transpose() * change;
          const Matrix3 dE     = .5 * (half + half.transpose());
          state.tangent.col(c) = entries(
            change * second + F * (lambda * dE.trace() * Matrix3::Identity() + 2. * mu * dE));
        }
      return state;
    }

    StrainState find_state(const Matrix3      &H,
                           const Material     &material,
                           const StrainMeasure measure,
                           const bool          with_tangent)
    {
      return measure == StrainMeasure::biot
               ? biot_state(H, material.lambda(), material.mu(), with_tangent)
               : green_state(H, material.lambda(), material.mu(), with_tangent);
    }

    /** What is integrated over an element: gradients of all functions, bubbles last. */
    struct Point
    {
      ElementNodes gradients;
      double       weight;
    };

    std::vector<Point> make_points(const ElementNodes &X, const FemElement element)
    {
      std::vector<Point> points;
      for (const ElementPoint &point : compute_element_points(X))
        points.push_back({point.gradients, point.weight});
      if (element != FemElement::incompatible_modes)
        return points;
      const ElementStrains strains = compute_element_strains(X, StiffnessKind::incompatible_modes);
      for (unsigned int q = 0; q < 8; ++q)
        {
          ElementNodes &gradients = points[q].gradients;
          gradients.conservativeResize(3, 11);
          // Of a matrix of strains, the normal strain i of the component i is the gradient's.
          for (unsigned int a = 0; a < 3; ++a)
            for (unsigned int i = 0; i < 3; ++i)
              gradients(i, 8 + a) = strains.bubble[q](i, 3 * a + i);
        }
      return points;
    }

    /** Adds G^T C G: C the derivative of the stress by the displacement gradient, G the 9 x 3n
     * matrix of that gradient's entries. Its 3 x 3 blocks are multiples of the unit matrix. */
    template <typename Gradients, typename Tangent>
    void add_tangent(const Gradients &gradients, const Matrix9 &C, Tangent &tangent)
    {
      constexpr int               n = Gradients::ColsAtCompileTime == Eigen::Dynamic
                                        ? Eigen::Dynamic
                                        : 3 * int(Gradients::ColsAtCompileTime);
      Eigen::Matrix<double, 9, n> CG(9, 3 * gradients.cols());
      for (int b = 0; b < gradients.cols(); ++b)
        CG.template middleCols<3>(3 * b) = gradients(0, b) * C.leftCols<3>() +
                                           gradients(1, b) * C.middleCols<3>(3) +
                                           gradients(2, b) * C.rightCols<3>();
      for (int a = 0; a < gradients.cols(); ++a)
        tangent.template middleRows<3>(3 * a) += gradients(0, a) * CG.template topRows<3>() +
                                                 gradients(1, a) * CG.template middleRows<3>(3) +
                                                 gradients(2, a) * CG.template bottomRows<3>();
    }

    constexpr unsigned int largest_rounds = 20;
    /** Of the work of the last step over the energy: the error that it leaves is its square. */
    constexpr double round_tolerance = 1e-20;
    /** Of strains over the displacement gradient: all that is left of a turned element. */
    constexpr double round_off = 1e-15;

    /** Amplitudes of the bubbles without force on them, by Newton's method. */
    Vector9 find_bubbles(const std::vector<Point> &points,
                         const Material           &material,
                         const StrainMeasure       measure,
                         const ElementNodes       &u)
    {
      Vector9 alpha = Vector9::Zero();
      for (unsigned int round = 0; round < largest_rounds; ++round)
        {
          Vector9 force  = Vector9::Zero();
          Matrix9 K      = Matrix9::Zero();
          double  energy = 0, noise = 0;
          for (const Point &point : points)
            {
              const Matrix3 bubbles = point.gradients.rightCols(3);
              const Matrix3 H       = u * point.gradients.leftCols(u.cols()).transpose() +
                                Eigen::Map<const Matrix3>(alpha.data()) * bubbles.transpose();
              const StrainState state = compute_strain_state(H, material, measure);
              force += point.weight * entries(state.stress * bubbles);
              add_tangent(bubbles, point.weight * state.tangent, K);
              energy += point.weight * state.energy;
              noise += point.weight * material.mu() * H.squaredNorm() * round_off * round_off;
            }
          const Vector9 step = -K.ldlt().solve(force);
          const double  work = -step.dot(force);
          if (!std::isfinite(work))
            break;
          alpha += step;
          if (std::abs(work) <= round_tolerance * energy + noise)
            return alpha;
        }
      throw NumericalError(
        "the incompatible modes of an element did not converge: strain too large");
    }
  } // namespace

  const Choices<StrainMeasure> &strain_measure_choices()
  {
    static const Choices<StrainMeasure> choices = {{"biot", StrainMeasure::biot},
                                                   {"green", StrainMeasure::green}};
    return choices;
  }

  StrainState
  compute_strain_state(const Matrix3 &H, const Material &material, const StrainMeasure measure)
  {
    return find_state(H, material, measure, true);
  }

  ElementState compute_element_state(const ElementNodes    &X,
                                     const Material        &material,
                                     const FemElement       element,
                                     const StrainMeasure    measure,
                                     const Eigen::VectorXd &u,
                                     const bool             with_tangent)
  {
    const std::vector<Point>             points = make_points(X, element);
    const int                            n      = points.front().gradients.cols();
    const Eigen::Map<const ElementNodes> nodes(u.data(), 3, X.cols());
    // Amplitudes of all functions: nodes, then bubbles.
    ElementNodes all(3, n);
    all.leftCols(X.cols()) = nodes;
    if (n > X.cols())
      all.rightCols(3) =
        Eigen::Map<const Matrix3>(find_bubbles(points, material, measure, nodes).data());

    ElementState    result;
    ElementNodes    forces  = ElementNodes::Zero(3, n);
    Eigen::MatrixXd tangent = Eigen::MatrixXd::Zero(3 * n, 3 * n);
    for (const Point &point : points)
      {
        const StrainState state =
          find_state(all * point.gradients.transpose(), material, measure, with_tangent);
        result.energy += point.weight * state.energy;
        forces += point.weight * state.stress * point.gradients;
        if (with_tangent)
          add_tangent(point.gradients, point.weight * state.tangent, tangent);
      }
    // Without force on the bubbles, the nodes' forces are the derivative of the energy as they are.
    const int n_nodal = u.size();
    result.forces     = Eigen::Map<const Eigen::VectorXd>(forces.data(), n_nodal);
    if (with_tangent)
      {
        const int n_bubbles = 3 * n - n_nodal;
        if (n_bubbles > 0)
          {
            const Eigen::MatrixXd coupling = tangent.bottomLeftCorner(n_bubbles, n_nodal);
            tangent.topLeftCorner(n_nodal, n_nodal) -=
              coupling.transpose() *
              tangent.bottomRightCorner(n_bubbles, n_bubbles).ldlt().solve(coupling);
          }
        const Eigen::MatrixXd K = tangent.topLeftCorner(n_nodal, n_nodal);
        result.tangent          = .5 * (K + K.transpose());
      }
    return result;
  }
} // namespace vfife
