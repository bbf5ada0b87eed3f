// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_output_measures_ripple_h
#define vfife_output_measures_ripple_h

#include <string>
#include <vector>

namespace vfife
{
  class Table;

  /** The ripple of a column of the history in the two halves of a part of a run. */
  struct RippleChange
  {
    std::string name, unit;
    double      peak_to_peak_before = 0; ///< of the first half, in the column's unit
    double      peak_to_peak_after  = 0; ///< of the second half
    /** The larger of the change of the peak to peak value and of the changes of the first three
     * harmonics of the gear mesh, peak to peak too, over the larger peak to peak value [-];
     * infinite where a sample is no number. */
    double change = 0;
  };

  /** Whether the ripple about the means stays over a part of a run. */
  struct Ripple
  {
    bool                      judged = false; ///< the part has two whole mesh cycles
    bool                      steady = false; ///< judged, and no column changes by the tolerance
    std::vector<RippleChange> columns;        ///< those that were judged

    /** The end of a sentence for screen and report: "the ripple is steady, ...". */
    std::string explain() const;
  };

  /**
   * Compares the halves of a part of a history, of whole mesh cycles each (of an odd number the
   * first one is in neither): the ripple is steady where peak to peak values and harmonics of the
   * mesh cycle differ by less than @p tolerance in all columns of @p names. A figure of a ripple
   * that is not steady is one of its record: half of it would have given another one. A ripple
   * below a ten-thousandth of the mean counts as none.
   *
   * @param history          rows at equal time steps
   * @param names            columns of numbers that the history has
   * @param samples_per_mesh rows in one mesh cycle, > 1, counted from the first row
   * @param first_cycle, end_cycle whole mesh cycles [first, end) of the part
   */
  Ripple compare_halves(const Table                    &history,
                        const std::vector<std::string> &names,
                        double                          samples_per_mesh,
                        unsigned int                    first_cycle,
                        unsigned int                    end_cycle,
                        double                          tolerance = 0.1);
} // namespace vfife

#endif
