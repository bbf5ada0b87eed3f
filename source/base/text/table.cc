// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/text/byte_stream.h>
#include <vfife/base/text/former_result_names.h>
#include <vfife/base/text/number_text.h>
#include <vfife/base/text/table.h>
#include <vfife/base/types.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <ostream>
#include <stdexcept>

namespace vfife
{
  namespace
  {
    /** In quotes where the text would break the row, quotation marks doubled. */
    std::string csv_text(const std::string &text)
    {
      if (text.find_first_of(",\"\r\n") == std::string::npos)
        return text;
      std::string quoted = "\"";
      for (const char letter : text)
        quoted += letter == '"' ? std::string("\"\"") : std::string(1, letter);
      return quoted + "\"";
    }

    /** "length [mm]"; a text column has no unit. */
    std::string header_of(const Table::Column &column)
    {
      return column.is_text ? column.name : column.name + " [" + column.unit + "]";
    }

    /** The cell; null for a number that is not finite, for which JSON has no text. */
    Json json_value(const Table::Column &column, const std::size_t row)
    {
      if (column.is_text)
        return column.texts[row];
      return std::isfinite(column.numbers[row]) ? Json(column.numbers[row]) : Json(nullptr);
    }

    Json json_row(const Table &table, const std::size_t row)
    {
      Json values = Json::array();
      for (const Table::Column &column : table.columns())
        values.push_back(json_value(column, row));
      return values;
    }

    Json json_columns(const Table &table)
    {
      Json columns = Json::array();
      for (const Table::Column &column : table.columns())
        if (column.is_text)
          columns.push_back({{"name", column.name}});
        else
          columns.push_back({{"name", column.name}, {"unit", column.unit}});
      return columns;
    }
  } // namespace

  Table::Table(const std::initializer_list<Heading> headings)
  {
    for (const Heading &heading : headings)
      add_any_column(heading.name, heading.unit, heading.unit.empty());
  }

  void Table::add_any_column(const std::string &name, const std::string &unit, const bool is_text)
  {
    if (n_rows_ > 0)
      // Logic errors: a wrong table is a mistake of the program, which no user can mend.
      throw std::logic_error("column \"" + name + "\" is added to a table that has rows already");
    for (const Column &column : columns_)
      if (column.name == name)
        throw std::logic_error("the table has a column \"" + name + "\" already");
    Column column;
    column.name    = name;
    column.unit    = unit;
    column.is_text = is_text;
    columns_.push_back(column);
  }

  void Table::add_column(const std::string &name, const std::string &unit)
  {
    add_any_column(name, unit, false);
  }

  void Table::add_text_column(const std::string &name)
  {
    add_any_column(name, "", true);
  }

  void Table::add_row(const std::vector<Cell> &cells)
  {
    // Everything is checked before anything is added: a row that is refused leaves no half behind.
    if (cells.size() != columns_.size())
      throw std::logic_error("a row of " + std::to_string(cells.size()) + " cells for a table of " +
                             std::to_string(columns_.size()) + " columns");
    for (std::size_t i = 0; i < cells.size(); ++i)
      if (cells[i].is_text != columns_[i].is_text)
        throw std::logic_error("column \"" + columns_[i].name + "\" takes " +
                               (columns_[i].is_text ? "texts" : "numbers"));
    for (std::size_t i = 0; i < cells.size(); ++i)
      if (cells[i].is_text)
        columns_[i].texts.push_back(cells[i].text);
      else
        columns_[i].numbers.push_back(cells[i].number);
    ++n_rows_;
  }

  void Table::add_row(const std::initializer_list<Cell> cells)
  {
    add_row(std::vector<Cell>(cells));
  }

  void Table::serialize_rows(ByteStream &stream)
  {
    // 1. Columns by names and units: a stored one that is not there now, or in another unit, would
    // be lost without a word.
    std::vector<std::string> stored;
    for (const Column &column : columns_)
      stored.push_back(header_of(column));
    std::vector<std::string> known = stored;
    stream.pass_required_part("columns", [&](ByteStream &part) { part.pass(stored, n_rows_); });
    // The checkpoint of a previous version has a column by its former name.
    for (std::size_t i = 0; i < columns_.size(); ++i)
      {
        const std::string &name   = columns_[i].name;
        const std::string  former = former_result_name(name) + known[i].substr(name.size());
        if (std::find(stored.begin(), stored.end(), known[i]) == stored.end() &&
            std::find(stored.begin(), stored.end(), former) != stored.end())
          known[i] = former;
      }
    for (const std::string &name : stored)
      if (std::find(known.begin(), known.end(), name) == known.end())
        throw InputError("unexpected column " + name + " in stored rows; expected " + csv_header());
    // 2. Cells. A column that is younger than the rows has none for them.
    for (std::size_t i = 0; i < columns_.size(); ++i)
      {
        Column    &column    = columns_[i];
        const bool was_there = stream.pass_part(known[i], [&](ByteStream &part) {
          part.pass(column.numbers, column.texts);
          part.require((column.is_text ? column.texts.size() : column.numbers.size()) == n_rows_,
                       "a column that is not as long as the table");
        });
        if (!was_there && column.is_text)
          column.texts.assign(n_rows_, "");
        else if (!was_there)
          column.numbers.assign(n_rows_, not_known);
      }
  }

  const Table::Column &Table::column(const std::string &name) const
  {
    for (const Column &column : columns_)
      if (column.name == name)
        return column;
    throw std::logic_error("the table has no column \"" + name + "\"");
  }

  const std::vector<double> &Table::numbers(const std::string &name) const
  {
    const Column &wanted = column(name);
    if (wanted.is_text)
      throw std::logic_error("column \"" + name + "\" has texts");
    return wanted.numbers;
  }

  std::string Table::csv_header() const
  {
    std::string header;
    for (const Column &column : columns_)
      header += (header.empty() ? "" : ",") + csv_text(header_of(column));
    return header;
  }

  std::string Table::csv_row(const std::size_t row) const
  {
    if (row >= n_rows_)
      throw std::logic_error("the table has no row " + std::to_string(row));
    std::string line;
    for (std::size_t i = 0; i < columns_.size(); ++i)
      {
        const Column &column = columns_[i];
        line += i == 0 ? "" : ",";
        line += column.is_text ? csv_text(column.texts[row]) : number_text(column.numbers[row]);
      }
    return line;
  }

  void Table::write_csv(std::ostream &out) const
  {
    out << csv_header() << '\n';
    for (std::size_t row = 0; row < n_rows_; ++row)
      out << csv_row(row) << '\n';
  }

  Json Table::json() const
  {
    Json rows = Json::array();
    for (std::size_t row = 0; row < n_rows_; ++row)
      rows.push_back(json_row(*this, row));
    return {{"columns", json_columns(*this)}, {"rows", rows}};
  }

  void Table::write_json(std::ostream &out) const
  {
    // Row by row instead of json().dump(): a line a row is readable and
    // needs no second copy in memory.
    out << "{\"columns\": " << json_columns(*this).dump() << ",\n \"rows\": [";
    for (std::size_t row = 0; row < n_rows_; ++row)
      out << (row == 0 ? "\n  " : ",\n  ") << json_row(*this, row).dump();
    out << "]}\n";
  }
} // namespace vfife
