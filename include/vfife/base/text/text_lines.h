// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_base_text_text_lines_h
#define vfife_base_text_text_lines_h

#include <cstddef>
#include <iosfwd>
#include <string>
#include <vector>

namespace vfife
{
  /**
   * The lines of a text file in turn, whatever program wrote it: lines end by LF, CR LF or CR, and
   * a byte order mark of UTF-8 in front of the first one is no part of it.
   */
  class TextLines
  {
  public:
    /** @p in must outlive the object. */
    explicit TextLines(std::istream &in);

    /**
     * Puts the next line without its end into @p line; false at the end of the file.
     * @throws InputError where the file begins with the byte order mark of UTF-16.
     */
    bool next(std::string &line);

    /** Of the line last read, counted from 1. */
    unsigned int number() const;

  private:
    std::istream &in_;
    std::string   read_;       ///< up to a line feed
    std::size_t   place_  = 0; ///< of the next line in it
    unsigned int  number_ = 0;
  };

  /**
   * The cells of a row of numbers, without blanks and quotation marks around them: divided by
   * semicolons where there are any, else by tabs, else by commas, else by blanks. Nothing for an
   * empty line.
   * @throws InputError for a decimal comma between cells that something else divides.
   */
  std::vector<std::string> split_row(const std::string &line);
} // namespace vfife

#endif
