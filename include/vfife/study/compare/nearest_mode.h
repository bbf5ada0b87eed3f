// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_study_compare_nearest_mode_h
#define vfife_study_compare_nearest_mode_h

#include <vfife/study/compare/comparison.h>

#include <string>
#include <vector>

namespace vfife
{
  /**
   * A line of a spectrum [Hz] of a record of @p length [s] beside the nearest of the natural
   * frequencies @p modes [Hz]. It is not judged where the record cannot tell which mode it is:
   * where another one (farther away than @p tolerance, a part of the frequency) is within 2/length.
   */
  ComparisonRow compare_with_modes(const std::string         &quantity,
                                   double                     line,
                                   double                     length,
                                   const std::vector<double> &modes,
                                   double                     tolerance);
} // namespace vfife

#endif
