// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_base_parameters_parameter_table_h
#define vfife_base_parameters_parameter_table_h

#include <vfife/base/text/table.h>

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace vfife
{
  /**
   * Reads a table of numbers that a user names in a parameter file: a header line "name [unit],..."
   * and rows separated by commas, as Table::write_csv() writes them. Columns without a unit in the
   * header get "-".
   * @throws InputError where the file cannot be read or a cell is no number, naming file and line.
   */
  Table read_parameter_table(const std::string &path);

  /** The numbers of a column in @p unit, of which its heading may state another one; a heading
   * without a unit means it. Throws InputError, naming file and column, where there is no such
   * column or its unit is of another dimension. */
  std::vector<double> find_column(const Table       &table,
                                  const std::string &path,
                                  std::string_view   name,
                                  const std::string &unit);

  /**
   * Time [s] and value [internal units] of the rows of a table of two columns, times increasing.
   * Numbers are in seconds and @p unit, or in the units that lines of headings in front of the rows
   * state, as "time [ms],speed [rpm]". Columns are divided as split_row() does; lines that begin
   * with # are comments.
   * @throws InputError naming file and line for a row that is not two numbers.
   */
  std::vector<std::pair<double, double>> read_time_table(const std::string &path,
                                                         const std::string &unit);
} // namespace vfife

#endif
