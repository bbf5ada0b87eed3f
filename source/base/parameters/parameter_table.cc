// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/parameters/file_names.h>
#include <vfife/base/parameters/parameter_table.h>
#include <vfife/base/text/csv_text.h>
#include <vfife/base/text/nearest_name.h>
#include <vfife/base/text/number_text.h>
#include <vfife/base/text/quantity.h>
#include <vfife/base/text/shown_text.h>
#include <vfife/base/text/text_lines.h>

#include <algorithm>
#include <array>
#include <fstream>

namespace vfife
{
  namespace
  {
    /** The unit of positions in tables of the previous version. */
    constexpr char former_mesh_cycles[] = "tooth meshes";

    /** The numbers of a column, whose heading may state another unit. */
    std::vector<double>
    in_unit_of_reader(const Table::Column &column, const std::string &path, const std::string &unit)
    {
      std::vector<double> numbers = column.numbers;
      if (column.unit == "-" || column.unit == unit ||
          (unit == "mesh cycles" && column.unit == former_mesh_cycles))
        return numbers;
      for_place("the table \"" + path + "\", column \"" + column.name + "\"", [&] {
        // Some columns have units that no entry has ("mesh cycles").
        const double factor = in_unit(parse_quantity("1 " + column.unit, unit), unit);
        for (double &number : numbers)
          number *= factor;
      });
      return numbers;
    }

    /** Whether a word begins as numbers do, and no heading. */
    bool begins_number(const std::string &word)
    {
      const std::size_t first = word.find_first_not_of("+-.");
      return first != std::string::npos && word[first] >= '0' && word[first] <= '9';
    }

    bool is_unit(const std::string &text)
    {
      try
        {
          find_unit(text);
          return true;
        }
      catch (const InputError &)
        {
          return false;
        }
    }

    /** Internal units of a time and a value, as a row without units means them and as headings
     * state them. */
    using Factors = std::array<double, 2>;

    /** "[ms]" or "(ms)" at the end of a heading; empty where there is none. What stands in round
     * brackets counts where it is a unit. */
    std::string unit_in(const std::string &heading)
    {
      const std::size_t open = heading.find('['), close = heading.find(']');
      if (open < close && close != std::string::npos)
        return heading.substr(open + 1, close - open - 1);
      const std::size_t round = heading.rfind('(');
      if (round == std::string::npos || heading.back() != ')')
        return "";
      const std::string word = trimmed(heading.substr(round + 1, heading.size() - round - 2));
      return is_unit(word) ? word : "";
    }

    /** The headings of a line, and "time [s] speed [rpm]" as two. */
    std::vector<std::string> split_headings(const std::string &line)
    {
      if (line.find_first_of(",;\t") != std::string::npos)
        return split_row(line);
      std::vector<std::string> cells;
      for (const std::string &word : split_row(line))
        if (!cells.empty() && (word[0] == '[' || word[0] == '('))
          cells.back() += " " + word;
        else
          cells.push_back(word);
      return cells;
    }

    /** Changes the factors of the columns whose units a line of headings states. */
    void read_headings(const std::string &line, const std::string &unit, Factors &factors)
    {
      const std::vector<std::string> headings = split_headings(line);
      // "ms, kN" under the names: units alone, the first one of a time.
      const bool are_units = headings.size() == 2 && is_unit(headings[0]) && is_unit(headings[1]) &&
                             find_unit(headings[0]).dimension == find_unit("s").dimension;
      for (std::size_t i = 0; i < headings.size(); ++i)
        {
          const std::string stated = are_units ? headings[i] : unit_in(headings[i]);
          if (!stated.empty())
            factors[i == 0 ? 0 : 1] = parse_quantity("1 " + stated, i == 0 ? "s" : unit);
        }
    }

    /** A time and a value, times the factors. */
    std::pair<double, double> read_row(std::vector<std::string> cells, const Factors &factors)
    {
      // Spreadsheets write empty columns behind the last one.
      while (cells.size() > 2 && cells.back().empty())
        cells.pop_back();
      if (cells.size() != 2)
        throw InputError("expected a time and a factor, got " + std::to_string(cells.size()) +
                         " numbers");
      std::array<double, 2> numbers;
      for (unsigned int i = 0; i < 2; ++i)
        {
          std::string rest;
          numbers[i] = factors[i] * read_number(cells[i], rest);
          if (!rest.empty())
            throw InputError("expected a number, got \"" + shown(cells[i]) + "\"");
        }
      return {numbers[0], numbers[1]};
    }

    /** Time [s] and value [internal units] of each row, times increasing. Headings come before the
     * numbers; lines that begin with # are comments, which may state units as headings do. */
    std::vector<std::pair<double, double>> read_lines(TextLines &lines, const std::string &unit)
    {
      std::vector<std::pair<double, double>> rows;
      Factors                                factors = {{1., parse_quantity("1", unit)}};
      for (std::string line; lines.next(line);)
        {
          line                  = trimmed(line);
          const bool is_comment = !line.empty() && line[0] == '#';
          if (line.empty() || (is_comment && !rows.empty()))
            continue;
          if (is_comment)
            {
              read_headings(line.substr(1), unit, factors);
              continue;
            }
          const std::vector<std::string> cells = split_row(line);
          const bool has_number = std::any_of(cells.begin(), cells.end(), [](const auto &cell) {
            return !!plain_number(cell);
          });
          if (rows.empty() && !has_number && !begins_number(cells[0]))
            {
              read_headings(line, unit, factors);
              continue;
            }
          const std::pair<double, double> row = read_row(cells, factors);
          if (!rows.empty() && row.first <= rows.back().first)
            throw InputError("times must increase");
          rows.push_back(row);
        }
      return rows;
    }
  } // namespace

  Table read_parameter_table(const std::string &path)
  {
    // Strict, since a user has written it: a cell that is no number is named with its line. Results
    // of runs, which may have NaN, are read by read_result_table().
    const std::string name = "the table \"" + path + "\"";
    std::ifstream     file(path);
    const CsvText     text = read_csv(file, name);
    Table             table;
    for (const CsvText::Heading &heading : text.headings)
      table.add_column(heading.name, heading.unit.value_or("-"));
    for (const CsvText::Row &row : text.rows)
      {
        std::vector<Table::Cell> cells;
        for (const std::string &cell : row.cells)
          {
            std::string rest;
            cells.emplace_back(read_number(cell, rest));
            if (!rest.empty())
              throw InputError(row.place + ": expected a number, got \"" + cell + "\"");
          }
        table.add_row(cells);
      }
    if (table.n_rows() == 0)
      throw InputError(name + " has no rows");
    return table;
  }

  std::vector<double> find_column(const Table           &table,
                                  const std::string     &path,
                                  const std::string_view name,
                                  const std::string     &unit)
  {
    std::vector<std::string> names;
    for (const Table::Column &column : table.columns())
      {
        if (column.name == name)
          return in_unit_of_reader(column, path, unit);
        names.push_back(column.name);
      }
    throw InputError("the table \"" + path + "\" has no column \"" + std::string(name) +
                     "\"; it has: " + list_of(names));
  }

  std::vector<std::pair<double, double>> read_time_table(const std::string &path,
                                                         const std::string &unit)
  {
    const std::string name = "the table \"" + path + "\"";
    std::ifstream     file(path);
    if (!file)
      throw InputError(name + " cannot be read" + (is_there(path) ? "" : ": it does not exist"));
    TextLines                              lines(file);
    std::vector<std::pair<double, double>> rows;
    try
      {
        rows = read_lines(lines, unit);
      }
    catch (const InputError &error)
      {
        throw InputError(name + ", line " + std::to_string(lines.number()) + ": " + error.what());
      }
    if (rows.empty())
      throw InputError(name + " has no rows of two numbers");
    return rows;
  }
} // namespace vfife
