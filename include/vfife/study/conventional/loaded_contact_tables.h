// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_study_conventional_loaded_contact_tables_h
#define vfife_study_conventional_loaded_contact_tables_h

#include <vfife/base/text/table.h>

namespace vfife
{
  /** Columns of loaded_contact.csv: a row a position of the pair. The lumped model reads the file
   * as its mesh law. */
  Table make_loaded_contact_table();

  /** Columns of loaded_teeth.csv: a row a position and tooth pair in contact. */
  Table make_loaded_teeth_table();

  /** Columns of bearings.csv: a row a position and bearing, list_bearing_columns() behind the
   * position. */
  Table make_loaded_bearing_table();

  /** Columns of misalignment.csv of a loaded tooth contact analysis. */
  Table make_loaded_misalignment_table();
} // namespace vfife

#endif
