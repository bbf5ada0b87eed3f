// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/text/column_names.h>
#include <vfife/study/compare/pair/probe_passages.h>

#include <algorithm>
#include <cmath>

namespace vfife
{
  namespace
  {
    /** Times and von Mises stresses of one probe, ascending in time. */
    using Curve = std::vector<std::pair<double, double>>;

    /** @p abscissa: column of the times or places. */
    Curve curve_of(const Table &table, const std::string &probe, const char *abscissa)
    {
      Curve                           curve;
      const std::vector<std::string> &names = table.column(column::probe).texts;
      for (std::size_t i = 0; i < names.size(); ++i)
        if (names[i] == probe)
          curve.emplace_back(table.numbers(abscissa)[i], table.numbers(column::von_mises)[i]);
      std::sort(curve.begin(), curve.end());
      return curve;
    }

    /** The curve's value at @p time, which lies within it. */
    double value_at(const Curve &curve, const double time)
    {
      const auto next = std::lower_bound(curve.begin(), curve.end(), std::make_pair(time, -1e300));
      if (next == curve.begin())
        return next->second;
      if (next == curve.end())
        return curve.back().second;
      const auto   before = next - 1;
      const double part   = (time - before->first) / (next->first - before->first);
      return before->second + part * (next->second - before->second);
    }
  } // namespace

  std::vector<ProbePassage> compare_passages(const Table       &probes,
                                             const Table       &loaded,
                                             const PassageTime &passes_mesh,
                                             const double       mesh_frequency,
                                             const double       start)
  {
    std::vector<std::string> names = loaded.column(column::probe).texts;
    std::sort(names.begin(), names.end());
    names.erase(std::unique(names.begin(), names.end()), names.end());
    std::vector<ProbePassage> passages;
    for (const std::string &name : names)
      {
        const Curve  run     = curve_of(probes, name, column::time);
        const double in_mesh = passes_mesh(name);
        if (run.empty() || std::isnan(in_mesh))
          continue;
        ProbePassage passage{name};
        // Samples lie on the positions up to round-off.
        const double slack = 1e-6 / mesh_frequency;
        for (const auto &[meshes, stress] : curve_of(loaded, name, column::after_mean_contact))
          {
            // Instants of both: the static places count mesh cycles from the mesh on, which each
            // probe passes at its time. Peaks are taken at the same instants, for a run has many
            // more of them.
            const double time = in_mesh + meshes / mesh_frequency;
            if (time < std::max(start, run.front().first) - slack ||
                time > run.back().first + slack)
              continue;
            const double value = value_at(run, time);
            ++passage.instants;
            passage.peak           = std::max(passage.peak, value);
            passage.reference_peak = std::max(passage.reference_peak, stress);
            passage.distance       = std::max(passage.distance, std::abs(value - stress));
          }
        if (passage.instants > 0)
          passages.push_back(passage);
      }
    return passages;
  }
} // namespace vfife
