// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/study/compare/nearest_mode.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace vfife
{
  ComparisonRow compare_with_modes(const std::string         &quantity,
                                   const double               line,
                                   const double               length,
                                   const std::vector<double> &modes,
                                   const double               tolerance)
  {
    const double mode =
      *std::min_element(modes.begin(), modes.end(), [line](const double a, const double b) {
        return std::abs(a - line) < std::abs(b - line);
      });
    // Modes that are closer to each other than the tolerance count as one: the verdict hardly
    // depends on which of them it is.
    double neighbour = std::numeric_limits<double>::infinity();
    for (const double other : modes)
      if (std::abs(other - mode) > tolerance * mode)
        neighbour = std::min(neighbour, std::abs(other - mode));

    ComparisonRow      row{quantity, "Hz", line, mode, "FEM", {}, ""};
    std::ostringstream reason;
    reason << "the record of " << 1e3 * length << " ms separates " << 2 / length << " Hz";
    if (std::isfinite(neighbour))
      reason << ", the next mode is " << neighbour << " Hz away";
    // 2/T is half the width of the window's main lobe: lines of closer modes run into each other.
    // A difference of less than a line of the spectrum, 1/T, may agree but refutes nothing.
    const double difference = std::abs(line - mode);
    const bool   is_refuted = difference > tolerance * mode;
    if (neighbour > 2 / length && is_refuted && difference < 1 / length)
      reason << "; the difference exceeds the tolerance, but not the line spacing of the spectrum, "
             << 1 / length << " Hz";
    else if (neighbour > 2 / length)
      row.tolerance = tolerance * mode;
    row.reason = reason.str();
    return row;
  }
} // namespace vfife
