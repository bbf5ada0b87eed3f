// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_study_conventional_loaded_contact_tables_h
#define vfife_study_conventional_loaded_contact_tables_h

#include <vfife/base/text/table.h>
#include <vfife/element/stress.h>
#include <vfife/output/files/figures.h>

#include <vector>

namespace vfife
{
  class Body;

  /** Columns of loaded_contact.csv: a row a position of the pair. The lumped model reads the file
   * as its mesh law. */
  Table make_loaded_contact_table();

  /** Columns of loaded_teeth.csv: a row a position and tooth pair in contact. */
  Table make_loaded_teeth_table();

  /** Columns of bearings.csv: a row a position and bearing, list_bearing_columns() behind the
   * position. */
  Table make_loaded_bearing_table();

  /** Columns of misalignment.csv of a loaded tooth contact analysis: the misalignment and the parts
   * of the transmission error of bearings and shafts. */
  Table make_loaded_misalignment_table();

  /** Columns of root_stress.csv: a row a position and tooth, list_root_stress_columns() behind the
   * position. */
  Table make_loaded_root_stress_table();

  /** Columns of gauges.csv: a row a position, gauge and tooth, list_gauge_columns() behind the
   * position. */
  Table make_loaded_gauge_table();

  /** Largest von Mises stress of some named sets of a body [MPa], 0 where it has none. */
  double find_largest_stress(const Body                      &body,
                             const std::vector<Stress>       &stresses,
                             const std::vector<const char *> &sets);

  /** Figures of an analysis for tables of several, over its positions: means, peak to peak of the
   * transmission errors, largest stresses, mean misalignment where there are rows of one. */
  NamedFigures list_loaded_figures(const Table &positions, const Table &misalignments);

  namespace column
  {
    constexpr char error_of_bearings[]      = "transmission error of bearings";
    constexpr char error_of_shaft_bending[] = "transmission error of shaft bending";
  } // namespace column
} // namespace vfife

#endif
