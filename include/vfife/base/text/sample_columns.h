// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_base_text_sample_columns_h
#define vfife_base_text_sample_columns_h

#include <vfife/base/text/table.h>

#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace vfife
{
  /**
   * Columns of a table whose rows show samples of one kind: name, unit and what a sample has in the
   * column are given together, so that header and rows cannot disagree.
   *
   *   SampleColumns<ProbeValue> columns;
   *   columns.add("von mises", "MPa", [](const ProbeValue &value) { return value.von_mises; });
   */
  template <typename Sample>
  class SampleColumns
  {
  public:
    using CellOf = std::function<Table::Cell(const Sample &)>;

    /** A column of numbers, which @p cell_of gives in @p unit. */
    void add(const std::string &name, const std::string &unit, CellOf cell_of)
    {
      columns_.push_back({name, unit, false, std::move(cell_of)});
    }

    /** A column of texts. */
    void add_text(const std::string &name, CellOf cell_of)
    {
      columns_.push_back({name, "", true, std::move(cell_of)});
    }

    /** Adds the columns to a table. */
    void add_to(Table &table) const
    {
      for (const Column &column : columns_)
        if (column.is_text)
          table.add_text_column(column.name);
        else
          table.add_column(column.name, column.unit);
    }

    /** An empty table of these columns behind one of numbers, such as times. */
    Table make_table(const std::string &first, const std::string &unit) const
    {
      Table table;
      table.add_column(first, unit);
      add_to(table);
      return table;
    }

    /** A row of that table. */
    std::vector<Table::Cell> make_row(const double first, const Sample &sample) const
    {
      std::vector<Table::Cell> row = cells_of(sample);
      row.insert(row.begin(), first);
      return row;
    }

    /** What a sample has in these columns. */
    std::vector<Table::Cell> cells_of(const Sample &sample) const
    {
      std::vector<Table::Cell> cells;
      for (const Column &column : columns_)
        cells.push_back(column.cell_of(sample));
      return cells;
    }

  private:
    struct Column
    {
      std::string name, unit;
      bool        is_text;
      CellOf      cell_of;
    };

    std::vector<Column> columns_;
  };
} // namespace vfife

#endif
