// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_output_files_table_reader_h
#define vfife_output_files_table_reader_h

#include <vfife/base/text/table.h>

#include <string>

namespace vfife
{
  /**
   * Reads a .csv file of results, as Table::write_csv() has written it: columns with a unit are
   * numbers (not a number where a cell is empty), the others texts. Former names of columns are
   * replaced by present ones (former_result_names.h).
   * @throws InputError where the file cannot be read, rows have other numbers of cells, or a cell
   * is no number.
   */
  Table read_result_table(const std::string &path);
} // namespace vfife

#endif
