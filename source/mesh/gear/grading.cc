// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/mesh/gear/grading.h>

#include <algorithm>
#include <cmath>

namespace vfife
{
  namespace
  {
    /** Places of cells whose sizes are the ratio to these powers. */
    std::vector<double> add_up(const std::vector<double> &powers, const double ratio)
    {
      std::vector<double> places = {0.};
      for (const double power : powers)
        places.push_back(places.back() + std::pow(ratio, power));
      for (double &place : places)
        place /= places.back();
      return places;
    }
  } // namespace

  std::vector<double> graded_places(const unsigned int n, const double ratio)
  {
    // sizes ratio^(i / (n - 1)), i = 0 ... n - 1
    std::vector<double> powers(n, 0.);
    for (unsigned int i = 1; i < n; ++i)
      powers[i] = double(i) / (n - 1);
    return add_up(powers, ratio);
  }

  std::vector<double> graded_places_from_both_ends(const unsigned int n, const double ratio)
  {
    // rising from both ends: powers 0 ... 1 ... 0
    const unsigned int  middle = (n - 1) / 2;
    std::vector<double> powers(n, 0.);
    if (middle > 0)
      for (unsigned int i = 0; i < n; ++i)
        powers[i] = double(std::min(i, n - 1 - i)) / middle;
    return add_up(powers, ratio);
  }
} // namespace vfife
