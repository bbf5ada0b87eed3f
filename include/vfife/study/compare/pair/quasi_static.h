// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_study_compare_pair_quasi_static_h
#define vfife_study_compare_pair_quasi_static_h

#include <vfife/base/text/table.h>

#include <optional>
#include <vector>

namespace vfife
{
  /** Modes that take part in the turn of the hub. */
  struct TurningModes
  {
    std::vector<double> frequencies; ///< [Hz]
    std::vector<double> shares;      ///< of the static turn under a torque [-]

    /** Of a table of coupled modes (coupled_modes.csv): those standing in space where there are
     * such, with a share above @p least. */
    TurningModes(const Table &coupled_modes, double least);
  };

  /**
   * The mean mesh cycle of a history, linear between its samples, at @p positions of the mesh
   * [mesh cycles]; nothing at positions that it does not pass.
   */
  std::vector<std::optional<double>> compute_mean_mesh(const std::vector<double> &time,
                                                       const std::vector<double> &values,
                                                       double                     mesh_frequency,
                                                       const std::vector<double> &positions);

  /**
   * How far a pair's transmission error may depart from its static curve because it swings
   * (doc/reference/sweep-and-compare.md): harmonic k of the curve is followed by a mode f_i with
   * the amplification 1/(1 - r^2), r = k f_mesh/f_i, so the departure is at most sum_k A_k |sum_i
   * s_i r^2/(1 - r^2)| without damping; s_i: shares. @p curve: at positions that lie evenly over
   * one mesh cycle, from its beginning on; harmonics are those they resolve. In the unit of the
   * curve.
   */
  double estimate_swing(const std::vector<double> &curve,
                        double                     mesh_frequency,
                        const TurningModes        &modes);
} // namespace vfife

#endif
