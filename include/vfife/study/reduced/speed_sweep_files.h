// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_study_reduced_speed_sweep_files_h
#define vfife_study_reduced_speed_sweep_files_h

namespace vfife
{
  class Log;
  class OutputFolder;
  class PairSpeedSweep;
  struct Model;

  /** What the files of a sweep over speed say beside its tables. */
  struct SpeedSweepFiles
  {
    double allowed_amplification = 0; ///< for exceedances.csv; 0: none is written
    double cutoff                = 0; ///< of the bodies [Hz]
  };

  /**
   * Does the sweep and writes its tables after each speed, exceedances.csv and summary.json at the
   * end. Throws NumericalError after that, and Interrupted where a signal has come. Collective.
   */
  void run_speed_sweep(const Model           &model,
                       const SpeedSweepFiles &files,
                       PairSpeedSweep        &sweep,
                       OutputFolder          &folder,
                       Log                   &log);
} // namespace vfife

#endif
