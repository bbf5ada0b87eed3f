// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/sample_measures.h>
#include <vfife/base/types.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace vfife
{
  double mean_of(const std::vector<double> &values)
  {
    return std::accumulate(values.begin(), values.end(), 0.) / values.size();
  }

  double median_of(std::vector<double> values)
  {
    const auto middle = values.begin() + values.size() / 2;
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
  }

  double peak_to_peak_of(const std::vector<double> &values)
  {
    if (values.empty() || std::isnan(mean_of(values)))
      return not_known;
    const auto [least, largest] = std::minmax_element(values.begin(), values.end());
    return *largest - *least;
  }
} // namespace vfife
