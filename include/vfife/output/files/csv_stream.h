// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_output_files_csv_stream_h
#define vfife_output_files_csv_stream_h

#include <chrono>
#include <fstream>
#include <string>

namespace vfife
{
  class OutputFolder;
  class Table;

  /**
   * A .csv file that grows line by line with a table, so that a run can be watched (it reaches the
   * disk about every second). On ranks that do not write it does nothing.
   */
  class CsvStream
  {
  public:
    /** Opens the file and writes the header of @p table; throws std::runtime_error. The folder must
     * outlive the object. */
    CsvStream(const OutputFolder &folder, const std::string &name, const Table &table);

    /** Appends those rows of @p table that are not in the file yet; throws std::runtime_error when
     * the disk is full. */
    void append_new_rows(const Table &table);

    /** Begins the file anew with the rows of @p table: those of a run that has gone back. Throws as
     * the constructor. */
    void rewrite(const Table &table);

    /** @p table has all its rows, which are in the file. Throws as append_new_rows(). */
    void finish(const Table &table);

  private:
    void open(const Table &table);
    void flush();
    /** Throws what the disk says unless it has taken everything. */
    void check() const;

    const OutputFolder                   &folder_;
    std::string                           name_, path_;
    std::ofstream                         file_;
    std::size_t                           n_written_ = 0;
    std::chrono::steady_clock::time_point flushed_;
  };
} // namespace vfife

#endif
