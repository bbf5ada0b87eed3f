// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/parameters/parameter_grid.h>
#include <vfife/base/parameters/parameter_table.h>
#include <vfife/base/text/number_text.h>
#include <vfife/base/text/shown_text.h>
#include <vfife/base/text/text_lines.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <vector>

namespace vfife
{
  namespace
  {
    /** "row 2, column 5", counted from 1. */
    std::string place_of(const std::size_t row, const std::size_t column)
    {
      return "row " + std::to_string(row + 1) + ", column " + std::to_string(column + 1);
    }

    std::vector<std::string>
    cells_of(const std::string &line, const std::string &name, const unsigned int number)
    {
      return for_place(name + ", line " + std::to_string(number), [&] { return split_row(line); });
    }

    double number_of(const std::string &cell, const std::string &name, const std::string &place)
    {
      if (cell.empty())
        throw InputError(name + ": the number at " + place + " is missing");
      const std::optional<double> number = plain_number(cell);
      if (!number)
        throw InputError(name + ": expected a number at " + place + ", got \"" + shown(cell) +
                         "\"");
      return *number;
    }

    void check_size(const std::size_t rows, const std::size_t columns, const std::string &name)
    {
      if (rows < 2 || columns < 2)
        throw InputError(name + " has " + std::to_string(rows) + " rows and " +
                         std::to_string(columns) + " columns; expected at least 2 of each");
    }

    /** Index of a row or column from its number in a table. */
    std::size_t index_of(const double number, const std::string &what, const std::string &name)
    {
      // far above any grid: a slip would else reserve all memory
      constexpr double largest = 10000.;
      if (!(number >= 1. && number <= largest) || number != std::floor(number))
        throw InputError(name + ": expected a whole number of at least 1 as " + what + ", got " +
                         number_text(number) + "");
      return static_cast<std::size_t>(number) - 1;
    }
  } // namespace

  Eigen::MatrixXd arrange_on_grid(const Table       &table,
                                  const std::string &path,
                                  const std::string &name,
                                  const std::string &unit)
  {
    const std::string         file    = "the table \"" + path + "\"";
    const std::vector<double> rows    = find_column(table, path, "row", "-");
    const std::vector<double> columns = find_column(table, path, "column", "-");
    const std::vector<double> numbers = find_column(table, path, name, unit);
    std::size_t               n_rows = 0, n_columns = 0;
    for (std::size_t i = 0; i < numbers.size(); ++i)
      {
        n_rows    = std::max(n_rows, index_of(rows[i], "row", file) + 1);
        n_columns = std::max(n_columns, index_of(columns[i], "column", file) + 1);
      }
    check_size(n_rows, n_columns, file);
    // Places may come in any order; each must come once.
    Eigen::MatrixXd grid = Eigen::MatrixXd::Constant(n_rows, n_columns, std::nan(""));
    for (std::size_t i = 0; i < numbers.size(); ++i)
      {
        const std::size_t row    = index_of(rows[i], "row", file),
                          column = index_of(columns[i], "column", file);
        if (!std::isnan(grid(row, column)))
          throw InputError(file + ": " + place_of(row, column) + " is given twice");
        grid(row, column) = numbers[i];
      }
    for (std::size_t row = 0; row < n_rows; ++row)
      for (std::size_t column = 0; column < n_columns; ++column)
        if (std::isnan(grid(row, column)))
          throw InputError(file + ": the number at " + place_of(row, column) + " is missing");
    return grid;
  }

  bool has_headings(const std::string &path)
  {
    std::ifstream stream(path);
    TextLines     lines(stream);
    std::string   line;
    lines.next(line);
    for (const std::string &cell : split_row(line))
      if (cell.substr(0, cell.find(" [")) == "row" || cell.substr(0, cell.find(" [")) == "x")
        return true;
    return false;
  }

  Eigen::MatrixXd
  read_parameter_grid(const std::string &path, const std::string &name, const std::string &unit)
  {
    const std::string file = "the grid \"" + path + "\"";
    if (has_headings(path))
      return arrange_on_grid(read_parameter_table(path), path, name, unit);
    std::ifstream stream(path);
    if (!stream)
      throw InputError(file + " cannot be read");
    std::vector<std::vector<double>> rows;
    std::vector<std::size_t>         lines; // of the file, in which each row stands
    TextLines                        text(stream);
    const auto place_in = [&lines](const std::size_t row, const std::size_t i) {
      return place_of(row, i) + " (line " + std::to_string(lines[row]) + ")";
    };
    for (std::string line; text.next(line);)
      {
        if (trimmed(line).empty() || trimmed(line)[0] == '#')
          continue;
        rows.emplace_back();
        lines.push_back(text.number());
        const std::vector<std::string> cells = cells_of(line, file, text.number());
        for (std::size_t i = 0; i < cells.size(); ++i)
          rows.back().push_back(number_of(cells[i], file, place_in(rows.size() - 1, i)));
        // A short row has a hole at its end, and so has the first one where another is longer.
        const std::size_t first = rows.front().size(), here = rows.back().size();
        if (here != first)
          throw InputError(file + ": the number at " +
                           (here < first ? place_in(rows.size() - 1, here) : place_in(0, first)) +
                           " is missing");
      }
    check_size(rows.size(), rows.empty() ? 0 : rows.front().size(), file);
    Eigen::MatrixXd grid(rows.size(), rows.front().size());
    for (std::size_t i = 0; i < rows.size(); ++i)
      for (std::size_t j = 0; j < rows[i].size(); ++j)
        grid(i, j) = rows[i][j];
    return grid;
  }
} // namespace vfife
