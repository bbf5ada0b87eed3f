// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/text/csv_text.h>
#include <vfife/base/text/number_text.h>
#include <vfife/base/text/shown_text.h>
#include <vfife/base/text/text_lines.h>

#include <istream>
#include <set>

namespace vfife
{
  namespace
  {
    /**
     * The cells of a line. Inside quotes a comma is text, and "" is one quotation mark (RFC 4180).
     */
    std::vector<std::string> split(const std::string &line)
    {
      std::vector<std::string> cells(1);
      bool                     quoted = false;
      for (std::size_t i = 0; i < line.size(); ++i)
        if (line[i] == '"')
          {
            if (quoted && i + 1 < line.size() && line[i + 1] == '"')
              cells.back() += line[++i];
            else
              quoted = !quoted;
          }
        else if (line[i] == ',' && !quoted)
          cells.emplace_back();
        else
          cells.back() += line[i];
      for (std::string &cell : cells)
        cell = trimmed(cell);
      return cells;
    }

    /** "name [unit]", or a name alone. */
    CsvText::Heading make_heading(const std::string &text)
    {
      const std::size_t open = text.rfind(" [");
      if (open == std::string::npos || text.back() != ']')
        return {text, {}};
      return {text.substr(0, open), text.substr(open + 2, text.size() - open - 3)};
    }

    bool next_line(TextLines &lines, const std::string &name, std::string &line)
    {
      return for_place(name, [&] { return lines.next(line); });
    }
  } // namespace

  CsvText read_csv(std::istream &in, const std::string &name)
  {
    // The first line has the headings; places count from 1, as editors do.
    CsvText     text;
    TextLines   lines(in);
    std::string line;
    if (!in || !next_line(lines, name, line))
      throw InputError(name + " cannot be read");
    std::set<std::string> names;
    bool                  are_numbers = true;
    for (const std::string &heading : split(line))
      {
        text.headings.push_back(make_heading(heading));
        are_numbers = are_numbers && plain_number(heading);
        if (!names.insert(text.headings.back().name).second)
          throw InputError(name + " has two columns \"" + shown(text.headings.back().name) + "\"");
      }
    if (are_numbers)
      throw InputError(name + ", line 1: expected headings \"name [unit]\" of the columns, got "
                              "numbers. Put a line of headings before them");
    while (next_line(lines, name, line))
      {
        // An empty line at the end is no row of one empty cell.
        if (trimmed(line).empty())
          continue;
        CsvText::Row row{name + ", line " + std::to_string(lines.number()), split(line)};
        if (row.cells.size() != text.headings.size())
          throw InputError(row.place + ": expected " + std::to_string(text.headings.size()) +
                           " cells as in the header, got " + std::to_string(row.cells.size()));
        text.rows.push_back(std::move(row));
      }
    return text;
  }
} // namespace vfife
