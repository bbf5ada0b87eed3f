// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/sample_measures.h>
#include <vfife/base/text/figure_text.h>
#include <vfife/output/measures/probe_record.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace vfife
{
  ProbeRecord make_probe_record(const std::string                   &name,
                                const std::vector<double>           &times,
                                const std::vector<double>           &stresses,
                                const double                         end,
                                const std::vector<double>           &turn,
                                const std::function<double(double)> &meshes,
                                const double                         passes_mesh)
  {
    ProbeRecord record;
    record.name          = name;
    record.passes_mesh   = passes_mesh;
    const auto peak      = std::max_element(stresses.begin(), stresses.end());
    record.peak          = *peak;
    record.peak_time     = times[peak - stresses.begin()];
    record.least         = *std::min_element(stresses.begin(), stresses.end());
    const double n       = turn.size();
    const auto   largest = std::max_element(turn.begin(), turn.end());
    record.largest       = *largest;
    record.median        = median_of(turn);

    // Where the largest stress is the probe comes after `ahead` meshes more, and was n - ahead
    // meshes ago: in the record if that was within it, which whole meshes decide.
    const double ahead = largest - turn.begin(), ago = ahead > 0 ? n - ahead : 0.;
    const double recorded     = meshes(end) - meshes(times.front());
    record.has_peak           = ago <= recorded + 1e-6;
    const double after        = meshes(end) - meshes(passes_mesh) + ahead;
    record.largest_after_mesh = after - n * std::floor(after / n + .5);
    record.has_median =
      record.least <= record.median + ProbeRecord::level * (record.largest - record.median);
    return record;
  }

  std::string ProbeRecord::explain() const
  {
    std::ostringstream text;
    text << name << ": largest von Mises stress of the record " << figure_text(peak) << " MPa at "
         << figure_text(1e3 * peak_time)
         << " ms; in one revolution, from all sectors at the last time step, "
         << figure_text(largest) << " MPa, " << figure_text(std::abs(largest_after_mesh))
         << " mesh cycles " << (largest_after_mesh < 0 ? "before" : "after") << " contact, median "
         << figure_text(median) << " MPa; ";
    if (has_peak && has_median)
      text << "the record contains this largest value and the median";
    else if (has_peak)
      text << "the record contains this largest value, but not the median (least "
           << figure_text(least) << " MPa)";
    else if (has_median)
      text << "the record contains the median, but not this largest value";
    else
      text << "the record contains neither this largest value nor the median (least "
           << figure_text(least) << " MPa)";
    return text.str();
  }
} // namespace vfife
