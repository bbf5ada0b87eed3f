// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_gear_errors_bicubic_grid_h
#define vfife_gear_errors_bicubic_grid_h

#include <vfife/base/types.h>

#include <Eigen/Core>

namespace vfife
{
  /**
   * A function on the unit square through values on an even grid: product of cubic splines along
   * rows and columns whose third derivatives do not jump at the second and the last but one point
   * (not-a-knot), so that crowned and twisted surfaces up to the third power are met exactly at the
   * borders too; with 3 points a parabola, with 2 a straight line. Constant beyond the borders.
   */
  class BicubicGrid
  {
  public:
    /** @p values: rows at even steps of v from 0 to 1, columns of u; at least 2 of each. */
    explicit BicubicGrid(const Eigen::MatrixXd &values);

    double value(double u, double v) const;
    /** Derivatives by u and v; beyond a border the one across it is 0. */
    Vector2 gradient(double u, double v) const;

  private:
    /** sum of products of Hermite's weights along both directions. */
    double combine(double u, double v, bool u_slope, bool v_slope) const;

    Eigen::MatrixXd values_, by_u_, by_v_, by_uv_; ///< derivatives per cell
  };
} // namespace vfife

#endif
