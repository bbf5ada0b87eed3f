// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/text/csv_text.h>
#include <vfife/base/text/former_result_names.h>
#include <vfife/base/text/shown_text.h>
#include <vfife/base/types.h>
#include <vfife/output/files/table_reader.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

namespace vfife
{
  namespace
  {
    /** A cell of the row at @p place of the @p file. */
    Table::Cell make_cell(const std::string      &file,
                          const std::string      &place,
                          const CsvText::Heading &heading,
                          const std::string      &text)
    {
      if (!heading.unit)
        return present_result_name(file, text);
      // Also "nan" and "inf"; an empty cell is no number.
      if (text.empty())
        return not_known;
      char        *end   = nullptr;
      const double value = std::strtod(text.c_str(), &end);
      if (end != text.c_str() + text.size())
        throw InputError(place + ": expected a number in column \"" + shown(heading.name) +
                         "\", got \"" + shown(text) + "\"");
      return value;
    }
  } // namespace

  Table read_result_table(const std::string &path)
  {
    // Texts of the file first, then cells by the kind of their column.
    std::ifstream     file(path);
    const CsvText     text = read_csv(file, "the results \"" + path + "\"");
    const std::string name = std::filesystem::path(path).filename().string();
    Table             table;
    for (const CsvText::Heading &heading : text.headings)
      // A column with a unit has numbers, "-" for a pure number; without any it has texts.
      if (heading.unit)
        table.add_column(present_result_name(name, heading.name), *heading.unit);
      else
        table.add_text_column(present_result_name(name, heading.name));
    for (const CsvText::Row &row : text.rows)
      {
        std::vector<Table::Cell> cells;
        for (std::size_t i = 0; i < row.cells.size(); ++i)
          cells.push_back(make_cell(name, row.place, text.headings[i], row.cells[i]));
        table.add_row(cells);
      }
    return table;
  }
} // namespace vfife
