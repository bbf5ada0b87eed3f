// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_study_run_contact_figures_h
#define vfife_study_run_contact_figures_h

namespace vfife
{
  class HertzContact;
  class Log;
  class Table;
  struct Model;
  struct RunSummary;

  /**
   * Lag that the penalty springs of the contact add to a pair at rest [rad], positive. With
   * pressures p they give way by p/penalty; by virtual work under the torque T the gear yields by
   * int p (p/penalty) dA/T = 2 E/T, E their energy [mJ] and T in N mm: the mean penetration
   * weighted with force, over the arm.
   */
  double compute_penalty_lag(double contact_energy, double torque);

  /** Says what the penalty costs, and what Hertz expects of one tooth pair under all the torque. */
  void
  log_contact_figures(const Model &model, const HertzContact &hertz, double penalty_lag, Log &log);

  /** The same for the summary, and how often the other side of the teeth touched (@p teeth: the
   * rows of teeth.csv, @p n_samples: of the run). */
  void add_contact_figures(const Model        &model,
                           const HertzContact &hertz,
                           double              penalty_lag,
                           const Table        &teeth,
                           unsigned int        n_samples,
                           RunSummary         &summary);
} // namespace vfife

#endif
