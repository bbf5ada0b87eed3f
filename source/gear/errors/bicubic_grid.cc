// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/gear/errors/bicubic_grid.h>

#include <Eigen/LU>

#include <algorithm>
#include <array>

namespace vfife
{
  namespace
  {
    /** The matrix that makes slopes per step, at n even points, of values. */
    Eigen::MatrixXd slope_matrix(const Eigen::Index n)
    {
      Eigen::MatrixXd slopes = Eigen::MatrixXd::Zero(n, n), values = Eigen::MatrixXd::Zero(n, n);
      if (n == 2)
        {
          values << -1., 1., -1., 1.;
          return values;
        }
      if (n == 3)
        {
          values << -1.5, 2., -.5, -.5, 0., .5, .5, -2., 1.5;
          return values;
        }
      // Between: m(i-1) + 4 m(i) + m(i+1) = 3 (f(i+1) - f(i-1)), second derivatives are continuous.
      for (Eigen::Index i = 1; i + 1 < n; ++i)
        {
          slopes(i, i - 1) = slopes(i, i + 1) = 1.;
          slopes(i, i)                        = 4.;
          values(i, i + 1)                    = 3.;
          values(i, i - 1)                    = -3.;
        }
      // At the ends: m(0) - m(2) = 2 (2 f(1) - f(0) - f(2)), third derivatives of the first two
      // intervals are equal; likewise of the last two.
      for (const Eigen::Index row : {Eigen::Index(0), n - 1})
        {
          const Eigen::Index first = row == 0 ? 0 : n - 3;
          slopes(row, first)       = 1.;
          slopes(row, first + 2)   = -1.;
          values(row, first) = values(row, first + 2) = -2.;
          values(row, first + 1)                      = 4.;
        }
      return slopes.partialPivLu().solve(values);
    }

    /** A cell of a line of n points and the weights of values and slopes at its two ends. */
    struct Weights
    {
      Eigen::Index          cell;
      std::array<double, 2> value, slope;

      /** @p derivative: of the function by x, else its value. */
      Weights(const double x, const Eigen::Index n, const bool derivative)
      {
        const double place  = std::min(std::max(x, 0.), 1.) * (n - 1);
        cell                = std::min(static_cast<Eigen::Index>(place), n - 2);
        const double s      = place - cell;
        const bool   beyond = x < 0. || x > 1.;
        if (!derivative)
          {
            value = {{(1. + 2. * s) * (1. - s) * (1. - s), s * s * (3. - 2. * s)}};
            slope = {{s * (1. - s) * (1. - s), s * s * (s - 1.)}};
          }
        else
          {
            const double scale = beyond ? 0. : n - 1.;
            value              = {{-6. * s * (1. - s) * scale, 6. * s * (1. - s) * scale}};
            slope              = {{(1. - s) * (1. - 3. * s) * scale, s * (3. * s - 2.) * scale}};
          }
      }
    };
  } // namespace

  BicubicGrid::BicubicGrid(const Eigen::MatrixXd &values)
    : values_(values)
    , by_u_(values * slope_matrix(values.cols()).transpose())
    , by_v_(slope_matrix(values.rows()) * values)
    , by_uv_(slope_matrix(values.rows()) * by_u_)
  {
  }

  double
  BicubicGrid::combine(const double u, const double v, const bool u_slope, const bool v_slope) const
  {
    const Weights a(u, values_.cols(), u_slope), b(v, values_.rows(), v_slope);
    double        sum = 0.;
    for (unsigned int i = 0; i < 2; ++i)
      for (unsigned int j = 0; j < 2; ++j)
        {
          const Eigen::Index row = b.cell + i, column = a.cell + j;
          sum +=
            b.value[i] * (a.value[j] * values_(row, column) + a.slope[j] * by_u_(row, column)) +
            b.slope[i] * (a.value[j] * by_v_(row, column) + a.slope[j] * by_uv_(row, column));
        }
    return sum;
  }

  double BicubicGrid::value(const double u, const double v) const
  {
    return combine(u, v, false, false);
  }

  Vector2 BicubicGrid::gradient(const double u, const double v) const
  {
    return {combine(u, v, true, false), combine(u, v, false, true)};
  }
} // namespace vfife
