// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_fem_system_spin_state_h
#define vfife_fem_system_spin_state_h

#include <vfife/fem/system/system_matrices.h>

#include <functional>

namespace vfife
{
  /** Solves a linear system, the right side in place. */
  using LinearSolve = std::function<void(OwnedVector &)>;
  /** Makes ready what solves with a matrix; may forget the one before. */
  using PrepareSolve = std::function<LinearSolve(FemMatrix)>;

  struct SpinState
  {
    std::vector<double> displacements; ///< of all points, first copy, on all ranks [mm]
    LinearSolve         solve;         ///< with the tangent matrix at the state
  };

  /**
   * The state of steady spin, spinning_residual() = 0, by Newton's method: with the stiffness at
   * rest while that converges, and then with the tangent at the state, with which the last step is
   * made.
   * @p bed: stiffness over mass [rad^2/s^2] of springs under bodies that nothing holds, else 0.
   * @p name names the bodies in errors. Throws NumericalError where no state is found. Collective.
   */
  SpinState find_spin_state(const SystemMatrices       &matrices,
                            const SystemMatrices::Rate &rate,
                            bool                        softening,
                            double                      bed,
                            const std::string          &name,
                            const PrepareSolve         &prepare);
} // namespace vfife

#endif
