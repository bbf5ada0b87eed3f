// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/text/column_names.h>
#include <vfife/study/compare/model_comparison.h>
#include <vfife/study/compare/nearest_mode.h>
#include <vfife/study/compare/probe_columns.h>
#include <vfife/study/compare/spectrum_lines.h>
#include <vfife/study/compare/static_comparison.h>

#include <algorithm>

namespace vfife
{
  namespace
  {
    /** Lines of a run that rings down beside the natural frequencies: what moves most at each
     * probe. */
    void add_ring_down(const ComparedCase         &run,
                       const ComparedCase         &modal,
                       const ComparisonTolerances &tolerances,
                       ComparisonRows             &rows)
    {
      const Table         table = modal.table("modes.csv"), history = run.table("history.csv");
      std::vector<double> modes;
      // Modes at the first speed of the table; rigid motions (0 Hz) make no line.
      for (std::size_t i = 0; i < table.n_rows(); ++i)
        if (table.numbers(column::speed)[i] == table.numbers(column::speed)[0] &&
            table.numbers(column::frequency)[i] > 0)
          modes.push_back(table.numbers(column::frequency)[i]);
      const std::vector<double> &time = history.numbers(column::time);
      if (modes.empty() || time.size() < 8)
        return;
      // Above the highest mode that is known a line has nothing to stand beside; a tenth more shows
      // one that comes out too high.
      const double highest = 1.1 * *std::max_element(modes.begin(), modes.end());
      for (const ProbeColumns &probe : find_probe_columns(history))
        {
          // The component that moves most.
          std::string largest;
          double      swing = 0;
          for (const std::string &column : probe.displacements)
            {
              const auto ends =
                std::minmax_element(history.numbers(column).begin(), history.numbers(column).end());
              if (*ends.second - *ends.first > swing)
                {
                  swing   = *ends.second - *ends.first;
                  largest = column;
                }
            }
          if (largest.empty())
            continue;
          // Lines below a twentieth of the strongest may be side lobes of the window.
          for (const SpectrumLine &line :
               find_spectrum_lines(time, history.numbers(largest), highest, 0.05))
            rows.push_back(compare_with_modes(largest + ", line of the spectrum",
                                              line.frequency,
                                              time.back() - time.front(),
                                              modes,
                                              tolerances.frequency));
        }
    }
  } // namespace

  ComparisonRows compare_models(const ComparedCases &cases, const ComparisonTolerances &tolerances)
  {
    ComparisonRows            rows  = compare_statics(cases, tolerances);
    const ComparedCase *const run   = find_case(cases, "run", "history.csv");
    const ComparedCase *const modal = find_case(cases, "modal", "modes.csv");
    if (run != nullptr && !run->is_pair && modal != nullptr)
      add_ring_down(*run, *modal, tolerances, rows);
    return rows;
  }
} // namespace vfife
