// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_base_sample_measures_h
#define vfife_base_sample_measures_h

#include <vector>

namespace vfife
{
  /** @p values: at least one. */
  double mean_of(const std::vector<double> &values);

  /** The upper one of the middle two, where there are two. @p values: at least one. */
  double median_of(std::vector<double> values);

  /** The largest less the smallest; NaN without a value, and where one is not a number. */
  double peak_to_peak_of(const std::vector<double> &values);
} // namespace vfife

#endif
