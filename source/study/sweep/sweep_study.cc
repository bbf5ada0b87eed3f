// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/parameters/file_names.h>
#include <vfife/base/parameters/parameter_file.h>
#include <vfife/base/parameters/parameters.h>
#include <vfife/base/process/command_line.h>
#include <vfife/base/process/communicator.h>
#include <vfife/base/process/log.h>
#include <vfife/output/files/output_folder.h>
#include <vfife/output/pictures.h>
#include <vfife/study/study_kinds.h>
#include <vfife/study/sweep/sweep_study.h>

#include <deal.II/base/parameter_handler.h>

#include <algorithm>
#include <filesystem>
#include <limits>

namespace vfife
{
  namespace
  {
    namespace fs = std::filesystem;

    /** Results that are drawn beside those of the runs; a folder has at least one of them. */
    bool can_stand_beside(const std::string &folder)
    {
      return is_there(folder + "/coupled_modes.csv") || is_there(folder + "/resonance.csv");
    }

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
  } // namespace

  unsigned int SweepStudy::count_groups(const Communicator &communicator) const
  {
    const unsigned int all = communicator.size();
    // Whole groups only: ranks that are left over join the last one in run().
    return all / (ranks_per_run_ == 0 ? all : std::min(ranks_per_run_, all));
  }

  SweepStudy::SweepStudy(const CaseRunner &runner)
    : runner_(runner)
  {
  }

  std::size_t
  SweepStudy::resume(const std::string &, const DeclaredSection &, const Communicator &, Log &)
  {
    restart_ = true; // each run is looked at by itself
    return std::numeric_limits<std::size_t>::max();
  }

  void SweepStudy::declare_own(dealii::ParameterHandler &prm)
  {
    static const Choices<SweepRuns::Combination> combinations = {
      {"grid", SweepRuns::Combination::product}, {"list", SweepRuns::Combination::list}};
    declare_file_name(prm, "base", base_, "Parameter file of the case, relative to this file");
    declare_names(prm,
                  "parameters",
                  runs_.names,
                  "Names of varied parameters; each has a section Parameter NAME");
    declare_choice(prm,
                   "combination",
                   runs_.combination,
                   combinations,
                   "grid: all combinations of the values, the last parameter changes fastest; "
                   "list: first values of all parameters, then second values, and so on");
    declare_text(prm,
                 "entries",
                 entries_,
                 "Entries in which all runs differ from the base file: \"Section/name = value\", "
                 "separated by semicolons");
    declare_names(prm,
                  "reference folders",
                  beside_,
                  "Folders of results that the report shows together with the runs: a loaded tooth "
                  "contact analysis with coupled modes, a lumped model or a reduced pair with a "
                  "speed sweep");
    declare_names(prm,
                  "numerical parameters",
                  runs_.numerical,
                  "Numerical parameters, with values from the coarsest to the finest; they are "
                  "varied one by one, and results get error estimates from them");
    declare_integer(prm,
                    "ranks per run",
                    ranks_per_run_,
                    "Number of ranks per run, while other ranks do other runs; 0: all ranks");
    declare_names(prm,
                  "figures",
                  figure_names_,
                  "Names of further columns of the table, taken from the histories; each has a "
                  "section Figure NAME");
    declare_switch(prm, "report", pictures_, "Writes the report of all runs at the end");
  }

  void SweepStudy::declare(dealii::ParameterHandler &prm, const ParameterFile &file)
  {
    // First pass: names of parameters and figures, which have sections.
    file.read_known([this](dealii::ParameterHandler &first) {
      Subsection section(first, "Sweep");
      declare_own(first);
    });
    // Sized before anything is declared: entries are bound by address.
    runs_.parameters.resize(runs_.names.size());
    figures_.resize(figure_names_.size());
    Subsection section(prm, "Sweep");
    declare_own(prm);
    for (std::size_t i = 0; i < figures_.size(); ++i)
      {
        figures_[i].name = figure_names_[i];
        declare_section(prm, "Figure " + figure_names_[i], figures_[i]);
      }
    for (std::size_t i = 0; i < runs_.names.size(); ++i)
      {
        runs_.parameters[i].name = runs_.names[i];
        declare_section(prm, "Parameter " + runs_.names[i], runs_.parameters[i]);
      }
  }

  CommandLine SweepStudy::command_line(const SweepRuns::Values &values) const
  {
    CommandLine line;
    line.parameter_file                  = base_;
    line.overrides                       = split_entries(entries_, "Sweep/entries");
    const std::vector<std::string> swept = runs_.list_overrides(values);
    line.overrides.insert(line.overrides.end(), swept.begin(), swept.end());
    return line;
  }

  void SweepStudy::check() const
  {
    if (base_.empty())
      throw InputError("Sweep/base", "the parameter file of the case is missing");
    if (!is_there(base_))
      throw InputError("Sweep/base", "file \"" + base_ + "\" does not exist");
    runs_.check();
    tables().check();
    for (const std::string &folder : beside_)
      if (!can_stand_beside(folder))
        throw InputError("Sweep/reference folders",
                         "the folder \"" + folder +
                           "\" has neither coupled modes (coupled_modes.csv) nor a sweep of speeds "
                           "(resonance.csv)");
    // All runs are read before the first one begins: the last must not fail by a word after days.
    for (const std::string &text : split_entries(entries_, "Sweep/entries"))
      {
        const std::string entry = text.substr(0, text.find('='));
        if (const SweepParameter *parameter = runs_.find_parameter(entry))
          throw InputError("Sweep/entries",
                           "expected entries that no parameter sets, got \"" + entry +
                             "\", which Sweep/Parameter " + parameter->name +
                             " sets. Remove it from one of them.");
      }
    CaseFile file;
    for (const SweepRuns::Values &values : runs_.list())
      try
        {
          file = runner_.check(command_line(values));
        }
      catch (const InputError &error)
        {
          const std::string message = "run with " + runs_.describe(values) + ": " + error.what();
          const std::string entry   = runs_.find_cause(error.what());
          throw entry.empty() ? InputError(message) : InputError(entry, message);
        }
    runs_.check_order(file);
  }

  void SweepStudy::inspect(Communicator &communicator, Log &log)
  {
    const auto runs = runs_.list();
    for (std::size_t i = 0; i < runs.size(); ++i)
      log.line(SweepRuns::folder_of(i), ": ", runs_.describe(runs[i]));
    log.line(runs.size(), " runs, ", count_groups(communicator), " at a time");
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
    const Communicator                  &all      = folder.communicator();
    const std::vector<SweepRuns::Values> runs     = runs_.list();
    const unsigned int                   n_groups = count_groups(all);
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
            log.line(SweepRuns::folder_of(i), " begins: ", runs_.describe(runs[i]));
            folder.list_file(SweepRuns::folder_of(i) + "/");
          }
        CaseReport report;
        // In a last round that is not full some groups have nothing to do: they wait for the others
        // below.
        if (first + index < end)
          {
            CommandLine line   = command_line(runs[first + index]);
            line.output_folder = folder.file(SweepRuns::folder_of(first + index));
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
              log.line(SweepRuns::folder_of(i), " ", reports[i].describe());
            }
        tables().write(folder, reports, log);
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

  std::unique_ptr<StudyKind> make_sweep_study(const CaseRunner &runner)
  {
    return std::make_unique<SweepStudy>(runner);
  }
} // namespace vfife
