// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// The part of SweepStudy that says which runs there are, and what numerical parameters do to
// figures.
#include <vfife/base/errors.h>
#include <vfife/base/text/nearest_name.h>
#include <vfife/base/types.h>
#include <vfife/output/files/output_folder.h>
#include <vfife/output/files/result_places.h>
#include <vfife/output/files/run_figures.h>
#include <vfife/output/files/table_writer.h>
#include <vfife/study/sweep/refinement.h>
#include <vfife/study/sweep/sweep_study.h>

#include <nlohmann/json.hpp>

#include <algorithm>

namespace vfife
{
  bool SweepStudy::is_numerical(const Parameter &parameter) const
  {
    return std::count(error_by_.begin(), error_by_.end(), parameter.name) > 0;
  }

  void SweepStudy::check_numerical() const
  {
    for (const std::string &name : error_by_)
      if (std::count(names_.begin(), names_.end(), name) == 0)
        throw InputError("Sweep/numerical parameters",
                         "\"" + name + "\" is not one of the parameters (" + list_of(names_) + ")" +
                           did_you_mean(name, names_));
    for (const Parameter &parameter : parameters_)
      {
        const std::string         section = "Sweep/Parameter " + parameter.name;
        const std::size_t         n       = parameter.list_values().size();
        const std::vector<double> sizes   = parameter.list_sizes();
        if (is_numerical(parameter) && n < 2)
          throw InputError(
            section + "/values",
            "expected at least two values of a numerical parameter (three for an order)");
        if (sizes.empty())
          continue;
        if (!is_numerical(parameter))
          throw InputError(section + "/relative element sizes",
                           "requires \"" + parameter.name + "\" in Sweep/numerical parameters");
        const bool falls =
          std::adjacent_find(sizes.begin(), sizes.end(), std::less_equal<>()) == sizes.end();
        if (sizes.size() != n || !falls || !(sizes.back() > 0))
          throw InputError(section + "/relative element sizes",
                           "\"" + parameter.sizes + "\" must be " + std::to_string(n) +
                             " decreasing positive numbers, one for each value");
      }
  }

  std::vector<SweepStudy::Values> SweepStudy::list_combinations() const
  {
    // A product begins with one run; each parameter multiplies the runs so far by its values, so
    // the last one changes fastest. A list is as long as the values of its parameters.
    Values values;
    for (const Parameter &parameter : parameters_)
      values.push_back(parameter.list_values().back());
    std::vector<Values> runs(1, values);
    for (std::size_t p = 0; p < parameters_.size(); ++p)
      {
        if (is_numerical(parameters_[p]))
          continue;
        const std::vector<std::string> own = parameters_[p].list_values();
        if (combination_ == Combination::list)
          {
            runs.resize(own.size(), values);
            for (std::size_t i = 0; i < runs.size(); ++i)
              runs[i][p] = own[i];
            continue;
          }
        std::vector<Values> more;
        for (const Values &run : runs)
          for (const std::string &value : own)
            {
              more.push_back(run);
              more.back()[p] = value;
            }
        runs = std::move(more);
      }
    return runs;
  }

  std::vector<SweepStudy::Values> SweepStudy::list_runs() const
  {
    std::vector<Values> runs;
    for (const Values &combination : list_combinations())
      {
        for (std::size_t p = 0; p < parameters_.size(); ++p)
          if (is_numerical(parameters_[p]))
            {
              std::vector<std::string> values = parameters_[p].list_values();
              values.pop_back(); // that of the combination itself
              for (const std::string &value : values)
                {
                  runs.push_back(combination);
                  runs.back()[p] = value;
                }
            }
        runs.push_back(combination);
      }
    return runs;
  }

  std::vector<SweepVariant> SweepStudy::list_variants(const std::vector<std::string> &folders) const
  {
    std::vector<SweepVariant> variants;
    std::size_t               next = 0; // in the order of list_runs()
    for (const Values &combination : list_combinations())
      {
        SweepVariant variant;
        for (std::size_t p = 0; p < parameters_.size(); ++p)
          {
            const Parameter &parameter = parameters_[p];
            if (!is_numerical(parameter))
              {
                variant.name +=
                  (variant.name.empty() ? "" : ", ") + parameter.name + " = " + combination[p];
                continue;
              }
            NumericalSequence sequence{parameter.name, {}, parameter.list_sizes()};
            std::vector<std::vector<std::string>> parts;
            for (const std::string &value : parameter.list_values())
              {
                sequence.runs.push_back(next++);
                parts.push_back(parameter.list_parts(value));
              }
            --next; // the last run of each sequence is that of the combination, behind them all
            if (sequence.sizes.empty())
              sequence.sizes = derive_sizes(parts);
            variant.sequences.push_back(std::move(sequence));
          }
        if (variant.name.empty())
          variant.name = "the case"; // nothing but numerical parameters is varied
        variant.run = next++;
        for (NumericalSequence &sequence : variant.sequences)
          {
            sequence.runs.back() = variant.run;
            std::vector<double> cells;
            for (const std::size_t run : sequence.runs)
              cells.push_back(read_figure(folders[run] + "/summary.json", summary_place::n_cells));
            if (sequence.sizes.empty())
              sequence.sizes = derive_sizes_of_cells(cells);
          }
        variants.push_back(std::move(variant));
      }
    return variants;
  }

  Json SweepStudy::write_errors(const OutputFolder              &folder,
                                const std::vector<CaseReport>   &reports,
                                const std::vector<NamedFigures> &all) const
  {
    // Columns that references add to a figure are no figures of their own.
    std::vector<std::string> others;
    for (const HistoryFigure &figure : figures_)
      for (const char *ending : {" error", " order"})
        others.push_back(figure.name + ending);
    std::vector<std::string>  names, folders;
    std::vector<NamedFigures> known;
    for (std::size_t i = 0; i < all.size(); ++i)
      {
        names.push_back(folder_of_run(i));
        folders.push_back(folder.file(names.back()));
        known.emplace_back();
        for (auto [name, figure] : all[i])
          if (!tells_of_computation(name) && std::count(others.begin(), others.end(), name) == 0)
            {
              // A run that has failed may have figures of what it has done until then.
              if (reports[i].outcome != Outcome::finished)
                figure.value = not_known;
              known.back().emplace_back(name, figure);
            }
      }
    const ErrorTables tables = compute_error_tables(list_variants(folders), names, known);
    write_csv(folder, "error_bars.csv", tables.bars);
    write_csv(folder, "differences.csv", tables.differences);
    return {{"error bars", tables.bars.json()}, {"differences", tables.differences.json()}};
  }
} // namespace vfife
