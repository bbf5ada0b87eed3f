// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/process/log.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <ostream>
#include <stdexcept>

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
    // What was said before there was a file comes first in it.
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
    // The folder of results is known only after some lines have been
    // said: they are kept for the file.
    if (file_ == nullptr)
      {
        lines_before_file_.push_back(text);
        return;
      }
    // every line is flushed: the last one before a crash is the one that is needed
    *file_ << text << std::endl;
    if (!*file_)
      {
        file_ = nullptr;
        throw std::runtime_error(std::string("cannot write run.log: ") + std::strerror(errno));
      }
  }

  void Log::add_warning(const std::string &text)
  {
    // A run of a million steps may warn at each: the first is written, all are counted.
    for (Warning &warning : warnings_)
      if (warning.text == text)
        {
          ++warning.count;
          return;
        }
    warnings_.push_back({text, 1});
    write_line("warning: " + text, Verbosity::quiet);
  }

  void Log::take_warnings(std::vector<Warning> earlier)
  {
    // The earlier ones come first, with their counts; of the present ones what they do not have.
    std::swap(warnings_, earlier);
    for (const Warning &warning : earlier)
      {
        const auto known =
          std::find_if(warnings_.begin(), warnings_.end(), [&warning](const Warning &other) {
            return other.text == warning.text;
          });
        if (known == warnings_.end())
          warnings_.push_back(warning);
      }
  }
} // namespace vfife
