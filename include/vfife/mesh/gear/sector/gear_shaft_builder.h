// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_mesh_gear_sector_gear_shaft_builder_h
#define vfife_mesh_gear_sector_gear_shaft_builder_h

#include <vfife/mesh/gear/gear_shaft_options.h>
#include <vfife/mesh/gear/sector/gear_sector_cells.h>

#include <vector>

namespace vfife
{
  /**
   * Adds the shaft of a body to its sector (doc/theory/mesh.md, Shafts): a grid of rings about the
   * axis, filled where a section lies, that shares the nodes of the bore. Options and cells must
   * outlive it.
   */
  class GearShaftBuilder
  {
  public:
    /** @p bore: nodes of hub or body on its bore, lines of nodes by rising z. Takes for granted
     * what check_gear_shaft() checks. */
    GearShaftBuilder(const GearShaftOptions &options, GearSectorCells &cells, NodeLayer bore);

    /** Cells and sets; once. Throws NumericalError for an inverted cell. */
    void add();

  private:
    void divide_axis();
    void divide_radius();

    /** Line of the bore along which the columns of a line lie. */
    const std::vector<unsigned int> &bore_line(unsigned int line) const;
    /** Polar angle of a node [rad]. */
    double angle_of(unsigned int node) const;
    /** Of a row under a radius that joins three columns into one. */
    double joining_length(double radius) const;

    /** Whether there is metal between a line and the next, and a circle and the next; there is none
     * beyond the grid. */
    bool is_filled(int line, int circle) const;
    /** Whether cells of hub or body lie around the bore between a line and the next. */
    bool is_in_hub(unsigned int line) const;

    /** Of a circle from one line to another, made where there are none yet. */
    NodeLayer nodes_of(unsigned int circle, unsigned int first, unsigned int last);
    void      add_cells(unsigned int circle, unsigned int first, unsigned int last);
    void      add_sides(unsigned int line, unsigned int circle);

    const GearShaftOptions   &options_;
    GearSectorCells          &cells_;
    NodeLayer                 bore_;
    std::vector<ShaftSection> sections_;
    std::vector<double>       heights_;          ///< of the lines, rising [mm]
    std::vector<double>       radii_;            ///< of the circles, from outside inwards [mm]
    unsigned int              first_in_hub_ = 0; ///< line that is the first of the bore
    unsigned int              bore_circle_  = 0;
    unsigned int           joining_circle_ = 0; ///< over the row that joins columns; none: past all
    std::vector<NodeLayer> nodes_; ///< [circle][line][column]; no columns where not made
    NodeLayer              inner_; ///< of the row that joins columns, [line]
  };
} // namespace vfife

#endif
