// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_mesh_shaft_sections_h
#define vfife_mesh_shaft_sections_h

#include <vfife/base/parameter_handler.h>

#include <set>
#include <string>
#include <vector>

namespace vfife
{
  /** A rectangle of the meridian plane, solid where the inner diameter is zero [mm]. */
  struct ShaftSection
  {
    double from = 0, to = 0;     ///< along the axis
    double outer = 0, inner = 0; ///< diameters
  };

  /**
   * Reads "FROM TO OUTER [INNER]" for each section, separated by commas [mm]. Throws InputError of
   * the entry @p entry for words that are no numbers, sizes that contradict each other, sections
   * that cross, and a text without any.
   */
  std::vector<ShaftSection> parse_shaft_sections(const std::string &text, const std::string &entry);

  /** Declares the entries "axial element size" and "radial element size" [mm] of what is meshed by
   * sections; @p where: along the axis, in words. Bound by address. */
  void declare_cell_sizes(dealii::ParameterHandler &prm,
                          double                   &axial,
                          double                   &radial,
                          const std::string        &where = "");

  /** Section @p k of the list as messages name it: its number and its text. */
  std::string name_of_section(const std::string &text, std::size_t k);

  /** Fewest cells of equal length, none longer than @p largest; at least one. */
  unsigned int count_cells(double length, double largest);

  /** Ends of cells along a line, all @p places among them to the last digit; between neighbours
   * equal cells, none longer than @p largest. */
  std::vector<double> divide_between(const std::set<double> &places, double largest);
} // namespace vfife

#endif
