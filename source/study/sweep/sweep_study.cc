// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/parameters/file_names.h>
#include <vfife/base/parameters/number_list.h>
#include <vfife/base/parameters/parameter_file.h>
#include <vfife/base/parameters/parameters.h>
#include <vfife/base/parameters/section_of_options.h>
#include <vfife/base/process/command_line.h>
#include <vfife/base/process/communicator.h>
#include <vfife/base/process/log.h>
#include <vfife/base/text/number_text.h>
#include <vfife/output/files/run_figures.h>
#include <vfife/study/study_kinds.h>
#include <vfife/study/sweep/sweep_study.h>

#include <deal.II/base/parameter_handler.h>

#include <algorithm>
#include <iomanip>
#include <limits>
#include <sstream>

namespace vfife
{
  namespace
  {
    /** Results that are drawn beside those of the runs; a folder has at least one of them. */
    bool can_stand_beside(const std::string &folder)
    {
      return is_there(folder + "/coupled_modes.csv") || is_there(folder + "/resonance.csv");
    }

    std::vector<std::string> split(const std::string &text, const char separator)
    {
      std::vector<std::string> list;
      std::istringstream       in(text);
      for (std::string one; std::getline(in, one, separator);)
        list.push_back(trimmed(one));
      return list;
    }
  } // namespace

  std::string SweepStudy::folder_of_run(const std::size_t i)
  {
    // Two digits at least, so that folders are listed in the order of the runs.
    std::ostringstream name;
    name << "run_" << std::setw(2) << std::setfill('0') << i + 1;
    return name.str();
  }

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

  std::vector<std::string> SweepStudy::Parameter::list_entries() const
  {
    return split(entry, ';');
  }

  void SweepStudy::Parameter::check_commas(const char *list, const std::string &text) const
  {
    try
      {
        check_list_commas(text, ListNumbers::any);
      }
    catch (const InputError &error)
      {
        throw InputError("Sweep/Parameter " + name + "/" + list, error.what());
      }
  }

  std::vector<std::string> SweepStudy::Parameter::list_values() const
  {
    // Vectors have commas of their own.
    if (values.find(';') != std::string::npos)
      return split(values, ';');
    check_commas("values", values);
    return split(values, ',');
  }

  std::vector<std::string> SweepStudy::Parameter::list_parts(const std::string &value) const
  {
    return list_entries().size() > 1 ? split(value, '|') : std::vector<std::string>{value};
  }

  std::vector<double> SweepStudy::Parameter::list_sizes() const
  {
    std::vector<double> list;
    check_commas("relative element sizes", sizes);
    for (const std::string &text : split(sizes, ','))
      list.push_back(plain_number(text).value_or(0.)); // no size, as zero
    return list;
  }

  void SweepStudy::declare_own(dealii::ParameterHandler &prm)
  {
    static const Choices<Combination> combinations = {{"grid", Combination::product},
                                                      {"list", Combination::list}};
    declare_file_name(prm, "base", base_, "Parameter file of the case, relative to this file");
    declare_names(prm,
                  "parameters",
                  names_,
                  "Names of varied parameters; each has a section Parameter NAME");
    declare_choice(prm,
                   "combination",
                   combination_,
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
                  error_by_,
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
    parameters_.resize(names_.size());
    figures_.resize(figure_names_.size());
    Subsection section(prm, "Sweep");
    declare_own(prm);
    for (std::size_t i = 0; i < figures_.size(); ++i)
      {
        figures_[i].name = figure_names_[i];
        declare_section(prm, "Figure " + figure_names_[i], figures_[i]);
      }
    for (std::size_t i = 0; i < names_.size(); ++i)
      {
        parameters_[i].name = names_[i];
        Subsection parameter(prm, "Parameter " + names_[i]);
        declare_text(
          prm,
          "entry",
          parameters_[i].entry,
          "The entry with its sections, as Gear pair/Gear/Body/web thickness; several of "
          "them separated by semicolons");
        declare_text(prm,
                     "values",
                     parameters_[i].values,
                     "Values separated by commas, or by semicolons if a value contains commas; "
                     "with several entries one value per entry, separated by |");
        declare_text(prm,
                     "relative element sizes",
                     parameters_[i].sizes,
                     "Relative element size of each value of a numerical parameter: falling "
                     "numbers separated by commas; empty: from the values, or from the numbers of "
                     "elements of the runs");
      }
  }

  CommandLine SweepStudy::command_line(const Values &values) const
  {
    CommandLine line;
    line.parameter_file = base_;
    line.overrides      = split_entries(entries_, "Sweep/entries");
    // The swept value comes last: it wins over the entries that all runs share.
    for (std::size_t i = 0; i < values.size(); ++i)
      {
        const std::vector<std::string> entries = parameters_[i].list_entries(),
                                       parts   = parameters_[i].list_parts(values[i]);
        for (std::size_t k = 0; k < entries.size(); ++k)
          line.overrides.push_back(entries[k] + "=" + parts[k]);
      }
    return line;
  }

  std::string SweepStudy::describe(const Values &values) const
  {
    std::string text;
    for (std::size_t i = 0; i < values.size(); ++i)
      text += (i > 0 ? ", " : "") + parameters_[i].name + " = " + values[i];
    return text;
  }

  void SweepStudy::check() const
  {
    if (base_.empty())
      throw InputError("Sweep/base", "the parameter file of the case is missing");
    if (!is_there(base_))
      throw InputError("Sweep/base", "file \"" + base_ + "\" does not exist");
    if (parameters_.empty())
      throw InputError("Sweep/parameters", "expected at least one parameter, got none");
    check_numerical();
    const Parameter *first = nullptr; // with which the others make a list
    for (const Parameter &parameter : parameters_)
      {
        const std::string section = "Sweep/Parameter " + parameter.name;
        const auto        values  = parameter.list_values();
        const auto        entries = parameter.list_entries();
        if (entries.empty() || std::count(entries.begin(), entries.end(), "") > 0)
          throw InputError(section + "/entry", "the entry to vary is missing");
        if (values.empty() || std::count(values.begin(), values.end(), "") > 0)
          throw InputError(section + "/values", "a value is missing");
        for (const std::string &value : values)
          if (parameter.list_parts(value).size() != entries.size())
            throw InputError(section + "/values",
                             "expected one value for each of the " +
                               std::to_string(entries.size()) + " entries, separated by |, got \"" +
                               value + "\"");
        if (is_numerical(parameter))
          continue;
        first               = first == nullptr ? &parameter : first;
        const std::size_t n = first->list_values().size();
        if (combination_ == Combination::list && values.size() != n)
          throw InputError(section + "/values",
                           "expected " + std::to_string(n) + " values as for \"" + first->name +
                             "\" (combination = list), got " + std::to_string(values.size()));
      }
    check_columns();
    for (const std::string &folder : beside_)
      if (!can_stand_beside(folder))
        throw InputError("Sweep/reference folders",
                         "the folder \"" + folder +
                           "\" has neither coupled modes (coupled_modes.csv) nor a sweep of speeds "
                           "(resonance.csv)");
    // All runs are read before the first one begins: the last must not fail by a word after days.
    split_entries(entries_, "Sweep/entries");
    for (const Values &values : list_runs())
      try
        {
          runner_.read(command_line(values));
        }
      catch (const InputError &error)
        {
          const std::string message = "run with " + describe(values) + ": " + error.what();
          const std::string entry   = find_cause(error.what());
          throw entry.empty() ? InputError(message) : InputError(entry, message);
        }
  }

  std::string SweepStudy::find_cause(const std::string &message) const
  {
    for (const Parameter &parameter : parameters_)
      for (const std::string &entry : parameter.list_entries())
        if (message.find("\"" + entry + "=") != std::string::npos)
          return "Sweep/Parameter " + parameter.name +
                 (message.find("is not a") != std::string::npos ? "/entry" : "/values");
    return "";
  }

  void SweepStudy::check_columns() const
  {
    // Names that the table has anyway: a run that does not exist has the same figures as any other.
    std::vector<std::string> taken = {"run", "status"};
    for (const auto &figure : read_run_figures("").figures)
      taken.push_back(figure.first);
    for (const std::string &name : names_)
      {
        if (std::count(taken.begin(), taken.end(), name) > 0)
          throw InputError("Sweep/parameters",
                           "rename the parameter: \"" + name +
                             "\" is already a column of sweep.csv");
        taken.push_back(name);
      }
    for (const HistoryFigure &figure : figures_)
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

  void SweepStudy::inspect(Communicator &communicator, Log &log)
  {
    const auto runs = list_runs();
    for (std::size_t i = 0; i < runs.size(); ++i)
      log.line(folder_of_run(i), ": ", describe(runs[i]));
    log.line(runs.size(), " runs, ", count_groups(communicator), " at a time");
  }

  std::unique_ptr<StudyKind> make_sweep_study(const CaseRunner &runner)
  {
    return std::make_unique<SweepStudy>(runner);
  }
} // namespace vfife
