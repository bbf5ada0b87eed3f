// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/parameters/parameters.h>
#include <vfife/mesh/gear/gear_body_options.h>

namespace vfife
{
  namespace
  {
    const Choices<WebKind>       web_kinds       = {{"none", WebKind::none},
                                                    {"conical", WebKind::conical},
                                                    {"solid", WebKind::solid}};
    const Choices<WebDirection>  web_directions  = {{"as it fits", WebDirection::fitting},
                                                    {"towards apex", WebDirection::apex},
                                                    {"towards back", WebDirection::back}};
    const Choices<WebAttachment> web_attachments = {{"toe", WebAttachment::toe},
                                                    {"middle", WebAttachment::middle},
                                                    {"heel", WebAttachment::heel}};

    /** Farther than this, the aspect ratio of cells says that other numbers of cells are wanted. */
    constexpr double largest_grading = 10.;
  } // namespace

  void GearBodyOptions::declare(dealii::ParameterHandler &prm)
  {
    {
      const Subsection section(prm, "Body");
      declare_choice(
        prm, "web", web, web_kinds, "What carries the rim; none: its underside is held");
      declare_quantity(
        prm,
        "web thickness",
        web_thickness,
        "mm",
        "Thickness of the web, normal to it; 0, as of the other sizes: in proportion to the "
        "blank, as that of the pair 27/79 (1.587 modules)",
        Range::not_negative());
      declare_quantity(prm,
                       "web angle",
                       web_angle,
                       "deg",
                       "Support angle: mid-surface generatrix of the web to the axis",
                       Range::between(0., 90.));
      declare_choice(
        prm,
        "web direction",
        web_direction,
        web_directions,
        "Where the web goes from the rim inward; as it fits: towards the back where such "
        "a web leaves the rim at 15 deg or more, otherwise towards the apex");
      declare_choice(
        prm, "web attachment", web_attachment, web_attachments, "Where the web leaves the rim");
      declare_quantity(prm,
                       "rim thickness",
                       rim_thickness,
                       "mm",
                       "Metal under the root of a rim; 0: 2.7 modules",
                       Range::not_negative());
      declare_quantity(prm,
                       "rim fillet radius",
                       rim_fillet_radius,
                       "mm",
                       "Radius between the faces of the web and the rim; 0: sharp corners",
                       Range::not_negative());
      declare_quantity(prm,
                       "hub fillet radius",
                       hub_fillet_radius,
                       "mm",
                       "Radius between the faces of the web and the hub; 0: sharp corners",
                       Range::not_negative());
      declare_quantity(
        prm,
        "hub radius",
        hub_radius,
        "mm",
        "Outer radius of the hub ring that carries the web; 0: 0.632 of the root's radius at "
        "the toe",
        Range::not_negative());
      declare_quantity(
        prm,
        "bore radius",
        bore_radius,
        "mm",
        "Radius of the bore of hub or solid body; 0: 5/6 of the hub radius, 0.64 of the "
        "root's radius at the toe of a solid body",
        Range::not_negative());
      declare_quantity(
        prm,
        "hub length",
        hub_length,
        "mm",
        "Length of the hub ring along the axis, centred on the web; 0: 0.379 of the root's "
        "radius at the toe, or 1.2 of the web's foot on it if that is more",
        Range::not_negative());
    }
    declare_counts(prm);
    shaft.declare(prm);
  }

  void GearBodyOptions::declare_counts(dealii::ParameterHandler &prm)
  {
    const Subsection section(prm, "Mesh");
    declare_quantity(prm,
                     "element size",
                     element_size,
                     "mm",
                     "Target length of edges; 0: as the numbers of cells below say, else these "
                     "follow from the size",
                     Range::not_negative());
    declare_integer(prm, "cells lengthwise", cells_lengthwise, "Cells along the face width", 1);
    declare_integer(prm,
                    "cells across tooth",
                    cells_across,
                    "Cells from flank to flank; 2, 5, 8 let the web be coarser than the teeth",
                    2);
    declare_integer(prm, "flank rows", flank_rows, "Cells from flank start to tip", 1);
    declare_integer(
      prm, "rim rows", rim_rows, "Cells from root to underside, or to the bore of a solid body", 1);
    declare_integer(prm, "web layers", web_layers, "Cells through the thickness of the web", 1);
    declare_integer(
      prm, "web rows", web_rows, "Cells along the web, the coarsening row included", 2);
    declare_integer(prm,
                    "fillet rows",
                    fillet_rows,
                    "Cells along each fillet of the web, besides the web rows",
                    1);
    declare_integer(prm, "hub rows", hub_rows, "Cells from hub radius to bore", 1);
    declare_integer(prm,
                    "hub side cells",
                    hub_side_cells,
                    "Cells of the hub along the axis on either side of the web",
                    1);
    declare_integer(prm,
                    "refinements",
                    refinements,
                    "Times that every cell is divided into eight, new nodes on the true surfaces",
                    0,
                    3);
    declare_gradings(prm);
  }

  void GearBodyOptions::declare_gradings(dealii::ParameterHandler &prm)
  {
    declare_number(prm,
                   "grading towards fillet",
                   grading_towards_fillet,
                   "Height of the flank row at the tip over that at the fillet, and of the rim row "
                   "at the bore or underside over that at the root (not with a web at the toe); "
                   "1: equal rows",
                   Range::between(1. / largest_grading, largest_grading));
    declare_number(prm,
                   "grading towards flank",
                   grading_towards_flank,
                   "Width of the columns in the middle of the tooth over that at the flanks; 1: "
                   "equal columns",
                   Range::between(1. / largest_grading, largest_grading));
    declare_number(prm,
                   "fillet corner",
                   fillet_corner,
                   "Place in the fillet where the mesh blocks of tooth, rim and root land meet: "
                   "fraction of the fillet's arc, from its bottom. Cells are the most distorted "
                   "there: keep it away from the largest root stress",
                   Range::between(.2, .9));
  }

  GearBodyOptions pinion_body_defaults()
  {
    GearBodyOptions options;
    options.web              = WebKind::solid;
    options.bore_radius      = 20.;
    options.cells_lengthwise = 16;
    options.flank_rows       = 9;
    options.rim_rows         = 4;
    return options;
  }

  GearBodyOptions coarse(GearBodyOptions options)
  {
    options.cells_lengthwise = options.web == WebKind::solid ? 6 : 4;
    options.cells_across     = 2;
    options.flank_rows       = 3;
    options.rim_rows         = options.web == WebKind::solid ? 3 : 4;
    options.web_layers       = 2;
    options.web_rows         = 5;
    options.hub_rows         = 2;
    options.hub_side_cells   = 2;
    options.refinements      = 0;
    options.element_size = options.edge_in_modules = 0.;
    options.grading_towards_fillet = options.grading_towards_flank = 1.;
    options.fillet_corner                                          = default_fillet_corner;
    return options;
  }
} // namespace vfife
