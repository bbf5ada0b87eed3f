// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/parameters/file_names.h>
#include <vfife/base/parameters/parameter_history.h>

#include <algorithm>
#include <fstream>
#include <sstream>

namespace vfife
{
  namespace
  {
    /** Time and factor of each row, times increasing. */
    std::vector<std::pair<double, double>> read_rows(const std::string &path)
    {
      std::ifstream file(path);
      if (!file)
        throw InputError("the table \"" + path + "\" cannot be read");
      std::vector<std::pair<double, double>> rows;
      for (std::string line; std::getline(file, line);)
        {
          // Columns may be divided by commas, blanks or tabs.
          std::replace(line.begin(), line.end(), ',', ' ');
          std::istringstream        numbers(line);
          std::pair<double, double> row;
          // Headings and empty lines.
          if (!(numbers >> row.first))
            continue;
          if (!(numbers >> row.second))
            throw InputError("the table \"" + path + "\" has a line without a second number: \"" +
                             line + "\"");
          if (!rows.empty() && row.first <= rows.back().first)
            throw InputError("times in the table \"" + path + "\" must increase");
          rows.push_back(row);
        }
      if (rows.empty())
        throw InputError("the table \"" + path + "\" has no rows of two numbers");
      return rows;
    }
  } // namespace

  void ParameterHistory::declare(dealii::ParameterHandler &prm)
  {
    declare_formula_or_table(
      prm,
      "history",
      text_,
      "Factor over time: a formula of t [s], or a table file (.csv, .txt) of time [s] "
      "and factor");
  }

  void ParameterHistory::check(const std::string &section)
  {
    formula_.reset();
    rows_.clear();
    try
      {
        if (names_a_table(text_))
          rows_ = read_rows(text_);
        else
          formula_.emplace(text_);
      }
    catch (const InputError &error)
      {
        throw InputError(section + "/history", error.what());
      }
  }

  double ParameterHistory::value(const double time) const
  {
    // One of three: a formula of t, a table, or neither of them, which is the factor 1.
    if (formula_)
      return (*formula_)(Vector3::Zero(), time);
    if (rows_.empty())
      return 1.;
    // The first row at or behind this time: linear from the one before, constant outside the table.
    const auto next =
      std::lower_bound(rows_.begin(), rows_.end(), time, [](const auto &row, const double t) {
        return row.first < t;
      });
    if (next == rows_.begin())
      return rows_.front().second;
    if (next == rows_.end())
      return rows_.back().second;
    const auto  &last = *(next - 1);
    const double part = (time - last.first) / (next->first - last.first);
    return last.second + part * (next->second - last.second);
  }
} // namespace vfife
