// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_base_text_table_h
#define vfife_base_text_table_h

#include <vfife/base/text/json.h>

#include <cstddef>
#include <initializer_list>
#include <iosfwd>
#include <string>
#include <type_traits>
#include <vector>

namespace vfife
{
  class ByteStream;

  /**
   * Columns with names and units, rows of numbers and texts: what producers of results hand to
   * `output`. Numbers are stored in the unit of their column, as they will stand in the file.
   */
  class Table
  {
  public:
    /** One value of a row: a number or a text. */
    struct Cell
    {
      template <typename Number, typename = std::enable_if_t<std::is_arithmetic<Number>::value>>
      Cell(const Number value)
        : number(static_cast<double>(value))
      {
      }

      Cell(const std::string &value)
        : text(value)
        , is_text(true)
      {
      }

      Cell(const char *value)
        : text(value)
        , is_text(true)
      {
      }

      double      number = 0.;
      std::string text;
      bool        is_text = false;
    };

    /** What a column is called: of numbers with their unit, of texts without. */
    struct Heading
    {
      std::string name;
      std::string unit = {};
    };

    struct Column
    {
      std::string              name;
      std::string              unit; ///< "um", "-"; empty for texts
      bool                     is_text = false;
      std::vector<double>      numbers; ///< empty for texts
      std::vector<std::string> texts;   ///< empty for numbers
    };

    Table() = default;

    /** A table of these columns, without rows. */
    Table(std::initializer_list<Heading> headings);

    /** Adds a column of numbers. Columns can be added as long as there are no rows. */
    void add_column(const std::string &name, const std::string &unit);

    /** Adds a column of texts. */
    void add_text_column(const std::string &name);

    /**
     * Adds a row with one cell for each column.
     * @throws std::logic_error if number or kinds of the cells are not those of the columns.
     */
    void add_row(const std::vector<Cell> &cells);

    void add_row(std::initializer_list<Cell> cells);

    /** For checkpoints: passes the rows. Throws InputError where stored rows have other columns. */
    void serialize_rows(ByteStream &stream);

    std::size_t n_rows() const
    {
      return n_rows_;
    }

    const std::vector<Column> &columns() const
    {
      return columns_;
    }

    /** @throws std::logic_error if there is no column of that name. */
    const Column &column(const std::string &name) const;

    /** The numbers of a column. @throws std::logic_error if there is none of that name or it has
     * texts. */
    const std::vector<double> &numbers(const std::string &name) const;

    /** "time [s],side,force [N]", without the end of line. A text column has no unit. */
    std::string csv_header() const;

    /** Row @p row without the end of line: numbers read back exactly, texts are quoted where needed
     * (RFC 4180). */
    std::string csv_row(std::size_t row) const;

    /** Header and all rows. */
    void write_csv(std::ostream &out) const;

    /** {"columns": [{"name": , "unit": }...], "rows": [[...]...]}; numbers that are not finite
     * become null. */
    Json json() const;

    /** Writes json(), a row a line. */
    void write_json(std::ostream &out) const;

  private:
    void add_any_column(const std::string &name, const std::string &unit, bool is_text);

    std::vector<Column> columns_;
    std::size_t         n_rows_ = 0;
  };
} // namespace vfife

#endif
