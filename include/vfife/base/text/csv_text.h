// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_base_text_csv_text_h
#define vfife_base_text_csv_text_h

#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

namespace vfife
{
  /** A table of separated values as it stands in its file: headings and cells are texts. */
  struct CsvText
  {
    struct Heading
    {
      std::string                name;
      std::optional<std::string> unit; ///< of "name [unit]"
    };

    struct Row
    {
      std::string              place; ///< the file and its line, for messages
      std::vector<std::string> cells; ///< as many as headings, without blanks around them
    };

    std::vector<Heading> headings;
    std::vector<Row>     rows;
  };

  /**
   * Reads a header line "name [unit],..." and rows separated by commas, with quotes as in RFC 4180
   * but no line breaks in cells; empty lines are passed over, lines end as TextLines reads them.
   * @param name what messages call the file, as: the table "forces.csv"
   * @throws InputError where there is no header, two columns have one name or a row has another
   * number of cells, naming the line.
   */
  CsvText read_csv(std::istream &in, const std::string &name);
} // namespace vfife

#endif
