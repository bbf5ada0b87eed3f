// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_mesh_gear_sector_gear_sector_cells_h
#define vfife_mesh_gear_sector_gear_sector_cells_h

#include <vfife/mesh/gear/sector/gear_sector.h>

#include <functional>
#include <string>
#include <vector>

namespace vfife
{
  /** Node numbers of a sector, [row or layer][column]. */
  using NodeLayer = std::vector<std::vector<unsigned int>>;

  /** Length of a row that joins three columns into one over the width of the three: best of the
   * lengths tried for the least scaled Jacobian over all webs of the paper. */
  constexpr double coarsening_row_length = .8;
  /** Where its inner nodes stand, from the side of three columns (0) to that of one (1). */
  constexpr double coarsening_row_place = .6;

  /** A GearSector in the making: what those who build its blocks put in. */
  class GearSectorCells
  {
  public:
    /** @p name: of the gear, for messages; @p pitch: angle between sectors [rad]. */
    GearSectorCells(std::string name, double pitch);

    /** Of the cells added from now on. */
    void enter(GearRegion region);

    unsigned int add_node(const Vector3 &position);
    /** Of a node of this sector or the next [mm]. */
    Vector3 position(unsigned int node) const;

    /** Corners in either sense. Throws NumericalError for an inverted cell. */
    void add_hexahedron(CellNodes nodes);
    /** The cells between two layers of rows and columns. */
    void add_row(const NodeLayer &first, const NodeLayer &second);

    /** Where an inner node of a coarsening row stands, in a layer and next to the column of the
     * fine side [mm]. */
    using InnerPlace = std::function<Vector3(unsigned int layer, unsigned int column)>;
    /**
     * A row in which three columns of the fine side become one of the coarse side. Returns the
     * inner nodes, [layer][two of each column of the coarse side].
     */
    NodeLayer add_coarsening_row(const NodeLayer  &fine,
                                 const NodeLayer  &coarse,
                                 const InnerPlace &inner_place);

    /** Nodes of the next sector are left out: they are in its own set. */
    void add_to_set(const char *name, unsigned int node);
    void add_to_set(const char *name, const NodeLayer &layer);
    void add_flank(const FlankGrid &flank);

    /** Only once: the sector, its sets sorted, is moved out. */
    GearSector finish();

  private:
    std::string name_;
    Matrix3     to_next_; ///< rotation by the pitch
    GearRegion  region_ = GearRegion::tooth;
    GearSector  sector_;
  };
} // namespace vfife

#endif
