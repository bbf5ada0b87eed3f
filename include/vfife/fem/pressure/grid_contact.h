// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_fem_pressure_grid_contact_h
#define vfife_fem_pressure_grid_contact_h

#include <vfife/fem/pressure/elastic_contact.h>

#include <vector>

namespace vfife
{
  /** Pressures of two groups of facets on the contact's own grid. */
  struct GridPressure
  {
    ContactPlane             plane;
    std::vector<ContactCell> cells;     ///< those that carry
    std::vector<double>      pressures; ///< of them [MPa]
    std::vector<bool>        at_edge;   ///< of them: beside the border of one of the surfaces

    double force   = 0; ///< sum of normal forces [N]
    double moment  = 0; ///< with the arms [N], [N mm]
    double area    = 0; ///< [mm^2]
    double length  = 0; ///< of what carries, along the plane's axes [mm]
    double width   = 0; ///< the widest place across [mm]
    double closing = 0; ///< of all contacts of the load, over the arms

    bool carries() const
    {
      return !cells.empty();
    }
    /** Of the cell with the largest pressure. */
    std::size_t largest() const;
    /** Normal force of a cell [N]. */
    double force_of(std::size_t cell) const;
  };

  /**
   * Pressures of contacts that carry a load together, on grids of their own with about @p
   * cells_across the width of each: the finite elements' flexibility, less that of what lies near
   * the surfaces, and in its place that of a held layer in closed form
   * (doc/theory/pressure-grid.md). Frictionless. The layer in closed form goes on beyond edges, as
   * near layers must. Throws NumericalError where the pressures are not found.
   */
  std::vector<GridPressure> find_grid_pressures(const std::vector<ElasticContact> &contacts,
                                                const ContactLoad                 &load,
                                                unsigned int                       cells_across);
} // namespace vfife

#endif
