// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// The part of SweepStudy that does the runs.
#include <vfife/base/errors.h>
#include <vfife/base/parameters/file_names.h>
#include <vfife/base/process/command_line.h>
#include <vfife/base/process/communicator.h>
#include <vfife/base/process/log.h>
#include <vfife/base/text/table.h>
#include <vfife/base/types.h>
#include <vfife/output/files/output_folder.h>
#include <vfife/output/files/run_figures.h>
#include <vfife/output/files/table_reader.h>
#include <vfife/output/files/table_writer.h>
#include <vfife/output/pictures.h>
#include <vfife/study/sweep/sweep_study.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace vfife
{
  namespace
  {
    namespace fs = std::filesystem;

    /** Some of the ranks. */
    class Split
    {
    public:
      Split(const Communicator &all, const unsigned int index)
      {
        MPI_Comm_split(all.mpi(), static_cast<int>(index), static_cast<int>(all.rank()), &comm_);
      }
      ~Split()
      {
        MPI_Comm_free(&comm_);
      }
      Split(const Split &)            = delete;
      Split &operator=(const Split &) = delete;

      MPI_Comm mpi() const
      {
        return comm_;
      }

    private:
      MPI_Comm comm_ = MPI_COMM_NULL;
    };

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
              numbers[i] = figure.compute(read_result_table(folders[i] + "/" + figure.file()));
              unit       = numbers[i].unit;
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

  std::vector<NamedFigures> SweepStudy::read_figures(const OutputFolder            &folder,
                                                     const std::vector<Values>     &runs,
                                                     const std::vector<CaseReport> &reports,
                                                     Log                           &log) const
  {
    // 1. What each summary says; a run that has not finished has no figures of its history.
    std::vector<NamedFigures> all;
    std::vector<std::string>  paths, finished;
    for (std::size_t i = 0; i < runs.size(); ++i)
      {
        const std::string path = folder.file(folder_of_run(i));
        all.push_back(read_run_figures(path).figures);
        paths.push_back(path);
        finished.push_back(reports[i].outcome == Outcome::finished ? path : "");
      }
    // 2. What cases state by names of their own.
    const std::vector<NamedFigures> own = read_own_figures(paths);
    for (std::size_t i = 0; i < runs.size(); ++i)
      all[i].insert(all[i].end(), own[i].begin(), own[i].end());
    // 3. Figures of the histories, each with its error and the order of convergence over the run
    // before.
    for (const HistoryFigure &figure : figures_)
      {
        const std::vector<Figure> numbers      = compute_of_runs(figure, finished, log);
        double                    error_before = not_known;
        for (std::size_t i = 0; i < runs.size(); ++i)
          {
            const double error = figure.compute_error(numbers[i].value);
            all[i].emplace_back(figure.name, numbers[i]);
            all[i].emplace_back(figure.name + " error",
                                Figure{error, figure.error_unit(numbers[i].unit)});
            all[i].emplace_back(figure.name + " order",
                                Figure{i > 0
                                         ? compute_order(error_before, error, runs[i - 1], runs[i])
                                         : not_known,
                                       "-"});
            error_before = error;
          }
      }
    return all;
  }

  void SweepStudy::write_results(const OutputFolder            &folder,
                                 const std::vector<Values>     &runs,
                                 const std::vector<CaseReport> &reports,
                                 Log                           &log) const
  {
    if (!folder.is_writer())
      return;
    const std::vector<NamedFigures> all = read_figures(folder, runs, reports, log);
    // Figures that no run has are left out.
    std::vector<std::size_t> known;
    for (std::size_t f = 0; f < all.front().size(); ++f)
      if (std::any_of(all.begin(), all.end(), [f](const NamedFigures &run) {
            return std::isfinite(run[f].second.value);
          }))
        known.push_back(f);

    // sweep.csv: run, swept values, status, then the figures; sweep.json has the same.
    NamedFigures named;
    for (const std::size_t f : known)
      named.push_back(all.front()[f]);
    Table table = make_sweep_table(names_, named);
    Json  json  = Json::array();
    for (std::size_t i = 0; i < runs.size(); ++i)
      {
        const std::string        word = word_for(reports[i].outcome);
        std::vector<Table::Cell> row  = {folder_of_run(i)};
        Json                     one  = {{"run", folder_of_run(i)}};
        NamedFigures             figures;
        for (std::size_t p = 0; p < parameters_.size(); ++p)
          {
            row.emplace_back(runs[i][p]);
            one["values"][parameters_[p].entry] = runs[i][p];
          }
        row.emplace_back(word);
        for (const std::size_t f : known)
          {
            row.emplace_back(all[i][f].second.value);
            figures.push_back(all[i][f]);
          }
        one["status"]  = word;
        one["message"] = reports[i].message;
        one["figures"] = figures_json(figures);
        table.add_row(row);
        json.push_back(one);
      }
    // Written anew after each round: what has been found stays when the sweep is stopped.
    write_csv(folder, "sweep.csv", table);
    Json whole = {{"base", base_}, {"runs", json}};
    if (!error_by_.empty())
      whole.update(write_errors(folder, reports, all));
    write_json(folder, "sweep.json", whole);
  }

  void SweepStudy::copy_beside(const OutputFolder &folder) const
  {
    for (std::size_t i = 0; i < beside_.size(); ++i)
      {
        const fs::path    from(beside_[i]);
        const std::string name = "beside/" + std::to_string(i + 1);
        folder.make_subfolder(name);
        // Copied, so that the report finds them when the folder of the sweep is moved.
        for (const char *file :
             {"coupled_modes.csv", "resonance.csv", "lumped.json", "parameters.prm"})
          if (folder.is_writer() && is_there((from / file).string()))
            folder.copy_file((from / file).string(), name + "/" + file);
      }
  }

  void SweepStudy::run(OutputFolder &folder, Log &log)
  {
    // Rounds of as many runs as there are groups of ranks; after each round all ranks know how its
    // runs have ended, and the tables are written anew.
    copy_beside(folder);
    const Communicator       &all      = folder.communicator();
    const std::vector<Values> runs     = list_runs();
    const unsigned int        n_groups = count_groups(all);
    // Ranks that an uneven division leaves over join the last group.
    const unsigned int      index = std::min(all.rank() / (all.size() / n_groups), n_groups - 1);
    const Split             split(all, index);
    Communicator            group(split.mpi());
    std::vector<CaseReport> reports(runs.size());
    bool                    stops = false;
    for (std::size_t first = 0; first < runs.size() && !stops; first += n_groups)
      {
        //   n_groups = 3:   ranks 0 1 | 2 3 | 4 5 6      first    run 1 | run 2 | run 3
        //                   group 0   |  1  |   2        then     run 4 | run 5 |   -
        const std::size_t end = std::min(first + n_groups, runs.size());
        for (std::size_t i = first; i < end; ++i)
          {
            log.line(folder_of_run(i), " begins: ", describe(runs[i]));
            folder.list_file(folder_of_run(i) + "/");
          }
        CaseReport report;
        // In a last round that is not full some groups have nothing to do: they wait for the others
        // below.
        if (first + index < end)
          {
            CommandLine line   = command_line(runs[first + index]);
            line.output_folder = folder.file(folder_of_run(first + index));
            report             = runner_.do_case(line, restart_, group);
          }

        // Each group's first rank tells, the others wait.
        const auto outcomes = all.all_gather(group.is_root() ? report.outcome : Outcome::waits);
        const auto messages = all.all_gather(report.message);
        const auto groups   = all.all_gather(index);
        for (unsigned int rank = 0; rank < all.size(); ++rank)
          if (outcomes[rank] != Outcome::waits)
            {
              const std::size_t i = first + groups[rank];
              reports[i]          = {outcomes[rank], messages[rank]};
              stops               = stops || outcomes[rank] == Outcome::interrupted;
              log.line(folder_of_run(i), " ", reports[i].describe());
            }
        write_results(folder, runs, reports, log);
      }
    // Only now, with all tables written, is an interruption or a failure passed on.
    if (stops)
      throw Interrupted("the sweep is stopped. Run the same command with --restart to continue");
    if (pictures_)
      draw_pictures(folder, log);
    const auto n_failed =
      std::count_if(reports.begin(), reports.end(), [](const CaseReport &report) {
        return report.outcome == Outcome::failed;
      });
    if (n_failed > 0)
      throw NumericalError(std::to_string(n_failed) + " of " + std::to_string(runs.size()) +
                           " runs have failed; \"" + folder.file("sweep.json") +
                           "\" states the reason");
  }
} // namespace vfife
