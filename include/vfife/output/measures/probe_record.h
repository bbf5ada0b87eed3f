// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_output_measures_probe_record_h
#define vfife_output_measures_probe_record_h

#include <functional>
#include <string>
#include <vector>

namespace vfife
{
  /** What a probe of a gear has seen of its passage through a turn. Stresses are von Mises [MPa].
   */
  struct ProbeRecord
  {
    std::string name;
    double      passes_mesh = 0; ///< time at which it passes the mean contact [s]; < 0: before
    double      peak = 0, peak_time = 0, least = 0; ///< of the record; time [s]

    // Of the whole turn, from the probe's copies in all sectors at the end of the run.
    double largest = 0, median = 0;
    double largest_after_mesh = 0; ///< where that is [mesh cycles after the mean contact]

    bool has_peak   = false; ///< the probe has passed the place of the largest stress
    bool has_median = false; ///< the record goes down to the median, ProbeRecord::level

    /** A record shows the median where it comes as near to it as this part of the rise from the
     * median to the largest stress. */
    static constexpr double level = 0.1;

    /** One sentence for screen, summary and report. */
    std::string explain() const;
  };

  /**
   * @param name        of the probe
   * @param times       of the record [s], from the start of the run on
   * @param stresses    of the record
   * @param end         of the run [s]
   * @param turn        stress of copy m then, where the probe will be m mesh cycles later; one a
   *                    tooth
   * @param meshes      mesh cycles from the start of the run to a time [s]
   * @param passes_mesh ProbeRecord::passes_mesh [s]
   */
  ProbeRecord make_probe_record(const std::string                   &name,
                                const std::vector<double>           &times,
                                const std::vector<double>           &stresses,
                                double                               end,
                                const std::vector<double>           &turn,
                                const std::function<double(double)> &meshes,
                                double                               passes_mesh);
} // namespace vfife

#endif
