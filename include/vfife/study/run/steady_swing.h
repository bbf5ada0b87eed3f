// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_study_run_steady_swing_h
#define vfife_study_run_steady_swing_h

#include <vector>

namespace vfife
{
  class Log;
  struct Model;
  struct RunSummary;
  struct Swing;

  /** Transmission error of a swinging pair beyond the static one at the same position. */
  struct SwingMotion
  {
    double error = 0; ///< [rad]
    double rate  = 0; ///< [rad/s]
    /** Moment of the flanks over the load torque, which differs by the moment of inertia. */
    double torque = 1;
  };

  /** Steady vibration of the swing, transmission errors [rad] at the positions of the static @p
   * errors: see find_steady_swing(). */
  std::vector<double> find_swing_errors(const std::vector<double> &errors,
                                        const Swing               &swing,
                                        double                     mesh_frequency,
                                        double                     mesh_damping);

  /**
   * Steady vibration of the swing at the first of the static transmission @p errors [rad], which
   * are those at equal positions over one gear mesh (doc/theory/equilibrium.md, Steady swing):
   *   J x'' + J zeta_k x' + K (x - s) = 0
   * with s of the period of the gear mesh. @p mesh_damping: zeta_k [1/s]. Where the flanks would
   * lose or gain more than half of the load @p torque [N mm], the vibration is scaled to that half:
   * the equation holds as long as they touch.
   */
  SwingMotion find_steady_swing(const std::vector<double> &errors,
                                const Swing               &swing,
                                double                     mesh_frequency,
                                double                     mesh_damping,
                                double                     torque);

  /** Adds to the figures of @p summary what the springs of the contact points add to the excitation
   * of a pair by their mesh (ContactPair::spring_errors), and says it; nothing where that is not
   * known. */
  void add_spring_excitation(
    const Model &model, const Swing &swing, double mesh_damping, RunSummary &summary, Log &log);
} // namespace vfife

#endif
