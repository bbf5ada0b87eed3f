// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_output_files_table_writer_h
#define vfife_output_files_table_writer_h

#include <string>

namespace vfife
{
  class OutputFolder;
  class Table;

  /** Writes a table into the folder as the file @p name ("mesh.csv"). Only the writing rank does;
   * throws std::runtime_error when the disk does not take it. */
  void write_csv(const OutputFolder &folder, const std::string &name, const Table &table);

  /** Writes @p name .csv, then @p name .json. */
  void write_tables(const OutputFolder &folder, const std::string &name, const Table &table);
} // namespace vfife

#endif
