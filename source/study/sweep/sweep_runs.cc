// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/parameters/number_list.h>
#include <vfife/base/parameters/parameters.h>
#include <vfife/base/text/nearest_name.h>
#include <vfife/base/text/number_text.h>
#include <vfife/output/files/result_places.h>
#include <vfife/output/files/run_figures.h>
#include <vfife/study/case_runner.h>
#include <vfife/study/sweep/refinement.h>
#include <vfife/study/sweep/sweep_runs.h>

#include <algorithm>
#include <iomanip>
#include <sstream>

namespace vfife
{
  namespace
  {
    std::vector<std::string> split(const std::string &text, const char separator)
    {
      std::vector<std::string> list;
      std::istringstream       in(text);
      for (std::string one; std::getline(in, one, separator);)
        list.push_back(trimmed(one));
      return list;
    }

    /** Whether finer values of an entry are larger, 1, or smaller, -1; 0 where that is not known.
     */
    int find_finer(const std::string &entry, const CaseFile &file)
    {
      for (const std::string ending : {"element size", "time step factor"})
        if (entry.size() > ending.size() &&
            entry.compare(entry.size() - ending.size(), ending.size(), ending) == 0)
          return -1;
      return file.is_count(entry) ? 1 : 0;
    }

    /** Whether two values of an entry are the same, however they are written. */
    bool are_equal(const std::string &a, const std::string &b)
    {
      return a == b || compute_log_ratio(a, b) == 0;
    }
  } // namespace

  void SweepParameter::declare(dealii::ParameterHandler &prm)
  {
    declare_text(prm,
                 "entry",
                 entry,
                 "The entry with its sections, as Gear pair/Gear/Body/web thickness; several of "
                 "them separated by semicolons");
    declare_text(prm,
                 "values",
                 values,
                 "Values separated by commas, or by semicolons if a value contains commas; "
                 "with several entries one value per entry, separated by |");
    declare_text(prm,
                 "relative element sizes",
                 sizes,
                 "Relative element size of each value of a numerical parameter: falling "
                 "numbers separated by commas; empty: from the values, or from the numbers of "
                 "elements of the runs");
  }

  std::vector<std::string> SweepParameter::list_entries() const
  {
    return split(entry, ';');
  }

  void SweepParameter::check_commas(const char *list, const std::string &text) const
  {
    for_entry("Sweep/Parameter " + name + "/" + list,
              [&] { check_list_commas(text, ListNumbers::any); });
  }

  std::vector<std::string> SweepParameter::list_values() const
  {
    // Vectors have commas of their own.
    if (values.find(';') != std::string::npos)
      return split(values, ';');
    check_commas("values", values);
    return split(values, ',');
  }

  std::vector<std::string> SweepParameter::list_parts(const std::string &value) const
  {
    return list_entries().size() > 1 ? split(value, '|') : std::vector<std::string>{value};
  }

  std::vector<double> SweepParameter::list_sizes() const
  {
    std::vector<double> list;
    check_commas("relative element sizes", sizes);
    for (const std::string &text : split(sizes, ','))
      list.push_back(plain_number(text).value_or(0.)); // no size, as zero
    return list;
  }

  bool SweepRuns::is_numerical(const SweepParameter &parameter) const
  {
    return std::count(numerical.begin(), numerical.end(), parameter.name) > 0;
  }

  void SweepRuns::check_numerical() const
  {
    for (const std::string &name : numerical)
      if (std::count(names.begin(), names.end(), name) == 0)
        throw InputError("Sweep/numerical parameters",
                         "\"" + name + "\" is not one of the parameters (" + list_of(names) + ")" +
                           did_you_mean(name, names));
    for (const SweepParameter &parameter : parameters)
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

  void SweepRuns::check() const
  {
    if (parameters.empty())
      throw InputError("Sweep/parameters", "expected at least one parameter, got none");
    check_numerical();
    const SweepParameter *first = nullptr; // with which the others make a list
    for (const SweepParameter &parameter : parameters)
      {
        const std::string section = "Sweep/Parameter " + parameter.name;
        const auto        values  = parameter.list_values();
        const auto        entries = parameter.list_entries();
        if (entries.empty() || std::count(entries.begin(), entries.end(), "") > 0)
          throw InputError(section + "/entry", "the entry to vary is missing");
        if (values.empty() || std::count(values.begin(), values.end(), "") > 0)
          throw InputError(section + "/values", "a value is missing");
        for (const std::string &entry : entries)
          if (const SweepParameter *other = find_parameter(entry); other != &parameter)
            throw InputError(section + "/entry",
                             "expected an entry that no other parameter sets, got \"" + entry +
                               "\", which Sweep/Parameter " + other->name +
                               " sets. Remove it from one of them.");
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
        if (combination == Combination::list && values.size() != n)
          throw InputError(section + "/values",
                           "expected " + std::to_string(n) + " values as for \"" + first->name +
                             "\" (combination = list), got " + std::to_string(values.size()));
      }
    check_repetition();
  }

  void SweepRuns::check_repetition() const
  {
    const std::vector<Values> runs = list();
    for (std::size_t i = 0; i < runs.size(); ++i)
      for (std::size_t j = 0; j < i; ++j)
        if (std::equal(runs[i].begin(), runs[i].end(), runs[j].begin(), are_equal))
          throw InputError("Sweep/parameters",
                           "expected different runs, got " + folder_of(j) + " and " + folder_of(i) +
                             " both with " + describe(runs[i]) + ". Remove one of the values.");
  }

  void SweepRuns::check_order(const CaseFile &file) const
  {
    for (const SweepParameter &parameter : parameters)
      {
        if (!is_numerical(parameter))
          continue;
        const std::vector<std::string> entries = parameter.list_entries(),
                                       values  = parameter.list_values();
        for (std::size_t k = 1; k < values.size(); ++k)
          {
            const std::vector<std::string> before = parameter.list_parts(values[k - 1]),
                                           now    = parameter.list_parts(values[k]);
            for (std::size_t i = 0; i < entries.size(); ++i)
              if (find_finer(entries[i], file) * compute_log_ratio(now[i], before[i]) < 0)
                throw InputError("Sweep/Parameter " + parameter.name + "/values",
                                 "expected values from coarse to fine, got \"" + values[k - 1] +
                                   "\" before \"" + values[k] +
                                   "\". Sort the values, the finest at the end.");
          }
      }
  }

  const SweepParameter *SweepRuns::find_parameter(const std::string &entry) const
  {
    for (const SweepParameter &parameter : parameters)
      {
        const std::vector<std::string> entries = parameter.list_entries();
        if (std::count(entries.begin(), entries.end(), entry) > 0)
          return &parameter;
      }
    return nullptr;
  }

  std::vector<SweepRuns::Values> SweepRuns::list_combinations() const
  {
    // A product begins with one run; each parameter multiplies the runs so far by its values, so
    // the last one changes fastest. A list is as long as the values of its parameters.
    Values values;
    for (const SweepParameter &parameter : parameters)
      values.push_back(parameter.list_values().back());
    std::vector<Values> runs(1, values);
    for (std::size_t p = 0; p < parameters.size(); ++p)
      {
        if (is_numerical(parameters[p]))
          continue;
        const std::vector<std::string> own = parameters[p].list_values();
        if (combination == Combination::list)
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

  std::vector<SweepRuns::Values> SweepRuns::list() const
  {
    std::vector<Values> runs;
    for (const Values &physical : list_combinations())
      {
        for (std::size_t p = 0; p < parameters.size(); ++p)
          if (is_numerical(parameters[p]))
            {
              std::vector<std::string> values = parameters[p].list_values();
              values.pop_back(); // that of the combination itself
              for (const std::string &value : values)
                {
                  runs.push_back(physical);
                  runs.back()[p] = value;
                }
            }
        runs.push_back(physical);
      }
    return runs;
  }

  std::vector<SweepVariant> SweepRuns::list_variants(const std::vector<std::string> &folders) const
  {
    std::vector<SweepVariant> variants;
    std::size_t               next = 0; // in the order of list()
    for (const Values &physical : list_combinations())
      {
        SweepVariant variant;
        for (std::size_t p = 0; p < parameters.size(); ++p)
          {
            const SweepParameter &parameter = parameters[p];
            if (!is_numerical(parameter))
              {
                variant.name +=
                  (variant.name.empty() ? "" : ", ") + parameter.name + " = " + physical[p];
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

  std::string SweepRuns::describe(const Values &values) const
  {
    std::string text;
    for (std::size_t i = 0; i < values.size(); ++i)
      text += (i > 0 ? ", " : "") + parameters[i].name + " = " + values[i];
    return text;
  }

  std::vector<std::string> SweepRuns::list_overrides(const Values &values) const
  {
    std::vector<std::string> overrides;
    for (std::size_t i = 0; i < values.size(); ++i)
      {
        const std::vector<std::string> entries = parameters[i].list_entries(),
                                       parts   = parameters[i].list_parts(values[i]);
        for (std::size_t k = 0; k < entries.size(); ++k)
          overrides.push_back(entries[k] + "=" + parts[k]);
      }
    return overrides;
  }

  std::string SweepRuns::find_cause(const std::string &message) const
  {
    for (const SweepParameter &parameter : parameters)
      for (const std::string &entry : parameter.list_entries())
        if (message.find("\"" + entry + "=") != std::string::npos)
          return "Sweep/Parameter " + parameter.name +
                 (message.find("is not a") != std::string::npos ? "/entry" : "/values");
    return "";
  }

  std::string SweepRuns::folder_of(const std::size_t i)
  {
    // Two digits at least, so that folders are listed in the order of the runs.
    std::ostringstream name;
    name << "run_" << std::setw(2) << std::setfill('0') << i + 1;
    return name.str();
  }
} // namespace vfife
