// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/types.h>
#include <vfife/contact/surface/facet_quadrature.h>

#include <Eigen/Dense>

#include <cmath>

namespace vfife
{
  namespace
  {
    /** P_n(x) and P_{n-1}(x) by the three-term recurrence. */
    std::pair<double, double> legendre(const unsigned int n, const double x)
    {
      double before = 1., now = n == 0 ? 1. : x;
      for (unsigned int k = 2; k <= n; ++k)
        {
          const double next = ((2. * k - 1.) * x * now - (k - 1.) * before) / k;
          before            = now;
          now               = next;
        }
      return {now, before};
    }
  } // namespace

  void
  gauss_legendre(const unsigned int n, std::vector<double> &points, std::vector<double> &weights)
  {
    // Newton's method on P_n from the zeros of its asymptote, with (1 - x^2) P_n' = n (P_{n-1} - x
    // P_n); on [-1, 1] the weights are 2/((1 - x^2) P_n'^2), on [0, 1] half of that.
    points.resize(n);
    weights.resize(n);
    for (unsigned int i = 0; i < n; ++i)
      {
        double x = -std::cos(pi * (i + 0.75) / (n + 0.5)), slope = 1.;
        for (unsigned int k = 0; k < 20; ++k)
          {
            const auto [p, p_before] = legendre(n, x);
            slope                    = n * (p_before - x * p) / (1. - x * x);
            x -= p / slope;
          }
        points[i]  = 0.5 * (1. + x);
        weights[i] = 1. / ((1. - x * x) * slope * slope);
      }
  }

  std::vector<double> gauss_lobatto_points(const unsigned int n)
  {
    if (n < 2)
      throw InputError("Gauss-Lobatto rules require at least two points");
    std::vector<double> points(n);
    for (unsigned int i = 0; i < n; ++i)
      {
        // Newton on (1-x^2) P'_{n-1} = (n-1)(P_{n-2} - x P_{n-1}), whose derivative is -n(n-1)
        // P_{n-1}.
        double x = -std::cos(pi * i / (n - 1.));
        if (i != 0 && i != n - 1)
          for (unsigned int k = 0; k < 50; ++k)
            {
              const auto [p, p_before] = legendre(n - 1, x);
              x -= (x * p - p_before) / (n * p);
            }
        points[i] = 0.5 * (1. + x);
      }
    return points;
  }

  std::vector<FacetQuadraturePoint> facet_quadrature(const ContactDiscretization discretization,
                                                     const unsigned int          points_per_facet)
  {
    std::vector<FacetQuadraturePoint> rule;
    if (discretization == ContactDiscretization::nodes)
      {
        for (const auto &corner : {std::make_pair(0., 0.),
                                   std::make_pair(1., 0.),
                                   std::make_pair(1., 1.),
                                   std::make_pair(0., 1.)})
          rule.push_back(
            {corner.first, corner.second, 0.25, bilinear_weights(corner.first, corner.second)});
        return rule;
      }
    std::vector<double> points, weights;
    gauss_legendre(points_per_facet, points, weights);
    for (unsigned int j = 0; j < points_per_facet; ++j)
      for (unsigned int i = 0; i < points_per_facet; ++i)
        rule.push_back(
          {points[i], points[j], weights[i] * weights[j], bilinear_weights(points[i], points[j])});
    return rule;
  }

  OffsetPolynomials::OffsetPolynomials(const unsigned int n, const std::vector<double> &offsets)
    : n_(n)
    , coefficients_(offsets.size())
  {
    if (n < 2 || offsets.empty() || offsets.size() % (n * n) != 0)
      throw InputError("the offsets of a surface must be rows of n^2 values with n >= 2");

    // values at the points = V * coefficients in each direction, V the Vandermonde matrix in s.
    const std::vector<double> points = gauss_lobatto_points(n);
    Eigen::MatrixXd           vandermonde(n, n);
    for (unsigned int i = 0; i < n; ++i)
      for (unsigned int j = 0; j < n; ++j)
        vandermonde(i, j) = j == 0 ? 1. : vandermonde(i, j - 1) * (2. * points[i] - 1.);
    const Eigen::MatrixXd inverse = vandermonde.inverse();

    // Each row of values v becomes V^-1 v V^-T: first along one direction, then along the other.
    using Row = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
    for (std::size_t row = 0; row < offsets.size(); row += n * n)
      {
        const Eigen::Map<const Row> values(offsets.data() + row, n, n);
        Eigen::Map<Row>(coefficients_.data() + row, n, n) = inverse * values * inverse.transpose();
      }
  }
} // namespace vfife
