// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/parameters/parameter_table.h>
#include <vfife/base/text/csv_text.h>
#include <vfife/base/text/nearest_name.h>
#include <vfife/base/text/number_text.h>
#include <vfife/base/text/quantity.h>

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
      try
        {
          // Some columns have units that no entry has ("mesh cycles").
          const double factor = in_unit(parse_quantity("1 " + column.unit, unit), unit);
          for (double &number : numbers)
            number *= factor;
        }
      catch (const InputError &error)
        {
          throw InputError("the table \"" + path + "\", column \"" + column.name +
                           "\": " + error.what());
        }
      return numbers;
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
} // namespace vfife
