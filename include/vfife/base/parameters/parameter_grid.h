// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_base_parameters_parameter_grid_h
#define vfife_base_parameters_parameter_grid_h

#include <vfife/base/text/table.h>

#include <Eigen/Core>

#include <string>

namespace vfife
{
  /**
   * Reads numbers on a grid of at least 2 x 2 places from a file that a user names in a parameter
   * file. Either the file has the numbers alone, in rows and columns separated by commas,
   * semicolons or tabs, and lines beginning with "#" are passed over; or it is a table (see
   * read_parameter_table()) with the columns "row" and "column", counted from 1, and @p name.
   * Numbers are in @p unit, or in that of the heading.
   * @throws InputError naming the file, and row and column of a number that is missing, given twice
   * or none.
   */
  Eigen::MatrixXd
  read_parameter_grid(const std::string &path, const std::string &name, const std::string &unit);

  /** Whether a file begins with the headings "row" or "x" of a table and not with numbers; not
   * where it cannot be read. */
  bool has_headings(const std::string &path);

  /** The numbers of the column @p name [@p unit] of a table that has "row" and "column", as above.
   * @p path stands in messages. */
  Eigen::MatrixXd arrange_on_grid(const Table       &table,
                                  const std::string &path,
                                  const std::string &name,
                                  const std::string &unit);
} // namespace vfife

#endif
