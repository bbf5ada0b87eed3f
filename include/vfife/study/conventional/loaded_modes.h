// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_study_conventional_loaded_modes_h
#define vfife_study_conventional_loaded_modes_h

namespace vfife
{
  class Compliance;
  class Log;
  class OutputFolder;
  struct FemOptions;
  struct Model;
  struct PairEquilibriumResult;

  /** Which modes of a loaded pair are looked for. */
  struct LoadedModes
  {
    const FemOptions &fem;
    bool              spins   = true; ///< both bodies, at their speeds
    unsigned int      n_modes = 0;    ///< the lowest
  };

  /** Natural vibrations of the pair tied together where it touches in @p result:
   * coupled_modes.csv, shapes in the folder modes, and those that turn the hub in the log. */
  void write_loaded_modes(const Model                 &model,
                          const Compliance            &compliance,
                          const PairEquilibriumResult &result,
                          const LoadedModes           &what,
                          const OutputFolder          &folder,
                          Log                         &log);
} // namespace vfife

#endif
