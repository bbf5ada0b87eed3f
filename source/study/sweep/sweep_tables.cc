// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/process/log.h>
#include <vfife/base/text/table.h>
#include <vfife/base/types.h>
#include <vfife/output/files/output_folder.h>
#include <vfife/output/files/run_figures.h>
#include <vfife/output/files/table_reader.h>
#include <vfife/output/files/table_writer.h>
#include <vfife/study/sweep/sweep_tables.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace vfife
{
  namespace
  {
    /** Of finished runs, whose folders these are; where a name is empty there is no number. All
     * have the same unit. */
    std::vector<Figure>
    compute_of_runs(const HistoryFigure &figure, const std::vector<std::string> &folders, Log &log)
    {
      std::vector<Figure> numbers(folders.size(), Figure{not_known, "-"});
      std::string         unit = "-";
      for (std::size_t i = 0; i < folders.size(); ++i)
        if (!folders[i].empty())
          try
            {
              const FoundFigure found =
                figure.compute(read_result_table(folders[i] + "/" + figure.file()));
              numbers[i] = found;
              unit       = found.unit;
              if (!found.fault.empty())
                log.warning(
                  SweepRuns::folder_of(i), ": figure \"", figure.name, "\": ", found.fault);
            }
          catch (const InputError &error)
            {
              log.warning("figure \"", figure.name, "\": ", error.what());
            }
      // Also those without a number: a column of the table has one unit.
      for (Figure &number : numbers)
        number.unit = unit;
      return numbers;
    }
  } // namespace

  Table make_sweep_table(const std::vector<std::string> &parameters, const NamedFigures &figures)
  {
    Table table;
    table.add_text_column("run");
    for (const std::string &parameter : parameters)
      table.add_text_column(parameter);
    table.add_text_column("status");
    for (const auto &[name, figure] : figures)
      table.add_column(name, figure.unit);
    return table;
  }

  void SweepTables::check() const
  {
    // Names that the table has anyway: a run that does not exist has the same figures as any other.
    std::vector<std::string> taken = {"run", "status"};
    for (const auto &figure : read_run_figures("").figures)
      taken.push_back(figure.first);
    for (const std::string &name : runs.names)
      {
        if (std::count(taken.begin(), taken.end(), name) > 0)
          throw InputError("Sweep/parameters",
                           "rename the parameter: \"" + name +
                             "\" is already a column of sweep.csv");
        taken.push_back(name);
      }
    for (const HistoryFigure &figure : figures)
      {
        const std::string section = "Sweep/Figure " + figure.name;
        figure.check(section);
        // Each figure has three columns.
        for (const char *ending : {"", " error", " order"})
          {
            if (std::count(taken.begin(), taken.end(), figure.name + ending) > 0)
              throw InputError(section,
                               "rename the figure: \"" + figure.name + ending +
                                 "\" is already a column of sweep.csv");
            taken.push_back(figure.name + ending);
          }
      }
  }

  std::vector<NamedFigures> SweepTables::read_figures(const OutputFolder            &folder,
                                                      const std::vector<CaseReport> &reports,
                                                      Log                           &log) const
  {
    const std::vector<SweepRuns::Values> list = runs.list();
    // 1. What each summary says; a run that has not finished has no figures of its history.
    std::vector<NamedFigures> all;
    std::vector<std::string>  paths, finished;
    for (std::size_t i = 0; i < list.size(); ++i)
      {
        const std::string path = folder.file(SweepRuns::folder_of(i));
        all.push_back(read_run_figures(path).figures);
        paths.push_back(path);
        finished.push_back(reports[i].outcome == Outcome::finished ? path : "");
      }
    // 2. What cases state by names of their own.
    const std::vector<NamedFigures> own = read_own_figures(paths);
    for (std::size_t i = 0; i < list.size(); ++i)
      all[i].insert(all[i].end(), own[i].begin(), own[i].end());
    // 3. Figures of the histories, each with its error and the order of convergence over the run
    // before.
    for (const HistoryFigure &figure : figures)
      {
        const std::vector<Figure> numbers      = compute_of_runs(figure, finished, log);
        double                    error_before = not_known;
        for (std::size_t i = 0; i < list.size(); ++i)
          {
            const double error = figure.compute_error(numbers[i].value);
            all[i].emplace_back(figure.name, numbers[i]);
            all[i].emplace_back(figure.name + " error",
                                Figure{error, figure.error_unit(numbers[i].unit)});
            all[i].emplace_back(figure.name + " order",
                                Figure{i > 0
                                         ? compute_order(error_before, error, list[i - 1], list[i])
                                         : not_known,
                                       "-"});
            error_before = error;
          }
      }
    return all;
  }

  void SweepTables::write(const OutputFolder            &folder,
                          const std::vector<CaseReport> &reports,
                          Log                           &log) const
  {
    if (!folder.is_writer())
      return;
    const std::vector<NamedFigures> all = read_figures(folder, reports, log);
    // Figures that no run has are left out, but not those that the sweep asks for.
    const auto is_asked = [this](const std::string &name) {
      return std::any_of(figures.begin(), figures.end(), [&name](const HistoryFigure &figure) {
        return figure.name == name;
      });
    };
    std::vector<std::size_t> known;
    for (std::size_t f = 0; f < all.front().size(); ++f)
      if (is_asked(all.front()[f].first) ||
          std::any_of(all.begin(), all.end(), [f](const NamedFigures &run) {
            return std::isfinite(run[f].second.value);
          }))
        known.push_back(f);

    // sweep.csv: run, swept values, status, then the figures; sweep.json has the same.
    NamedFigures named;
    for (const std::size_t f : known)
      named.push_back(all.front()[f]);
    const std::vector<SweepRuns::Values> list  = runs.list();
    Table                                table = make_sweep_table(runs.names, named);
    Json                                 json  = Json::array();
    for (std::size_t i = 0; i < list.size(); ++i)
      {
        const std::string        word = word_for(reports[i].outcome);
        std::vector<Table::Cell> row  = {SweepRuns::folder_of(i)};
        Json                     one  = {{"run", SweepRuns::folder_of(i)}};
        NamedFigures             own;
        for (std::size_t p = 0; p < runs.parameters.size(); ++p)
          {
            row.emplace_back(list[i][p]);
            one["values"][runs.parameters[p].entry] = list[i][p];
          }
        row.emplace_back(word);
        for (const std::size_t f : known)
          {
            row.emplace_back(all[i][f].second.value);
            own.push_back(all[i][f]);
          }
        one["status"]  = word;
        one["message"] = reports[i].message;
        one["figures"] = figures_json(own);
        table.add_row(row);
        json.push_back(one);
      }
    // Written anew after each round: what has been found stays when the sweep is stopped.
    write_csv(folder, "sweep.csv", table);
    Json whole = {{"base", base}, {"runs", json}};
    if (!runs.numerical.empty())
      whole.update(write_errors(folder, reports, all));
    write_json(folder, "sweep.json", whole);
  }

  Json SweepTables::write_errors(const OutputFolder              &folder,
                                 const std::vector<CaseReport>   &reports,
                                 const std::vector<NamedFigures> &all) const
  {
    // Columns that references add to a figure are no figures of their own.
    std::vector<std::string> others;
    for (const HistoryFigure &figure : figures)
      for (const char *ending : {" error", " order"})
        others.push_back(figure.name + ending);
    std::vector<std::string>  names, folders;
    std::vector<NamedFigures> known;
    for (std::size_t i = 0; i < all.size(); ++i)
      {
        names.push_back(SweepRuns::folder_of(i));
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
    const ErrorTables tables = compute_error_tables(runs.list_variants(folders), names, known);
    write_csv(folder, "error_bars.csv", tables.bars);
    write_csv(folder, "differences.csv", tables.differences);
    return {{"error bars", tables.bars.json()}, {"differences", tables.differences.json()}};
  }
} // namespace vfife
