// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_gear_newton_h
#define vfife_gear_newton_h

#include <Eigen/Core>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>

namespace vfife
{
  /**
   * Damped Newton iteration for the few equations of gear geometry; roots of one unknown are left
   * to Boost.Math, which has no solver for several. @p equations(x, residual, jacobian) fills
   * residual [n] and jacobian [n x n]; the residual must be scaled so that its norm is a fair
   * measure. Unknowns are angles [rad] and ratios, all of order one. Returns whether it converged:
   * the last step, below 1e-9, is still taken, which by quadratic convergence leaves only
   * round-off.
   */
  template <int n, typename Equations>
  bool solve_newton(const Equations &equations, Eigen::Matrix<double, n, 1> &x)
  {
    constexpr unsigned int max_iterations = 60;
    constexpr double       last_step      = 1e-9;
    // half a radian is the size of the zone in which a flank is generated: no step may leave it
    constexpr double longest_step  = 0.5;
    constexpr double least_damping = 1e-6;

    using Residual = Eigen::Matrix<double, n, 1>;
    using Jacobian = Eigen::Matrix<double, n, n>;
    Residual residual, trial_residual, step;
    Jacobian jacobian, trial_jacobian;
    equations(x, residual, jacobian);
    for (unsigned int iteration = 0; iteration < max_iterations; ++iteration)
      {
        if constexpr (n <= 4)
          step = -(jacobian.inverse() * residual);
        else
          step = -jacobian.partialPivLu().solve(residual);
        const double size = step.template lpNorm<Eigen::Infinity>();
        if (!std::isfinite(size))
          return false;
        if (size < last_step)
          {
            x += step;
            return true;
          }
        double damping = std::min(1., longest_step / size);
        while (true)
          {
            equations(x + damping * step, trial_residual, trial_jacobian);
            if (trial_residual.allFinite() && trial_residual.norm() < residual.norm())
              break;
            damping /= 2;
            if (damping < least_damping)
              return false;
          }
        x += damping * step;
        residual = trial_residual;
        jacobian = trial_jacobian;
      }
    return false;
  }
} // namespace vfife

#endif
