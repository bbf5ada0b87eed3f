// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/nearest_name.h>
#include <vfife/base/number_text.h>
#include <vfife/base/parameter_table.h>

#include <fstream>
#include <sstream>

namespace vfife
{
  namespace
  {
    std::vector<std::string> split(const std::string &line)
    {
      std::vector<std::string> cells;
      std::istringstream       text(line);
      for (std::string cell; std::getline(text, cell, ',');)
        cells.push_back(trimmed(cell));
      return cells;
    }

    void add_column(const std::string &header, Table &table)
    {
      const std::size_t open = header.rfind(" [");
      if (open == std::string::npos || header.back() != ']')
        table.add_column(header, "-");
      else
        table.add_column(header.substr(0, open), header.substr(open + 2, header.size() - open - 3));
    }
  } // namespace

  Table read_parameter_table(const std::string &path)
  {
    std::ifstream file(path);
    std::string   line;
    if (!file || !std::getline(file, line))
      throw InputError("the table \"" + path + "\" cannot be read");
    Table table;
    for (const std::string &header : split(line))
      add_column(header, table);
    for (unsigned int number = 2; std::getline(file, line); ++number)
      {
        if (trimmed(line).empty())
          continue;
        const std::string place = "the table \"" + path + "\", line " + std::to_string(number);
        std::vector<Table::Cell> row;
        for (const std::string &cell : split(line))
          {
            std::string rest;
            row.emplace_back(read_number(cell, rest));
            if (!rest.empty())
              throw InputError(place + ": \"" + cell + "\" is no number");
          }
        if (row.size() != table.columns().size())
          throw InputError(place + " has " + std::to_string(row.size()) +
                           " cells; the header has " + std::to_string(table.columns().size()));
        table.add_row(row);
      }
    if (table.n_rows() == 0)
      throw InputError("the table \"" + path + "\" has no rows");
    return table;
  }

  const std::vector<double> &
  find_column(const Table &table, const std::string &path, const std::string &name)
  {
    std::vector<std::string> names;
    for (const Table::Column &column : table.columns())
      {
        if (column.name == name)
          return column.numbers;
        names.push_back(column.name);
      }
    throw InputError("the table \"" + path + "\" has no column \"" + name +
                     "\"; it has: " + list_of(names));
  }
} // namespace vfife
