// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_fem_modes_gyroscopic_modes_h
#define vfife_fem_modes_gyroscopic_modes_h

#include <vfife/fem/system/assembly.h>

namespace vfife
{
  class DirectSolver;

  /** A wave u exp(i omega t) with Coriolis forces, u = real + i imaginary (owned unknowns). */
  struct GyroscopicMode
  {
    double rate     = 0; ///< omega > 0 [rad/s]
    double residual = 0; ///< |(K - omega^2 M + 2 i omega C) u| over omega^2 |M u|
    /** T/(T + U) of the energies in the turning axes, means over a period [-]. */
    double      kinetic_share = 0.5;
    OwnedVector real, imaginary;
  };

  /**
   * The lowest @p n waves of M u'' + 2 C u' + K u = 0 with C = Omega G skew, from the quadratic
   * eigenvalue problem projected on @p modes (those of K and M) and on K^-1 C applied to them, the
   * first order of what Coriolis forces change; @p factors are those of K (nearly, where K is
   * singular). Motions slower than @p rigid_rate [rad/s] are rigid ones and left out. The error of
   * omega^2 is of the order of the square of the residual. Throws NumericalError where the motion
   * grows. Collective.
   */
  std::vector<GyroscopicMode> find_gyroscopic_modes(const Assembly                 &assembly,
                                                    const SparseValues             &stiffness,
                                                    const SparseValues             &mass,
                                                    const SparseValues             &coriolis,
                                                    const DirectSolver             &factors,
                                                    const std::vector<OwnedVector> &modes,
                                                    double                          rigid_rate,
                                                    unsigned int                    n);
} // namespace vfife

#endif
