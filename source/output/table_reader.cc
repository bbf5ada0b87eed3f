// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/output/table_reader.h>

#include <cstdlib>
#include <fstream>
#include <limits>

namespace vfife
{
  namespace
  {
    /** Cells of a line; quotes as in RFC 4180. */
    std::vector<std::string> split(const std::string &line)
    {
      std::vector<std::string> cells(1);
      bool                     quoted = false;
      for (std::size_t i = 0; i < line.size(); ++i)
        if (line[i] == '"')
          {
            if (quoted && i + 1 < line.size() && line[i + 1] == '"')
              cells.back() += line[++i];
            else
              quoted = !quoted;
          }
        else if (line[i] == ',' && !quoted)
          cells.emplace_back();
        else
          cells.back() += line[i];
      return cells;
    }

    Table::Cell make_cell(const std::string &text, const bool is_text)
    {
      if (is_text)
        return text;
      char        *end   = nullptr;
      const double value = std::strtod(text.c_str(), &end);
      return end == text.c_str() ? std::numeric_limits<double>::quiet_NaN() : value;
    }
  } // namespace

  Table read_result_table(const std::string &path)
  {
    std::ifstream file(path);
    std::string   line;
    if (!file || !std::getline(file, line))
      throw InputError("the results \"" + path + "\" cannot be read");
    Table table;
    for (const std::string &header : split(line))
      {
        const std::size_t unit = header.rfind(" [");
        if (unit == std::string::npos)
          table.add_text_column(header);
        else
          table.add_column(header.substr(0, unit),
                           header.substr(unit + 2, header.size() - unit - 3));
      }
    const std::vector<Table::Column> &columns = table.columns();
    while (std::getline(file, line))
      {
        const std::vector<std::string> cells = split(line);
        if (cells.size() != columns.size())
          throw InputError("the results \"" + path + "\" have a row of " +
                           std::to_string(cells.size()) + " cells under " +
                           std::to_string(columns.size()) + " columns: was a run cut off?");
        std::vector<Table::Cell> row;
        for (std::size_t i = 0; i < cells.size(); ++i)
          row.push_back(make_cell(cells[i], columns[i].is_text));
        table.add_row(row);
      }
    return table;
  }
} // namespace vfife
