// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/parameters/parameters.h>
#include <vfife/mesh/gear/gear_body_options.h>

#include <cmath>
#include <string>
#include <vector>

namespace vfife
{
  namespace
  {
    const Choices<WebKind>       web_kinds       = {{"rim only", WebKind::none},
                                                    {"conical web", WebKind::conical},
                                                    {"solid", WebKind::solid}};
    const Choices<WebDirection>  web_directions  = {{"auto", WebDirection::fitting},
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
      declare_choice(prm,
                     "body type",
                     web,
                     web_kinds,
                     "Type of the body. rim only: the underside of the rim is fixed to the axis; "
                     "conical web: rim, web and hub; solid: down to the bore");
      declare_quantity(
        prm,
        "web thickness",
        web_thickness,
        "mm",
        "Web thickness, normal to the web; auto: in proportion to the pair 27/79 (1.587 "
        "modules), likewise for the other sizes",
        Range::positive().or_word("auto"));
      declare_quantity(prm,
                       "web inclination",
                       web_angle,
                       "deg",
                       "Support angle: angle between the web's mid-surface and the axis",
                       Range::between(0., 90.));
      declare_choice(prm,
                     "web direction",
                     web_direction,
                     web_directions,
                     "Direction of the web from the rim inward. auto: towards the back if the web "
                     "then meets the rim at 15 deg or more, otherwise towards the apex");
      declare_choice(prm,
                     "web attachment",
                     web_attachment,
                     web_attachments,
                     "Place where the web joins the rim");
      declare_quantity(prm,
                       "rim thickness",
                       rim_thickness,
                       "mm",
                       "Rim thickness under the tooth root; auto: 2.7 modules",
                       Range::positive().or_word("auto"));
      declare_quantity(prm,
                       "rim fillet radius",
                       rim_fillet_radius,
                       "mm",
                       "Fillet radius between web and rim; 0: sharp corners",
                       Range::not_negative());
      declare_quantity(
        prm,
        "hub fillet radius",
        hub_fillet_radius,
        "mm",
        "Fillet radius between web and hub; 0: a sharp corner, whose stress has no limit",
        Range::not_negative());
      declare_quantity(prm,
                       "hub radius",
                       hub_radius,
                       "mm",
                       "Outer radius of the hub; auto: 0.632 of the root radius at the toe",
                       Range::positive().or_word("auto"));
      declare_quantity(
        prm,
        "bore radius",
        bore_radius,
        "mm",
        "Radius of the bore; auto: 5/6 of the hub radius, or 0.64 of the root radius at "
        "the toe for a solid body",
        Range::positive().or_word("auto"));
      declare_quantity(
        prm,
        "hub length",
        hub_length,
        "mm",
        "Length of the hub along the axis, centred on the web; auto: 0.379 of the root "
        "radius at the toe, or 1.2 of the web's axial width at the hub if that is "
        "larger",
        Range::positive().or_word("auto"));
    }
    declare_counts(prm);
    shaft.declare(prm);
  }

  void GearBodyOptions::declare_counts(dealii::ParameterHandler &prm)
  {
    const Subsection section(prm, "Mesh");
    declare_quantity(
      prm,
      "element size",
      element_size,
      "mm",
      "Target edge length of elements; none: given by the numbers of elements below. "
      "With a size, these numbers follow from it unless they are set",
      Range::positive().or_word("none"));
    declare_integer(
      prm, "elements along face width", cells_lengthwise, "Elements along the face width", 1);
    declare_integer(prm,
                    "elements across tooth",
                    cells_across,
                    "Elements across the tooth; use 2, 5, 8, ... if the web mesh shall be coarser "
                    "than the tooth mesh",
                    2);
    declare_integer(prm,
                    "elements along profile",
                    flank_rows,
                    "Elements along the profile from the start of the flank to the tip",
                    1);
    declare_integer(prm,
                    "elements through rim",
                    rim_rows,
                    "Elements through the rim from the root to its underside (solid body: to the "
                    "bore)",
                    1);
    declare_integer(
      prm, "elements through web", web_layers, "Elements through the thickness of the web", 1);
    declare_integer(prm,
                    "elements along web",
                    web_rows,
                    "Elements along the web, including the transition row",
                    2);
    declare_integer(prm,
                    "elements along web fillet",
                    fillet_rows,
                    "Elements along each fillet of the web, in addition to those along the web",
                    1);
    declare_integer(
      prm, "elements through hub", hub_rows, "Elements from the hub's outer radius to the bore", 1);
    declare_integer(prm,
                    "elements beside web",
                    hub_side_cells,
                    "Elements of the hub along the axis on each side of the web",
                    1);
    declare_integer(prm,
                    "refinements",
                    refinements,
                    "Number of times that each element is divided into eight; new nodes lie on "
                    "the exact surfaces",
                    0,
                    3);
    declare_gradings(prm);
  }

  void GearBodyOptions::declare_gradings(dealii::ParameterHandler &prm)
  {
    declare_number(prm,
                   "grading towards fillet",
                   grading_towards_fillet,
                   "Growth of elements away from the fillet: height at the tip (in the rim: at "
                   "the bore or underside) divided by height at the fillet; 1: equal heights; in "
                   "the rim not with a web at the toe",
                   Range::between(1. / largest_grading, largest_grading));
    declare_number(prm,
                   "grading towards flank",
                   grading_towards_flank,
                   "Growth of elements away from the flanks: width in the middle of the tooth "
                   "divided by width at the flanks; 1: equal widths",
                   Range::between(1. / largest_grading, largest_grading));
    declare_number(prm,
                   "fillet corner",
                   fillet_corner,
                   "Point of the fillet where the mesh blocks of tooth, rim and root land meet: "
                   "part of the fillet's arc, from its bottom. Elements are most distorted "
                   "there; keep it away from the largest root stress",
                   Range::between(.2, .9));
    declare_quantity(
      prm,
      "surface layer",
      surface_layer,
      "mm",
      "Thickness of a layer of elements under flanks, fillets, tips and root lands. Then the mesh "
      "blocks meet below the surface and not on the fillet, where root stresses are read. The "
      "layer shortens the time step of runs. Use 0.2 modules for root stresses; none: no layer",
      Range::positive().or_word("none"));
  }

  void GearBodyOptions::declare_fineness(dealii::ParameterHandler &prm,
                                         GearBodyOptions          &pinion,
                                         GearBodyOptions          &gear,
                                         const bool                has_numbers)
  {
    // Edges in modules (doc/verification/gear-pair.md, Penalty and mesh, has what each of them
    // leaves as error).
    const double             coarse_edge = 2. / 3.;
    const Choices<double>    edges       = {{"auto", has_numbers ? 0. : coarse_edge},
                                            {"by members", 0.},
                                            {"coarse", coarse_edge},
                                            {"medium", .45},
                                            {"fine", .3}};
    std::vector<std::string> words;
    for (const auto &edge : edges)
      words.push_back(edge.first);
    declare_choice(
      prm,
      "mesh",
      words,
      words.front(),
      [&pinion, &gear, edges](const unsigned int chosen) {
        pinion.edge_in_modules = gear.edge_in_modules = edges[chosen].second;
      },
      "Mesh density of both bodies. coarse, medium, fine: edge lengths of about "
      "0.67, 0.45 and 0.3 outer transverse modules; by members: the "
      "numbers of elements in the Mesh sections of the members, by default about 1,300 elements "
      "per tooth; auto: by members where the file has a section Mesh of a member, otherwise "
      "coarse. "
      "The element size of a member overrides this choice");
  }

  void GearBodyOptions::leave_sizes_open()
  {
    web_thickness = rim_thickness = hub_radius = hub_length = bore_radius = 0.;
    web_direction                                                         = WebDirection::fitting;
  }

  double GearBodyOptions::n_cells(const BlankOutline &blank) const
  {
    // In numbers that do not overflow. The tooth has rows for fillet and chamfer besides those of
    // the flank.
    const double rows     = flank_rows + 1. + tip_rows(blank);
    const double in_teeth = cells_lengthwise * rows * cells_across;
    const double in_rim   = static_cast<double>(cells_lengthwise) * rim_rows * columns();
    double       n        = in_teeth + in_rim;
    if (surface_layer > 0.)
      n += cells_lengthwise * (cells_across + 2. * (rows + 2.));
    if (web == WebKind::solid)
      n += shaft.n_cells(bore_radius, columns(), cells_lengthwise);
    if (web == WebKind::conical)
      {
        // Three columns of the rim become one in a first row of four cells each.
        const unsigned int groups = coarsens() ? columns() / 3 : columns();
        const double       fillets =
          (rim_fillet_radius > 0. ? fillet_rows * static_cast<double>(columns()) : 0.) +
          (hub_fillet_radius > 0. ? fillet_rows * double(groups) : 0.);
        n += web_layers * (groups * (web_rows + (coarsens() ? 3. : 0.)) + fillets);
        n += hub_rows * (2. * hub_side_cells + web_layers) * groups;
        n += shaft.n_cells(bore_radius, groups, 2 * hub_side_cells + web_layers);
      }
    return blank.teeth * n * std::pow(8., refinements);
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
    options.surface_layer                                          = 0.;
    return options;
  }
} // namespace vfife
