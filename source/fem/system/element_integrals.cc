// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/element/stiffness.h>
#include <vfife/fem/system/element_integrals.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_dgq.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_tools.h>

#include <Eigen/LU>

#include <array>
#include <limits>

namespace vfife
{
  namespace
  {
    StiffnessKind stiffness_of(const FemElement element)
    {
      return element == FemElement::full ? StiffnessKind::full : StiffnessKind::incompatible_modes;
    }

    /** Along each axis, of an element with @p n_points. */
    unsigned int degree_of_points(const std::size_t n_points)
    {
      return n_points == 8 ? 1 : (n_points == 27 ? 2 : 3);
    }

    struct ReferencePoint
    {
      Eigen::VectorXd N;
      Eigen::MatrixXd gradients; ///< to the reference coordinates, a column per shape function
      double          weight;
    };

    /** Values of the shape functions at the points of @p rule. */
    template <int dim>
    std::vector<ReferencePoint> evaluate(const unsigned int             degree,
                                         const dealii::Quadrature<dim> &rule)
    {
      const dealii::FE_Q<dim> element(degree);
      const auto numbers = dealii::FETools::lexicographic_to_hierarchic_numbering<dim>(degree);
      std::vector<ReferencePoint> points;
      for (unsigned int q = 0; q < rule.size(); ++q)
        {
          ReferencePoint point{Eigen::VectorXd(numbers.size()),
                               Eigen::MatrixXd(dim, numbers.size()),
                               rule.weight(q)};
          for (unsigned int a = 0; a < numbers.size(); ++a)
            {
              point.N[a]          = element.shape_value(numbers[a], rule.point(q));
              const auto gradient = element.shape_grad(numbers[a], rule.point(q));
              for (unsigned int d = 0; d < dim; ++d)
                point.gradients(d, a) = gradient[d];
            }
          points.push_back(std::move(point));
        }
      return points;
    }

    /** Of all degrees: evaluated once. */
    using OfDegrees = std::array<std::vector<ReferencePoint>, 3>;

    template <typename Evaluate>
    OfDegrees for_degrees(const Evaluate &evaluate_degree)
    {
      return {{evaluate_degree(1), evaluate_degree(2), evaluate_degree(3)}};
    }

    unsigned int degree_of_face(const std::size_t n_points)
    {
      return n_points == 4 ? 1 : (n_points == 9 ? 2 : 3);
    }

    /** A face's rule on each of its parts. */
    std::vector<std::vector<ReferencePoint>> evaluate_parts(const unsigned int degree)
    {
      const std::vector<double>                places = places_along(degree);
      const dealii::QGauss<2>                  rule(degree + 2);
      std::vector<std::vector<ReferencePoint>> parts;
      for (unsigned int j = 0; j < degree; ++j)
        for (unsigned int i = 0; i < degree; ++i)
          {
            const dealii::Point<2> low(places[i], places[j]);
            const dealii::Point<2> size(places[i + 1] - places[i], places[j + 1] - places[j]);
            std::vector<dealii::Point<2>> points;
            std::vector<double>           weights;
            for (unsigned int q = 0; q < rule.size(); ++q)
              {
                points.emplace_back(low[0] + size[0] * rule.point(q)[0],
                                    low[1] + size[1] * rule.point(q)[1]);
                weights.push_back(size[0] * size[1] * rule.weight(q));
              }
            parts.push_back(evaluate(degree, dealii::Quadrature<2>(points, weights)));
          }
      return parts;
    }

    /** The polynomials that are one at a Gauss point of elements of @p degree and zero at the
     * others, at the points of FE_Q(@p at). */
    Eigen::MatrixXd extrapolate(const unsigned int degree, const unsigned int at)
    {
      const dealii::FE_DGQArbitraryNodes<3> element{dealii::QGauss<1>(n_gauss(degree))};
      const dealii::FE_Q<3>                 points(at);
      const auto      numbers = dealii::FETools::lexicographic_to_hierarchic_numbering<3>(at);
      Eigen::MatrixXd matrix(element.dofs_per_cell, numbers.size());
      for (unsigned int q = 0; q < matrix.rows(); ++q)
        for (unsigned int a = 0; a < numbers.size(); ++a)
          matrix(q, a) = element.shape_value(q, points.unit_support_point(numbers[a]));
      return matrix;
    }

    FacePoint map_face_point(const ReferencePoint &reference, const ElementNodes &X)
    {
      const Eigen::Matrix<double, 3, 2> tangents = X * reference.gradients.transpose();
      return {reference.N, reference.weight * tangents.col(0).cross(tangents.col(1))};
    }

    std::vector<ElementPoint> map_points(const std::vector<ReferencePoint> &references,
                                         const ElementNodes                &X)
    {
      std::vector<ElementPoint> points;
      for (const ReferencePoint &reference : references)
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
  } // namespace

  unsigned int degree_of(const FemElement element)
  {
    return element == FemElement::cubic ? 3 : (element == FemElement::quadratic ? 2 : 1);
  }

  unsigned int n_gauss(const unsigned int degree)
  {
    return degree == 3 ? 5 : degree + 1;
  }

  std::vector<double> places_along(const unsigned int degree)
  {
    const dealii::QGaussLobatto<1> rule(degree + 1);
    std::vector<double>            places;
    for (const dealii::Point<1> &point : rule.get_points())
      places.push_back(point[0]);
    return places;
  }

  std::vector<unsigned int> corners_around(const Vector3 &unit)
  {
    std::vector<unsigned int> corners;
    for (unsigned int v = 0; v < 8; ++v)
      {
        bool spans = true;
        for (unsigned int d = 0; d < 3; ++d)
          spans = spans && ((v >> d & 1u) != 0 ? unit[d] > 0. : unit[d] < 1.);
        if (spans)
          corners.push_back(v);
      }
    return corners;
  }

  std::vector<unsigned int> numbers_on_face(const unsigned int degree, const unsigned int f)
  {
    // Points of an element are numbered with x fastest; a face lies at one end of its normal
    // direction d and is run through along d + 1 and d + 2, on the lower side the other way round
    // (find_boundary_faces).
    const unsigned int n = degree + 1, direction = f / 2, side = f % 2;
    const unsigned int first  = (direction + (side == 1 ? 1 : 2)) % 3,
                       second = (direction + (side == 1 ? 2 : 1)) % 3;
    std::vector<unsigned int> numbers;
    for (unsigned int j = 0; j < n; ++j)
      for (unsigned int i = 0; i < n; ++i)
        {
          std::array<unsigned int, 3> at;
          at[direction] = side * (n - 1);
          at[first]     = i;
          at[second]    = j;
          numbers.push_back(at[0] + n * (at[1] + n * at[2]));
        }
    return numbers;
  }

  const Choices<FemElement> &fem_element_choices()
  {
    static const Choices<FemElement> choices = {{"incompatible modes",
                                                 FemElement::incompatible_modes},
                                                {"full integration", FemElement::full},
                                                {"quadratic", FemElement::quadratic},
                                                {"cubic", FemElement::cubic}};
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
    static const OfDegrees references = for_degrees([](const unsigned int degree) {
      return evaluate(degree, dealii::QGauss<3>(n_gauss(degree)));
    });
    return map_points(references[degree_of_points(X.cols()) - 1], X);
  }

  JacobianPoint find_least_jacobian(const ElementNodes &X)
  {
    static const OfDegrees references = for_degrees([](const unsigned int degree) {
      auto       points  = evaluate(degree, dealii::QGauss<3>(n_gauss(degree)));
      const auto corners = evaluate(degree, dealii::QTrapezoid<3>());
      points.insert(points.end(), corners.begin(), corners.end());
      return points;
    });
    JacobianPoint          least{std::numeric_limits<double>::max(), Vector3::Zero()};
    for (const ReferencePoint &reference : references[degree_of_points(X.cols()) - 1])
      {
        const Matrix3 jacobian    = X * reference.gradients.transpose();
        const double  determinant = jacobian.determinant();
        // A place that is no number counts as folded.
        if (!(determinant >= least.determinant))
          least = {determinant, X * reference.N};
      }
    return least;
  }

  std::vector<std::vector<FacePartPoint>> compute_face_part_points(const ElementNodes &X)
  {
    static const std::array<std::vector<std::vector<ReferencePoint>>, 3> references = {
      {evaluate_parts(1), evaluate_parts(2), evaluate_parts(3)}};
    const unsigned int                      degree = degree_of_face(X.cols());
    const dealii::QGauss<2>                 rule(degree + 2);
    std::vector<std::vector<FacePartPoint>> parts;
    for (const std::vector<ReferencePoint> &of_part : references[degree - 1])
      {
        parts.emplace_back();
        for (unsigned int q = 0; q < of_part.size(); ++q)
          {
            const double s = rule.point(q)[0], t = rule.point(q)[1];
            parts.back().push_back({map_face_point(of_part[q], X),
                                    {(1. - s) * (1. - t), s * (1. - t), s * t, (1. - s) * t}});
          }
      }
    return parts;
  }

  std::vector<FacePoint> compute_face_points(const ElementNodes &X)
  {
    static const OfDegrees references = for_degrees(
      [](const unsigned int degree) { return evaluate(degree, dealii::QGauss<2>(degree + 2)); });
    std::vector<FacePoint> points;
    for (const ReferencePoint &reference : references[degree_of_face(X.cols()) - 1])
      points.push_back(map_face_point(reference, X));
    return points;
  }

  const std::vector<Eigen::MatrixXd> &face_gradients(const unsigned int degree)
  {
    static const auto make = [](const unsigned int n) {
      std::vector<Eigen::MatrixXd> gradients;
      for (const ReferencePoint &point : evaluate(n, dealii::QGauss<2>(n)))
        gradients.push_back(point.gradients);
      return gradients;
    };
    static const std::array<std::vector<Eigen::MatrixXd>, 3> all = {{make(1), make(2), make(3)}};
    return all[degree - 1];
  }

  Eigen::MatrixXd
  compute_fem_stiffness(const ElementNodes &X, const Material &material, const FemElement element)
  {
    if (degree_of(element) == 1)
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
    static const OfDegrees at_points = for_degrees([](const unsigned int degree) {
      return evaluate(degree, dealii::QGaussLobatto<3>(degree + 1));
    });
    const bool             lobatto   = kind == MassKind::lumped && X.cols() > 8;
    Eigen::MatrixXd        m         = Eigen::MatrixXd::Zero(X.cols(), X.cols());
    for (const ElementPoint &point : lobatto
                                       ? map_points(at_points[degree_of_points(X.cols()) - 1], X)
                                       : compute_element_points(X))
      m.noalias() += (density * point.weight) * point.N * point.N.transpose();
    if (kind == MassKind::consistent)
      return m;
    // sum_b m_ab = rho int N_a dV, since the functions sum to one.
    const Eigen::VectorXd rows = m.rowwise().sum();
    return rows.asDiagonal();
  }

  Eigen::Matrix<double, 6, Eigen::Dynamic> compute_point_stresses(const ElementNodes    &X,
                                                                  const Material        &material,
                                                                  const FemElement       element,
                                                                  const Eigen::VectorXd &u)
  {
    const Eigen::Matrix<double, 6, 6> D = compute_elasticity(material);
    if (degree_of(element) > 1)
      {
        const auto                               points = compute_element_points(X);
        Eigen::Matrix<double, 6, Eigen::Dynamic> stresses(6, points.size());
        for (std::size_t q = 0; q < points.size(); ++q)
          stresses.col(q).noalias() = D * (compute_strain_matrix(points[q].gradients) * u);
        return stresses;
      }
    // The same points in the same order as compute_element_points().
    const ElementStrains              strains = compute_element_strains(X, stiffness_of(element));
    const Eigen::Matrix<double, 9, 1> bubbles = compute_bubbles(strains, material, u);
    Eigen::Matrix<double, 6, Eigen::Dynamic> stresses(6, 8);
    for (unsigned int q = 0; q < 8; ++q)
      stresses.col(q) = D * (strains.displacement[q] * u + strains.bubble[q] * bubbles);
    return stresses;
  }

  const Eigen::MatrixXd &corner_extrapolation(const unsigned int degree)
  {
    static const std::array<Eigen::MatrixXd, 3> matrices = {
      {extrapolate(1, 1), extrapolate(2, 1), extrapolate(3, 1)}};
    return matrices[degree - 1];
  }

  const Eigen::MatrixXd &point_extrapolation(const unsigned int degree)
  {
    static const std::array<Eigen::MatrixXd, 3> matrices = {
      {extrapolate(1, 1), extrapolate(2, 2), extrapolate(3, 3)}};
    return matrices[degree - 1];
  }

  const Eigen::MatrixXd &even_places(const unsigned int degree)
  {
    static const auto make = [](const unsigned int n) {
      const dealii::QIterated<3> rule(dealii::QTrapezoid<1>(), n);
      const auto                 points = evaluate(n, rule);
      Eigen::MatrixXd            matrix(points.size(), points.size());
      for (std::size_t i = 0; i < points.size(); ++i)
        matrix.col(i) = points[i].N;
      return matrix;
    };
    static const std::array<Eigen::MatrixXd, 3> matrices = {{make(1), make(2), make(3)}};
    return matrices[degree - 1];
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

  Eigen::VectorXd compute_selected_masses(const ElementNodes        &X,
                                          const double               density,
                                          const unsigned int         degree,
                                          const std::array<bool, 8> &selected)
  {
    Eigen::VectorXd masses =
      compute_mass_coefficients(X, density, MassKind::consistent).rowwise().sum();
    const unsigned int n = degree + 1;
    for (unsigned int a = 0; a < n * n * n; ++a)
      {
        const std::vector<unsigned int> corners =
          corners_around(Vector3(a % n, a / n % n, a / (n * n)) / degree);
        double inside = 0;
        for (const unsigned int v : corners)
          inside += selected[v] ? 1. : 0.;
        masses[a] = inside / corners.size() * masses[a];
      }
    return masses;
  }
} // namespace vfife
