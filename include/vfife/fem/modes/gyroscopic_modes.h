// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_fem_modes_gyroscopic_modes_h
#define vfife_fem_modes_gyroscopic_modes_h

#include <vfife/fem/system/fem_matrix.h>

namespace vfife
{
  class DirectSolver;

  /** A wave u exp(i omega t) with Coriolis forces, u = real + i imaginary (owned unknowns). */
  struct GyroscopicMode
  {
    double rate = 0; ///< omega > 0 [rad/s]
    /** |(K - omega^2 M + 2 i omega C) u| over max((omega + |Omega|)^2, |shift|) |M u|: omega +
     * Omega is the largest rate that the motion can have in space. */
    double residual = 0;
    /** T/(T + U) of the energies in the turning axes, means over a period; negative for a wave that
     * the spin has overtaken, since the energy T + U is [-]. */
    double      kinetic_share = 0.5;
    OwnedVector real, imaginary;
  };

  /** M u'' + 2 C u' + K u = 0 with C = Omega G skew. */
  struct GyroscopicSystem
  {
    const FemMatrix    &stiffness, &mass, &coriolis;
    double              rate;    ///< Omega [rad/s]
    const DirectSolver &factors; ///< of K - shift M
    double              shift;   ///< [rad^2/s^2]
  };

  /**
   * The lowest @p n waves, from the quadratic eigenvalue problem projected on @p modes (those of K
   * and M), on what @p rigid motions span, and on (K - shift M)^-1 applied to the Coriolis forces
   * of the modes and, as often as it takes, to the residuals of the waves. The error of omega^2 is
   * of the order of the square of the residual. Waves of which more than half is a rigid motion are
   * left out. Throws NumericalError where the motion grows, or residuals stay above 1e-3.
   * Collective.
   */
  std::vector<GyroscopicMode> find_gyroscopic_modes(const GyroscopicSystem         &system,
                                                    const std::vector<OwnedVector> &modes,
                                                    const std::vector<OwnedVector> &rigid,
                                                    unsigned int                    n);
} // namespace vfife

#endif
