// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_study_reduced_speed_sweep_files_h
#define vfife_study_reduced_speed_sweep_files_h

namespace vfife
{
  class Log;
  class OutputFolder;
  class PairSpeedSweep;
  struct RunSummary;

  /** Energy error of a speed above which it is told, as of a run (doc/verification/dynamics.md)
   * [-].
   */
  constexpr double largest_energy_error = 0.005;

  /**
   * Does the sweep and writes its tables after each speed, exceedances.csv and @p summary at the
   * end, which has what was known before. Throws NumericalError after that, and Interrupted where a
   * signal has come. Collective.
   */
  void run_speed_sweep(PairSpeedSweep &sweep, RunSummary &summary, OutputFolder &folder, Log &log);
} // namespace vfife

#endif
