// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_base_parameters_parameter_time_table_h
#define vfife_base_parameters_parameter_time_table_h

#include <string>
#include <utility>
#include <vector>

namespace vfife
{
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
