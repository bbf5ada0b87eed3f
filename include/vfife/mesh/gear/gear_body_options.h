// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_mesh_gear_gear_body_options_h
#define vfife_mesh_gear_gear_body_options_h

#include <vfife/mesh/gear/conical_web.h>
#include <vfife/mesh/gear/gear_section.h>
#include <vfife/mesh/gear/gear_shaft_options.h>

#include <string>

namespace dealii
{
  class ParameterHandler;
}

namespace vfife
{
  /** What carries the rim. */
  enum class WebKind
  {
    none,    ///< nothing: the underside of the rim is held
    conical, ///< a straight cone of constant thickness from the rim to a hub ring
    solid    ///< solid metal down to the bore (pinion)
  };

  /**
   * Body under the teeth and number of cells, as they are given. The defaults are those of the gear
   * of the full mesh (doc/theory/mesh.md); a pinion starts from pinion_body_defaults().
   */
  struct GearBodyOptions : WebShape
  {
    WebKind web         = WebKind::conical;
    double  bore_radius = 50.; ///< [mm]
    double  hub_length =
      36.; ///< along the axis, centred where the mid-surface of the web meets the hub [mm]

    double element_size    = 0.; ///< target edge length [mm]; 0: the counts below, as they stand
    double edge_in_modules = 0.; ///< where that is open: the same in modules of the blank; 0: none
    bool   has_fineness    = false; ///< element_size is of edge_in_modules: edges differ by place

    unsigned int cells_lengthwise = 12; ///< along the face width
    unsigned int cells_across     = 5;  ///< across a tooth
    unsigned int flank_rows       = 8;  ///< from start to end of the flank
    unsigned int rim_rows =
      5; ///< from root to underside of the rim, or to the bore of a solid body
    unsigned int web_layers     = 3;  ///< through the thickness of the web
    unsigned int web_rows       = 11; ///< along the web, the coarsening row included
    unsigned int fillet_rows    = 2;  ///< along each fillet of the web, besides web_rows
    unsigned int hub_rows       = 3;  ///< from hub radius to bore
    unsigned int hub_side_cells = 4;  ///< along the axis on either side of the web
    unsigned int refinements    = 0;  ///< times that every cell is divided into eight

    /** Height of the flank row at the tip over that at the fillet; depth of the rim row at the bore
     * or underside over that at the root, where the web at the toe does not place the rows. */
    double grading_towards_fillet = 1.;
    /** Width of the columns in the middle of the tooth over that at the flanks. */
    double grading_towards_flank = 1.;
    /** compute_gear_section(). */
    double fillet_corner = default_fillet_corner;
    /** Thickness of a layer of cells under flanks, fillets, tips and root lands; 0: none [mm]. */
    double surface_layer = 0.;

    GearShaftOptions shaft; ///< of one piece with the body; none by default

    /** Declares the subsections Body, Mesh and Shaft in the current section. */
    void declare(dealii::ParameterHandler &prm);

    /** Columns of cells of a sector's rim: across the tooth, and two on either side for fillet and
     * root land. */
    unsigned int columns() const
    {
      return cells_across + 4;
    }
    /** Hexahedra of a body under these teeth, once the counts are known. */
    double n_cells(const BlankOutline &blank) const;
    /** Whether the web's first row joins three columns into one (needs a multiple of three). */
    bool coarsens() const
    {
      return columns() % 3 == 0;
    }

    /** Declares in the current section, that of a pair, the choice of a mesh in modules for both
     * its bodies: edge_in_modules. By default it is open where these have their numbers of
     * elements from the file, and coarse otherwise. */
    static void declare_fineness(dealii::ParameterHandler &prm,
                                 GearBodyOptions          &pinion,
                                 GearBodyOptions          &gear,
                                 bool                      has_numbers);

    /** Leaves the sizes of the body open, to follow from the blank (with_open_sizes()): web, rim,
     * hub, bore. */
    void leave_sizes_open();

  private:
    void declare_counts(dealii::ParameterHandler &prm);
    void declare_gradings(dealii::ParameterHandler &prm);
  };

  /** A pinion of the full mesh: solid down to a bore of 20 mm. */
  GearBodyOptions pinion_body_defaults();

  /** The same body with few cells (pair of the paper: about 18,000), whatever its mesh was. */
  GearBodyOptions coarse(GearBodyOptions options);
} // namespace vfife

#endif
