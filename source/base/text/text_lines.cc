// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/text/number_text.h>
#include <vfife/base/text/shown_text.h>
#include <vfife/base/text/text_lines.h>

#include <algorithm>
#include <istream>
#include <sstream>

namespace vfife
{
  namespace
  {
    void remove_byte_order_mark(std::string &text)
    {
      if (text.compare(0, 3, "\xEF\xBB\xBF") == 0)
        text.erase(0, 3);
      if (text.compare(0, 2, "\xFF\xFE") == 0 || text.compare(0, 2, "\xFE\xFF") == 0)
        throw InputError("the file is in UTF-16; save it in UTF-8");
    }

    /** What divides the cells of a row. */
    char divider_of(const std::string &line)
    {
      bool quoted = false, semicolon = false, tab = false, comma = false;
      for (const char letter : line)
        {
          quoted    = quoted != (letter == '"');
          semicolon = semicolon || (!quoted && letter == ';');
          tab       = tab || (!quoted && letter == '\t');
          comma     = comma || (!quoted && letter == ',');
        }
      return semicolon ? ';' : tab ? '\t' : comma ? ',' : ' ';
    }

    /** Without blanks, then without a pair of quotation marks. */
    std::string bare(const std::string &cell)
    {
      const std::string text = trimmed(cell);
      if (text.size() >= 2 && text.front() == '"' && text.back() == '"')
        return trimmed(text.substr(1, text.size() - 2));
      return text;
    }
  } // namespace

  TextLines::TextLines(std::istream &in)
    : in_(in)
  {
  }

  bool TextLines::next(std::string &line)
  {
    if (place_ >= read_.size())
      {
        place_ = 0;
        if (!std::getline(in_, read_))
          {
            // At the end of a file without a line feed it leaves the text as it is.
            read_.clear();
            return false;
          }
        if (number_ == 0)
          remove_byte_order_mark(read_);
        if (!read_.empty() && read_.back() == '\r')
          read_.pop_back();
      }
    // A carriage return within ends a line as well.
    const std::size_t end = std::min(read_.find('\r', place_), read_.size());
    line                  = read_.substr(place_, end - place_);
    place_                = end + 1;
    ++number_;
    return true;
  }

  unsigned int TextLines::number() const
  {
    return number_;
  }

  std::vector<std::string> split_row(const std::string &line)
  {
    const std::string text = trimmed(line);
    if (text.empty())
      return {};
    const char               divider = divider_of(text);
    std::vector<std::string> cells;
    if (divider == ' ')
      {
        std::istringstream stream(text);
        for (std::string word; stream >> word;)
          cells.push_back(bare(word));
        return cells;
      }
    cells.emplace_back();
    bool quoted = false;
    for (const char letter : text)
      {
        quoted = quoted != (letter == '"');
        if (letter == divider && !quoted)
          cells.emplace_back();
        else
          cells.back() += letter;
      }
    for (std::string &cell : cells)
      {
        cell = bare(cell);
        // "0,\t1": the comma divides too, and nothing stands between it and the tab.
        if (divider == '\t' && !cell.empty() && cell.back() == ',')
          cell = trimmed(cell.substr(0, cell.size() - 1));
        if (cell.find(',') != std::string::npos && plain_number(cell.substr(0, cell.find(','))))
          throw InputError("\"" + shown(cell) + "\": the decimal sign is a point, not a comma");
      }
    return cells;
  }
} // namespace vfife
