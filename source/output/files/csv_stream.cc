// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/text/table.h>
#include <vfife/output/files/csv_stream.h>
#include <vfife/output/files/output_folder.h>

#include <cerrno>
#include <cstring>
#include <stdexcept>

namespace vfife
{
  CsvStream::CsvStream(const OutputFolder &folder, const std::string &name, const Table &table)
    : folder_(folder)
    , name_(name)
    , path_(folder.file(name))
    , flushed_(std::chrono::steady_clock::now())
  {
    if (!folder.is_writer())
      return;
    folder.list_file(name);
    open(table);
  }

  void CsvStream::open(const Table &table)
  {
    file_.open(path_);
    check();
    file_ << table.csv_header() << '\n';
    flush();
  }

  void CsvStream::rewrite(const Table &table)
  {
    if (!file_.is_open())
      return;
    file_.close();
    n_written_ = 0;
    open(table);
    append_new_rows(table);
    flush();
  }

  void CsvStream::append_new_rows(const Table &table)
  {
    if (!file_.is_open())
      return;
    // Rows stay in the table, so that the file can begin anew from a checkpoint's rows.
    for (; n_written_ < table.n_rows(); ++n_written_)
      file_ << table.csv_row(n_written_) << '\n';
    // Once a second: a plot of the running file is up to date, and the disk is left alone.
    if (std::chrono::steady_clock::now() - flushed_ >= std::chrono::seconds(1))
      flush();
  }

  void CsvStream::finish(const Table &table)
  {
    if (!file_.is_open())
      return;
    flush();
    folder_.finish_table(name_, table);
  }

  void CsvStream::flush()
  {
    // A full disk shows here, not at every row.
    file_.flush();
    check();
    flushed_ = std::chrono::steady_clock::now();
  }

  void CsvStream::check() const
  {
    if (!file_)
      throw std::runtime_error("cannot write \"" + path_ + "\": " + std::strerror(errno));
  }
} // namespace vfife
