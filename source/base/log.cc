// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/log.h>

#include <ostream>

namespace vfife
{
  Log::Log(std::ostream &screen, const bool writes, const Verbosity verbosity)
    : screen_(screen)
    , writes_(writes)
    , verbosity_(verbosity)
  {
  }

  void Log::set_verbosity(const Verbosity verbosity)
  {
    verbosity_ = verbosity;
  }

  void Log::write_to(std::ostream &file)
  {
    file_ = &file;
    if (writes_)
      for (const std::string &text : lines_before_file_)
        file << text << '\n';
    file.flush();
    lines_before_file_.clear();
  }

  void Log::stop_file()
  {
    file_ = nullptr;
  }

  void Log::write_line(const std::string &text, const Verbosity level)
  {
    if (!writes_)
      return;
    if (level <= verbosity_)
      screen_ << text << std::endl;
    // every line is flushed: the last one before a crash is the one that is needed
    if (file_ != nullptr)
      *file_ << text << std::endl;
    else
      lines_before_file_.push_back(text);
  }

  void Log::add_warning(const std::string &text)
  {
    for (Warning &warning : warnings_)
      if (warning.text == text)
        {
          ++warning.count;
          return;
        }
    warnings_.push_back({text, 1});
    write_line("warning: " + text, Verbosity::quiet);
  }

  unsigned int Log::n_warnings() const
  {
    unsigned int n = 0;
    for (const Warning &warning : warnings_)
      n += warning.count;
    return n;
  }
} // namespace vfife
