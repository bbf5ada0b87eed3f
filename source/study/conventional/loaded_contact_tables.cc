// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/text/column_names.h>
#include <vfife/output/measures/bearing_columns.h>
#include <vfife/study/conventional/loaded_contact_tables.h>

namespace vfife
{
  Table make_loaded_contact_table()
  {
    Table table;
    table.add_column(column::position, "tooth meshes");
    table.add_column(column::angle_of("pinion"), "deg");
    table.add_column(column::unloaded_transmission_error, "arcsec");
    table.add_column(column::transmission_error, "arcsec");
    table.add_column(column::contact_torque_on("gear"), "N m");
    table.add_column(column::contact_force_total, "N");
    table.add_column(column::teeth_in_contact, "-");
    table.add_column(column::largest_pressure, "MPa");
    table.add_column("secant stiffness", "N m/rad");
    table.add_column(column::tangent_stiffness, "N m/rad");
    table.add_column("pinion fillet von mises", "MPa");
    table.add_column("gear fillet von mises", "MPa");
    table.add_column("web von mises", "MPa");
    table.add_column("iterations", "-");
    table.add_column("residual", "-");
    return table;
  }

  Table make_loaded_teeth_table()
  {
    Table table;
    table.add_column(column::position, "tooth meshes");
    table.add_text_column(column::side);
    table.add_column(column::tooth_of("pinion"), "-");
    table.add_column(column::tooth_of("gear"), "-");
    table.add_column(column::force, "N");
    table.add_column(column::torque, "N m");
    table.add_column("share of torque", "-");
    table.add_column(column::largest_pressure, "MPa");
    table.add_column(column::area, "mm^2");
    return table;
  }

  Table make_loaded_misalignment_table()
  {
    Table table;
    table.add_column(column::position, "tooth meshes");
    list_mounting_columns().add_to(table);
    return table;
  }

  Table make_loaded_bearing_table()
  {
    Table table;
    table.add_column(column::position, "tooth meshes");
    list_bearing_columns().add_to(table);
    return table;
  }
} // namespace vfife
