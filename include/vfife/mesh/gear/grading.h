// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_mesh_gear_grading_h
#define vfife_mesh_gear_grading_h

#include <vector>

namespace vfife
{
  /** Ends of @p n cells on [0, 1] whose sizes grow by a constant factor, the last being @p ratio
   * times the first; equal sizes for 1. */
  std::vector<double> graded_places(unsigned int n, double ratio);

  /** The same from both ends to the middle: the largest cells there are @p ratio times those at the
   * ends. */
  std::vector<double> graded_places_from_both_ends(unsigned int n, double ratio);
} // namespace vfife

#endif
