// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/parameters/file_names.h>
#include <vfife/base/parameters/parameter_history.h>
#include <vfife/base/text/number_text.h>
#include <vfife/base/text/shown_text.h>

#include <algorithm>
#include <fstream>
#include <sstream>

namespace vfife
{
  namespace
  {
    /** Whether a word begins as numbers do, and no heading. */
    bool begins_number(const std::string &word)
    {
      return std::string("+-.0123456789").find(word[0]) != std::string::npos;
    }

    /** Time and factor of each row, times increasing. */
    std::vector<std::pair<double, double>> read_rows(const std::string &path)
    {
      std::ifstream file(path);
      if (!file)
        throw InputError("the table \"" + path + "\" cannot be read");
      std::vector<std::pair<double, double>> rows;
      unsigned int                           n_lines = 0;
      for (std::string line; std::getline(file, line);)
        {
          const std::string place =
            "the table \"" + path + "\", line " + std::to_string(++n_lines) + ": ";
          // Columns may be divided by commas, blanks or tabs.
          std::replace(line.begin(), line.end(), ',', ' ');
          std::istringstream       stream(line);
          std::vector<std::string> words;
          for (std::string word; stream >> word;)
            words.push_back(word);
          // Headings come before the numbers.
          if (words.empty() || (rows.empty() && !begins_number(words[0])))
            continue;
          if (words.size() != 2)
            throw InputError(place + "a time and a factor are needed, not " +
                             std::to_string(words.size()) + " numbers");
          std::string                     rest[2];
          const std::pair<double, double> row = {read_number(words[0], rest[0]),
                                                 read_number(words[1], rest[1])};
          if (!rest[0].empty() || !rest[1].empty())
            throw InputError(place + "\"" + shown(rest[0].empty() ? words[1] : words[0]) +
                             "\" is no number");
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
