// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_base_median_h
#define vfife_base_median_h

#include <vector>

namespace vfife
{
  /** The upper one of the middle two, where there are two. @p values: at least one. */
  double median_of(std::vector<double> values);
} // namespace vfife

#endif
