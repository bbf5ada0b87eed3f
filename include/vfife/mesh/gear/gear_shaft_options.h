// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_mesh_gear_gear_shaft_options_h
#define vfife_mesh_gear_gear_shaft_options_h

#include <vfife/mesh/shaft_sections.h>

#include <string>
#include <vector>

namespace dealii
{
  class ParameterHandler;
}

namespace vfife
{
  /**
   * A hollow shaft of one piece with a gear body: rings about its axis, one of which fills the bore
   * (doc/theory/mesh.md, Shafts). Places are those of the body's own frame, z from the apex.
   */
  struct GearShaftOptions
  {
    std::string text; ///< "FROM TO OUTER INNER" a section, separated by commas [mm]; empty: none
    double      axial_cell_size  = 5; ///< largest, beyond the hub [mm]
    double      radial_cell_size = 5; ///< largest [mm]

    /** Places along z beyond the hub that are to be ends of cells, no entry: whoever builds a model
     * sets them, for the ends of the seats of bearings [mm]. */
    std::vector<double> levels;

    /** Places nearer to each other than this are one [mm]. */
    static constexpr double tolerance = 1e-6;

    /** Declares the subsection Shaft in the current section. Bound by address. */
    void declare(dealii::ParameterHandler &prm);

    /** Whether there is any section. */
    bool present() const;

    /** Those of the text, in its order. Throws InputError of the entry "sections" under @p section
     * (e.g. "Gear pair/Pinion/Shaft") as parse_shaft_sections(). */
    std::vector<ShaftSection> sections(const std::string &section) const;

    /** Throws InputError where sections are wrong whatever body they go with: crossing, solid, or
     * not hanging together. Nothing to check without a section. */
    void check(const std::string &section) const;

    /** About the hexahedra of a sector's part of the shaft, in a body with @p columns and @p lines
     * of cells on a bore of this radius; 0 without a shaft. */
    double n_cells(double bore_radius, unsigned int columns, unsigned int lines) const;
  };
} // namespace vfife

#endif
