// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/sample_measures.h>
#include <vfife/base/text/column_names.h>
#include <vfife/model/body.h>
#include <vfife/output/measures/bearing_columns.h>
#include <vfife/output/measures/root_stress.h>
#include <vfife/study/conventional/loaded_contact_tables.h>

#include <algorithm>

namespace vfife
{
  namespace
  {
    template <typename Sample>
    Table make_table_over_positions(const SampleColumns<Sample> &columns)
    {
      return columns.make_table(column::position, "mesh cycles");
    }
  } // namespace

  Table make_loaded_contact_table()
  {
    return {{column::position, "mesh cycles"},
            {column::angle_of("pinion"), "deg"},
            {column::unloaded_transmission_error, "arcsec"},
            {column::transmission_error, "arcsec"},
            {column::contact_torque_on("gear"), "N m"},
            {column::contact_force_total, "N"},
            {column::teeth_in_contact, "-"},
            {column::largest_pressure, "MPa"},
            {"secant stiffness", "N m/rad"},
            {column::tangent_stiffness, "N m/rad"},
            {"pinion fillet von mises", "MPa"},
            {"gear fillet von mises", "MPa"},
            {"web von mises", "MPa"},
            {"iterations", "-"},
            {"residual", "-"}};
  }

  Table make_loaded_teeth_table()
  {
    return {{column::position, "mesh cycles"},
            {column::side},
            {column::tooth_of("pinion"), "-"},
            {column::tooth_of("gear"), "-"},
            {column::force, "N"},
            {column::torque, "N m"},
            {"share of torque", "-"},
            {column::largest_pressure, "MPa"},
            {column::area, "mm^2"}};
  }

  Table make_loaded_misalignment_table()
  {
    Table table = make_table_over_positions(list_mounting_columns());
    table.add_column(column::error_of_bearings, "arcsec");
    table.add_column(column::error_of_shaft_bending, "arcsec");
    return table;
  }

  Table make_loaded_bearing_table()
  {
    return make_table_over_positions(list_bearing_columns());
  }

  Table make_loaded_root_stress_table()
  {
    return make_table_over_positions(list_root_stress_columns());
  }

  Table make_loaded_gauge_table()
  {
    return make_table_over_positions(list_gauge_columns());
  }

  double find_largest_stress(const Body                      &body,
                             const std::vector<Stress>       &stresses,
                             const std::vector<const char *> &sets)
  {
    double largest = 0;
    for (const char *set : sets)
      if (body.has_node_set(set))
        for (const unsigned int node : body.node_set(set))
          largest = std::max(largest, von_mises(stresses[body.first_node + node]));
    return largest;
  }

  NamedFigures list_loaded_figures(const Table &positions, const Table &misalignments)
  {
    NamedFigures figures;
    const auto add = [&figures](const Table::Column &column, const char *what, const double value) {
      figures.push_back({column.name + what, {value, column.unit}});
    };
    // Each position of a mesh cycle counts alike.
    for (const char *name : {column::transmission_error, column::unloaded_transmission_error})
      {
        const Table::Column &error = positions.column(name);
        add(error, " mean", mean_of(error.numbers));
        // A single position has none.
        if (positions.n_rows() > 1)
          add(error, " peak to peak", peak_to_peak_of(error.numbers));
      }
    for (const char *name :
         {column::contact_force_total, "secant stiffness", column::tangent_stiffness})
      add(positions.column(name), " mean", mean_of(positions.numbers(name)));
    for (const char *name : {"pinion fillet von mises", "gear fillet von mises", "web von mises"})
      {
        const Table::Column &stress = positions.column(name);
        add(stress, " largest", *std::max_element(stress.numbers.begin(), stress.numbers.end()));
      }
    if (misalignments.n_rows() > 0)
      for (const Table::Column &column : misalignments.columns())
        if (column.name != column::position)
          add(column, " mean", mean_of(column.numbers));
    return figures;
  }
} // namespace vfife
