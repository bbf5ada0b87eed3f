// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/sample_measures.h>
#include <vfife/base/text/column_names.h>
#include <vfife/base/text/figure_text.h>
#include <vfife/base/text/table.h>
#include <vfife/study/compare/model_comparison.h>
#include <vfife/study/compare/nearest_mode.h>
#include <vfife/study/compare/spectrum_lines.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>
#include <vector>

namespace vfife
{
  namespace
  {
    /** Names of the columns of one probe in the history of a general model. */
    struct ProbeColumns
    {
      std::string              name;
      std::vector<std::string> displacements; ///< three
      std::vector<std::string> stresses;      ///< six
      std::string              von_mises;
    };

    /** In the order of the history. */
    std::vector<ProbeColumns> find_probe_columns(const Table &history)
    {
      const std::string         displacement = std::string(" ") + column::displacement + " ";
      std::vector<ProbeColumns> probes;
      // The columns of a probe stand together: displacements open it, its stresses and von Mises
      // follow.
      for (const Table::Column &column : history.columns())
        {
          //   NAME displacement x, ... y, ... z, NAME stress x, ... , NAME von mises
          const std::size_t at = column.name.find(displacement);
          if (at != std::string::npos)
            {
              const std::string name = column.name.substr(0, at);
              if (probes.empty() || probes.back().name != name)
                probes.push_back({name, {}, {}, ""});
              probes.back().displacements.push_back(column.name);
            }
          else if (!probes.empty() &&
                   column.name.rfind(probes.back().name + " " + column::stress + " ", 0) == 0)
            probes.back().stresses.push_back(column.name);
          else if (!probes.empty() && column.name == probes.back().name + " " + column::von_mises)
            probes.back().von_mises = column.name;
        }
      return probes;
    }

    /** A probe that moves less than this part of the one that moves most shows round-off and
     * differences of second order; likewise of stresses. */
    constexpr double least_part = .01;

    /** What a column shows at rest, and how much of it is not at rest. */
    struct RestValue
    {
      double value     = 0;
      double vibration = 0; ///< largest deviation from it
    };

    /** Of a run the mean of its last third, of a `static` its last load step. */
    RestValue find_rest(const std::vector<double> &values, const bool is_run)
    {
      // A run has left its start behind by then; what still vibrates decides whether it is judged.
      const auto   from = values.end() - (is_run ? values.size() / 3 : 1);
      const double mean = std::accumulate(from, values.end(), 0.) / (values.end() - from);
      const auto   ends = std::minmax_element(from, values.end());
      return {mean, std::max(*ends.second - mean, mean - *ends.first)};
    }

    /** The column of largest magnitude in the last row. */
    std::string find_largest(const Table &table, const std::vector<std::string> &columns)
    {
      return *std::max_element(columns.begin(),
                               columns.end(),
                               [&](const std::string &a, const std::string &b) {
                                 return std::abs(table.numbers(a).back()) <
                                        std::abs(table.numbers(b).back());
                               });
    }

    /** The last state of an explicit case beside that of linear statics, probe by probe. */
    class ModelAtRest
    {
    public:
      ModelAtRest(const ComparedCase &explicit_case, const ComparedCase &linear)
        : is_run_(explicit_case.kind == "run")
        , history_(explicit_case.table("history.csv"))
        , reference_(linear.table("history.csv"))
      {
      }

      void add_rows(const ComparisonTolerances &tolerances, ComparisonRows &rows) const
      {
        if (history_.n_rows() < (is_run_ ? 3 : 1) || reference_.n_rows() == 0)
          return;
        // 1. Probes that both cases have.
        std::vector<ProbeColumns> probes = find_probe_columns(reference_);
        const auto                known  = find_probe_columns(history_);
        probes.erase(std::remove_if(probes.begin(),
                                    probes.end(),
                                    [&known](const ProbeColumns &probe) {
                                      return std::none_of(known.begin(),
                                                          known.end(),
                                                          [&](const ProbeColumns &other) {
                                                            return other.displacements ==
                                                                   probe.displacements;
                                                          });
                                    }),
                     probes.end());
        // 2. The largest of all of them: beside it small ones are not judged.
        double displacement = 0, stress = 0;
        for (const ProbeColumns &probe : probes)
          {
            displacement =
              std::max(displacement, magnitude(find_largest(reference_, probe.displacements)));
            stress = std::max(stress, magnitude(probe.von_mises));
          }
        // 3. Of each the component that moves most, the largest stress and von Mises.
        for (const ProbeColumns &probe : probes)
          {
            add_row(find_largest(reference_, probe.displacements),
                    "mm",
                    displacement,
                    tolerances.displacement,
                    rows);
            add_row(
              find_largest(reference_, probe.stresses), "MPa", stress, tolerances.stress, rows);
            add_row(probe.von_mises, "MPa", stress, tolerances.stress, rows);
          }
      }

    private:
      double magnitude(const std::string &column) const
      {
        return std::abs(reference_.numbers(column).back());
      }

      /** @p largest: of such columns of all probes, @p tolerance: part of the reference. */
      void add_row(const std::string &column,
                   const std::string &unit,
                   const double       largest,
                   const double       tolerance,
                   ComparisonRows    &rows) const
      {
        const RestValue rest = find_rest(history_.numbers(column), is_run_);
        ComparisonRow   row{column + (is_run_ ? ", run" : ", static"),
                          unit,
                          rest.value,
                          reference_.numbers(column).back(),
                          "FEM",
                          {},
                          ""};
        const double    size = std::abs(row.reference);
        row.reason           = is_run_ ? "mean of the last third of the run against linear statics"
                                       : "equilibrium by relaxation against linear statics";
        if (size < least_part * largest)
          row.reason += "; below 1 % of the largest of all probes";
        else if (rest.vibration > tolerance * size)
          row.reason += "; the run still vibrates by more than the tolerance";
        else
          row.tolerance = tolerance * size;
        rows.push_back(row);
      }

      bool  is_run_;
      Table history_, reference_;
    };

    /**
     * Rows of general models at rest or in steady spin: displacements and stresses of the probes of
     * a `static` or a `run` (its last third) against `linear static`, as far as these are among the
     * cases (doc/reference/sweep-and-compare.md). Throws InputError where results cannot be read.
     */
    ComparisonRows compare_statics(const ComparedCases        &cases,
                                   const ComparisonTolerances &tolerances)
    {
      ComparisonRows            rows;
      const ComparedCase *const linear = find_case(cases, "linear static", "history.csv");
      if (linear == nullptr)
        return rows;
      for (const char *kind : {"static", "run"})
        {
          const ComparedCase *const found = find_case(cases, kind, "history.csv");
          if (found != nullptr && !found->is_pair)
            ModelAtRest(*found, *linear).add_rows(tolerances, rows);
        }
      return rows;
    }

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
      if (modes.empty() || time.empty())
        return;
      const std::size_t n_before = rows.size();
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
              const double own = peak_to_peak_of(history.numbers(column));
              if (own > swing)
                {
                  swing   = own;
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
      if (rows.size() == n_before)
        run.lack = sentence_of(4,
                               "the record of the case \"",
                               run.name,
                               "\", ",
                               time.size(),
                               " samples in ",
                               1e3 * (time.back() - time.front()),
                               " ms, has no line of a spectrum up to ",
                               highest,
                               " Hz at any probe. Extend the run, or add a probe");
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
