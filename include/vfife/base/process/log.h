// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_base_process_log_h
#define vfife_base_process_log_h

#include <vfife/base/text/figure_text.h>

#include <iosfwd>
#include <string>
#include <vector>

namespace vfife
{
  /** How much the screen shows: warnings only, the course of the run, or details as well. */
  enum class Verbosity
  {
    quiet,
    normal,
    detailed
  };

  /**
   * What the program says: lines to the screen and, from write_to() on (what was said before
   * included), to the file run.log. Only the rank that is told to writes. The file gets the normal
   * lines even of a quiet run.
   */
  class Log
  {
  public:
    static constexpr int n_digits = 4;

    /** A warning and how often it was given. */
    struct Warning
    {
      std::string  text;
      unsigned int count;
    };

    /** @p screen must outlive the log. With @p writes false (ranks above 0) nothing is written,
     * warnings are kept. */
    Log(std::ostream &screen, bool writes, Verbosity verbosity = Verbosity::normal);

    void set_verbosity(Verbosity verbosity);

    Verbosity verbosity() const
    {
      return verbosity_;
    }

    /** Writes also to @p file from now on, beginning with all lines so far. It must outlive the log
     * or stop_file(). */
    void write_to(std::ostream &file);

    /** Stops writing to the file. */
    void stop_file();

    /** Says a line made of all arguments, as they would be written to a stream; numbers have
     * n_digits significant digits. */
    template <typename... Parts>
    void line(const Parts &...parts)
    {
      write_line(sentence_of(n_digits, parts...), Verbosity::normal);
    }

    /** Says a line that matters to developers only. */
    template <typename... Parts>
    void detail(const Parts &...parts)
    {
      if (verbosity_ == Verbosity::detailed)
        write_line(sentence_of(n_digits, parts...), Verbosity::detailed);
    }

    /** Warns: counted and kept for the summary; the same text is written once only. */
    template <typename... Parts>
    void warning(const Parts &...parts)
    {
      add_warning(sentence_of(n_digits, parts...));
    }

    const std::vector<Warning> &warnings() const
    {
      return warnings_;
    }

    /** Takes over what was warned of in an earlier part of the run, before its own. */
    void take_warnings(std::vector<Warning> earlier);

  private:
    void write_line(const std::string &text, Verbosity level);
    void add_warning(const std::string &text);

    std::ostream            &screen_;
    std::ostream            *file_ = nullptr;
    bool                     writes_;
    Verbosity                verbosity_;
    std::vector<std::string> lines_before_file_;
    std::vector<Warning>     warnings_;
  };
} // namespace vfife

#endif
