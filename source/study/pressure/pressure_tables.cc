// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/text/column_names.h>
#include <vfife/model/model.h>
#include <vfife/output/files/result_places.h>
#include <vfife/study/pressure/pressure_tables.h>

#include <algorithm>
#include <cmath>

namespace vfife
{
  namespace
  {
    void add_position_columns(const PressureRows rows, Table &table)
    {
      if (rows == PressureRows::instants)
        table.add_column(column::time, "s");
      table.add_column(column::position, "mesh cycles");
      table.add_column(column::tooth_of("pinion"), "-");
      table.add_column(column::tooth_of("gear"), "-");
    }

    /** Where something is on the flank of a member. */
    void add_place_columns(const std::string &body, Table &table)
    {
      table.add_column("along the face, " + body, "mm");
      table.add_column("along the profile, " + body, "mm");
    }

    /** The largest pressure of cells that are farther than the contact's width from all that carry
     * at an edge; 0: there is none. */
    double find_largest_inside(const GridPressure &grid)
    {
      double largest = 0;
      for (std::size_t i = 0; i < grid.cells.size(); ++i)
        {
          bool inside = true;
          for (std::size_t k = 0; inside && k < grid.cells.size(); ++k)
            inside = !grid.at_edge[k] ||
                     (grid.cells[i].position - grid.cells[k].position).norm() > grid.width;
          if (inside)
            largest = std::max(largest, grid.pressures[i]);
        }
      return largest;
    }
  } // namespace

  Vector2 place_on_flank(const BlankOutline &blank, const Vector2 &r_z)
  {
    // Along and across the pitch cone from the apex, at which the axial section of a body has its
    // origin.
    const double sine = std::sin(blank.pitch_angle), cosine = std::cos(blank.pitch_angle);
    return Vector2(r_z[1] * cosine + r_z[0] * sine - blank.mean_cone_distance,
                   r_z[0] * cosine - r_z[1] * sine);
  }

  Table make_pressure_table(const PressureRows rows)
  {
    Table table;
    add_position_columns(rows, table);
    table.add_column(column::after_mean_contact, "mesh cycles");
    table.add_column(column::force, "N");
    table.add_column(column::torque, "N m");
    table.add_column("share of torque", "-");
    table.add_column(column::largest_pressure, "MPa");
    table.add_column(column::largest_pressure_inside, "MPa");
    table.add_column("on edge", "-");
    table.add_column(column::area, "mm^2");
    table.add_column("contact width", "mm");
    table.add_column("contact length", "mm");
    add_place_columns("pinion", table);
    add_place_columns("gear", table);
    table.add_column(column::transmission_error, "arcsec");
    return table;
  }

  Table make_pressure_field_table(const PressureRows rows)
  {
    Table table;
    add_position_columns(rows, table);
    add_place_columns("pinion", table);
    add_place_columns("gear", table);
    table.add_column("pressure", "MPa");
    return table;
  }

  PressureTables::PressureTables(const Model        &model,
                                 const PairOutlines &outlines,
                                 const PressureRows  rows)
    : model_(model)
    , outlines_(outlines)
    , rows_(rows)
    , teeth_(make_pressure_table(rows))
    , cells_(make_pressure_field_table(rows))
  {
  }

  void PressureTables::add(const Position &position, const std::vector<ToothPressure> &teeth)
  {
    double torque = 0;
    for (const ToothPressure &tooth : teeth)
      torque += tooth.grid.moment;
    for (const ToothPressure &tooth : teeth)
      add_tooth(position, torque, tooth);
  }

  void PressureTables::add_tooth(const Position      &position,
                                 const double         torque,
                                 const ToothPressure &tooth)
  {
    // Body 0 is the pinion, whichever of both the slave is.
    const bool          slave_is_pinion = model_.contacts.front().slave_body == 0;
    const unsigned int  pinion_side     = slave_is_pinion ? 0 : 1;
    const unsigned int  pinion_tooth    = slave_is_pinion ? tooth.slave_group : tooth.master_group;
    const unsigned int  gear_tooth      = slave_is_pinion ? tooth.master_group : tooth.slave_group;
    const GridPressure &grid            = tooth.grid;
    const auto          begin_row       = [&] {
      std::vector<Table::Cell> row;
      if (rows_ == PressureRows::instants)
        row.emplace_back(position.time);
      row.insert(row.end(), {position.position, pinion_tooth, gear_tooth});
      return row;
    };
    const auto add_places = [&](const std::size_t cell, std::vector<Table::Cell> &row) {
      for (const unsigned int body : {0u, 1u})
        {
          const Vector3 &x     = tooth.places[body == 0 ? pinion_side : 1 - pinion_side][cell];
          const Vector2  place = place_on_flank(outlines_[body], {x.head<2>().norm(), x[2]});
          row.insert(row.end(), {place[0], place[1]});
        }
    };
    // A tooth of the driver that is ahead in its sense has been where tooth 0, in the middle of its
    // mesh at position 0, is now.
    const Transmission &t     = *model_.only_transmission();
    const double        z     = t.driver_teeth;
    const double        after = position.position + t.driver_sense * tooth.slave_group;
    const std::size_t   most  = grid.largest();

    std::vector<Table::Cell> row = begin_row();
    row.insert(row.end(),
               {after - z * std::floor(after / z + .5),
                grid.force,
                1e-3 * grid.moment,
                grid.moment / torque,
                grid.pressures[most],
                find_largest_inside(grid),
                grid.at_edge[most] ? 1 : 0,
                grid.area,
                grid.width,
                grid.length});
    add_places(most, row);
    row.emplace_back(position.transmission_error);
    teeth_.add_row(row);
    for (std::size_t i = 0; i < grid.cells.size(); ++i)
      {
        row = begin_row();
        add_places(i, row);
        row.emplace_back(grid.pressures[i]);
        cells_.add_row(row);
      }
  }

  NamedFigures PressureTables::list_figures() const
  {
    NamedFigures figures;
    for (const char *name : {column::largest_pressure, column::largest_pressure_inside})
      {
        const std::vector<double> &values = teeth_.numbers(name);
        if (!values.empty())
          figures.push_back({std::string(name) + figure_name::on_own_grid,
                             {*std::max_element(values.begin(), values.end()), "MPa"}});
      }
    return figures;
  }
} // namespace vfife
