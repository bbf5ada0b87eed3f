// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_study_reduced_speed_ranges_h
#define vfife_study_reduced_speed_ranges_h

#include <vfife/base/text/table.h>

#include <vector>

namespace vfife
{
  /** Where a curve over speed lies above a level. */
  struct SpeedRange
  {
    double from = 0, to = 0; ///< in the unit of the speeds
    double largest = 0;      ///< of the curve
    double at      = 0;      ///< where that is
  };

  /** Ranges in which a curve over rising or falling @p speeds is above @p level, in the order of
   * the speeds: ends are interpolated linearly, or are those of the curve. */
  std::vector<SpeedRange> find_ranges_above(const std::vector<double> &speeds,
                                            const std::vector<double> &curve,
                                            double                     level);

  /** Columns of exceedances.csv. */
  Table make_exceedance_table();

  /**
   * Adds where amplifications are above the @p allowed one, by rows of the tables of a sweep
   * (make_resonance_response_table(), make_stress_response_table()): contact force over its mean,
   * each stress over that without vibration.
   */
  void add_exceedances(const Table &resonance, const Table &stresses, double allowed, Table &table);
} // namespace vfife

#endif
