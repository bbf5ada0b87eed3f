// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_mesh_gear_sector_gear_sector_builder_h
#define vfife_mesh_gear_sector_gear_sector_builder_h

#include <vfife/mesh/gear/conical_web.h>
#include <vfife/mesh/gear/gear_body_options.h>
#include <vfife/mesh/gear/gear_section.h>
#include <vfife/mesh/gear/sector/gear_sector_cells.h>

#include <vector>

namespace vfife
{
  /**
   * Builds a GearSector block by block: tooth, rim, web, hub, shaft (layout in doc/theory/mesh.md).
   * Member and options must outlive it.
   */
  class GearSectorBuilder
  {
  public:
    /** Throws InputError as compute_gear_section(). */
    GearSectorBuilder(const GearGeometry &gear, const GearBodyOptions &options);

    /** Only once: the sector is moved out. Throws NumericalError for an inverted cell. */
    GearSector build();

  private:
    /** Nodes of a section on flanks, fillets, tip and root land. */
    struct SurfaceNodes
    {
      unsigned int              slot = 0;     ///< centre of the slot below the tooth
      std::vector<unsigned int> lower, upper; ///< profiles as those of GearSection
      std::vector<unsigned int> tip;          ///< both corners included

      /** From the slot to P of the lower fillet. */
      std::vector<unsigned int> below() const
      {
        return {slot, lower[0], lower[1]};
      }
      /** From P over the tip to P of the upper fillet. */
      std::vector<unsigned int> around_tooth() const;
      /** From P of the upper fillet to the next slot. */
      std::vector<unsigned int> above() const;
    };

    void add_tooth();
    void add_rim();
    /** The outline of the blocks of tooth and rim in section i. */
    SurfaceNodes outline_of_blocks(unsigned int i) const;
    /** New nodes of the true outline of section i. */
    SurfaceNodes make_surface_nodes(unsigned int i);
    void         add_surface_layer();
    void         add_flank_grid(FlankSide side);
    void         add_named_ends();

    /** Row of the tip; the rows of the profiles of all sections are one more. */
    unsigned int last_tooth_row() const
    {
      return sections_.front().lower.size() - 2;
    }
    Vector2 tooth_point(const GearSection &section, unsigned int row, unsigned int column) const;
    Vector2 rim_top(const GearSection &section, unsigned int column) const;
    double  rim_depth(unsigned int i, unsigned int row) const;
    Vector3 rim_point(unsigned int i, unsigned int row, unsigned int column) const;
    /** First section whose underside carries the web (not at the toe). */
    unsigned int first_web_section() const;
    /** Cone distance of section i on the underside, which leaves room for the web there. */
    double underside_place(unsigned int i) const;
    /** Nodes of the rim where the web starts. */
    NodeLayer web_foot() const;

    unsigned int rows_above_web() const
    {
      return (options_.rim_rows - options_.web_layers) / 2;
    }

    const GearGeometry      &gear_;
    const GearBodyOptions   &options_;
    const bool               at_toe_, at_underside_; ///< where there is a web
    std::vector<GearSection> sections_;
    std::vector<GearSection> inner_; ///< under the surface layer; without one the sections
    std::vector<double>      across_, rim_parts_; ///< places of columns, of rim rows where graded
    ConicalWeb               web_;                ///< used where the body has one
    std::vector<NodeLayer>   tooth_, rim_;

    std::vector<SurfaceNodes> surface_; ///< of each section
    NodeLayer                 bore_;    ///< lines along the axis, of a body that has one
    GearSectorCells           cells_;
  };
} // namespace vfife

#endif
