// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_study_conventional_loaded_pressure_h
#define vfife_study_conventional_loaded_pressure_h

#include <vfife/fem/pressure/pair_pressure.h>
#include <vfife/study/pressure/pressure_tables.h>

#include <vector>

namespace vfife
{
  class Log;
  class OutputFolder;

  /** Pressures on their own grid at the positions of a loaded tooth contact analysis. */
  class LoadedPressure
  {
  public:
    /** @p outlines: of the members. Model and compliance must outlive this. */
    LoadedPressure(const Model        &model,
                   const PairOutlines &outlines,
                   Compliance         &compliance,
                   double              depth,
                   unsigned int        cells_across);

    /** At the last position of @p equilibrium [mesh cycles]; @p error: its transmission error
     * [rad]. Returns what the grid changes of it [rad]. */
    double add_position(double                       position,
                        double                       error,
                        const PairEquilibrium       &equilibrium,
                        const PairEquilibriumResult &result);

    /** Of the last position; empty where none were found. */
    const std::vector<ToothPressure> &teeth() const
    {
      return teeth_;
    }

    /** The grids of the last position, in words. */
    std::string describe() const;

    /** pressure.csv and pressure_field.csv. */
    void write(const OutputFolder &folder) const;

    NamedFigures list_figures() const;

  private:
    PairPressure               pressure_;
    PressureTables             tables_;
    std::vector<double>        errors_; ///< transmission errors of the positions [arcsec]
    std::vector<ToothPressure> teeth_;
    double                     largest_ = 0; ///< pressure of the last position [MPa]
  };
} // namespace vfife

#endif
