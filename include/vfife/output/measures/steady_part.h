// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_output_measures_steady_part_h
#define vfife_output_measures_steady_part_h

#include <vfife/base/text/column_names.h>
#include <vfife/output/measures/ripple.h>

#include <cstddef>
#include <string>
#include <vector>

namespace vfife
{
  class Table;

  /** One column of the history over the steady part, in the column's own unit. */
  struct ColumnStatistics
  {
    std::string name, unit;
    double      mean               = 0;
    double      peak_to_peak       = 0; ///< largest minus smallest sample
    double      standard_deviation = 0;
  };

  /** The part of a run that its figures are taken from. */
  struct SteadyPart
  {
    /** False: no steady part exists; everything below is of the last third of the run. */
    bool         found      = false;
    std::size_t  first_row  = 0; ///< rows [first_row, end_row) of the history
    std::size_t  end_row    = 0;
    double       start_time = 0; ///< [s]
    double       end_time   = 0; ///< [s]
    unsigned int cycles =
      0; ///< whole mesh cycles in the part; 0: shorter than one, plain row means
    unsigned int period        = 1;     ///< swing period that was compared, in whole mesh cycles
    unsigned int judged_cycles = 0;     ///< whole mesh cycles after the ramp
    bool         after_ramp    = false; ///< there was one
    /** Fewer than two swing periods after the ramp, but at least one: means of single mesh cycles
     * were compared. */
    bool by_cycles = false;
    /** Largest relative difference of consecutive means in the part (of the last pair when not
     * found). */
    double largest_change = 0;
    /** Of the columns by which the part is judged. Where it is not steady, peak to peak values and
     * standard deviations are those of this record only. */
    Ripple                        ripple;
    std::vector<ColumnStatistics> columns;

    /** Throws InputError where there is no such column. */
    const ColumnStatistics &column(const std::string &name) const;

    /** Whether means and ripple are steady. */
    bool has_steady_ripple() const
    {
      return found && ripple.steady;
    }

    /** One sentence for screen and report. */
    std::string explain() const;
  };

  /**
   * Finds the steady part of a history: it begins at the first whole mesh cycle after the ramp from
   * which on the means over consecutive swing periods differ by less than @p tolerance (relative to
   * the later mean) in all columns of @p judged that exist. "From which on" means every later pair
   * of periods up to the end of the run too, so that a drifting mean that passes by does not count.
   * Without one the last third of the run is used and SteadyPart::found is false.
   *
   * Between one and two swing periods after the ramp there are no consecutive ones. Then the part
   * is steady where the means of all single mesh cycles lie within @p tolerance of each other over
   * at least a whole swing period (SteadyPart::by_cycles): a period shows crest and trough of the
   * swing, and means over longer spans lie between those of the cycles, so this asks for more.
   *
   * Of means that are steady the ripple is judged as well (compare_halves()). The part begins later
   * where the ripple is steady from then on, as long as half the cycles after the ramp and as many
   * as the means ask for remain; otherwise it stays and says so (SteadyPart::ripple).
   *
   * Means and standard deviations are integrals (trapezoidal rule over the equally spaced samples)
   * over whole mesh cycles, counted from the first row; they are exact for whole cycles also when
   * @p samples_per_mesh is not a whole number.
   *
   * @param history             rows at equal time steps; column "time" [s]
   * @param samples_per_mesh    rows in one mesh cycle, > 1
   * @param swing_period_meshes period of the slowest swing [mesh cycles]; rounded up to whole
   * meshes, at least 1
   * @param ramp_end            end of the load's ramp [s]
   * Throws InputError for an empty history or a sample count that makes no sense.
   */
  SteadyPart find_steady_part(const Table                    &history,
                              double                          samples_per_mesh,
                              double                          swing_period_meshes,
                              double                          ramp_end,
                              const std::vector<std::string> &judged = {column::contact_force_total,
                                                                        column::dte},
                              double                          tolerance = 0.01);
} // namespace vfife

#endif
