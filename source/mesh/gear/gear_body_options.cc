// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/parameters/parameters.h>
#include <vfife/mesh/gear/gear_body_options.h>
#include <vfife/mesh/mesh_size.h>

#include <cmath>
#include <sstream>

namespace vfife
{
  namespace
  {
    const Choices<WebKind>       web_kinds       = {{"none", WebKind::none},
                                                    {"conical", WebKind::conical},
                                                    {"solid", WebKind::solid}};
    const Choices<WebDirection>  web_directions  = {{"towards apex", WebDirection::apex},
                                                    {"towards back", WebDirection::back}};
    const Choices<WebAttachment> web_attachments = {{"toe", WebAttachment::toe},
                                                    {"middle", WebAttachment::middle},
                                                    {"heel", WebAttachment::heel}};

    /** A web steeper to the rim than this would leave no room for cells between it and the rim. */
    constexpr double largest_turn = 75. * degree;
    /** Least element size over the face width: some ten million elements in a pair. */
    constexpr double least_size_part = 1. / 150.;
    /** Least part of the rim's thickness that stays free on either side of the web. */
    constexpr double least_free_part = .08;

    /** Farther than this, the aspect ratio of cells says that other numbers of cells are wanted. */
    constexpr double largest_grading = 10.;

    /** Root radius at cone distance L. */
    Vector2 root_point(const BlankOutline &blank, const double L)
    {
      return blank.meridian_point({L, -blank.dedendum(L)});
    }

    /** Refuses entries of one section. */
    class Refusal
    {
    public:
      explicit Refusal(const std::string &section)
        : section_(section)
      {
      }

      void unless(const bool condition, const std::string &entry, const std::string &message) const
      {
        if (!condition)
          throw InputError(section_ + "/" + entry, message);
      }

    private:
      std::string section_;
    };

    std::string millimetres(const double value)
    {
      std::ostringstream text;
      text << value << " mm";
      return text.str();
    }

    /** Numbers of cells that the layout can do with. */
    void check_counts(const GearBodyOptions &options, const Refusal &refuse)
    {
      const auto at_least =
        [&](const char *entry, const unsigned int count, const unsigned int least) {
          refuse.unless(count >= least,
                        std::string("Mesh/") + entry,
                        std::to_string(count) + " is too few, at least " + std::to_string(least));
        };
      at_least("cells lengthwise", options.cells_lengthwise, 1);
      at_least("cells across tooth", options.cells_across, 2);
      at_least("flank rows", options.flank_rows, 1);
      at_least("rim rows", options.rim_rows, 1);
      if (options.web != WebKind::conical)
        return;
      at_least("web layers", options.web_layers, 1);
      at_least("web rows", options.web_rows, 2);
      at_least("hub rows", options.hub_rows, 1);
      at_least("hub side cells", options.hub_side_cells, 1);
      at_least("fillet rows", options.fillet_rows, 1);
      if (options.web_attachment == WebAttachment::toe)
        at_least("rim rows", options.rim_rows, options.web_layers + 2);
      else
        at_least("cells lengthwise", options.cells_lengthwise, options.web_layers + 2);
    }

    /** Sizes of a web that contradict each other or leave no room. */
    void
    check_conical(const GearBodyOptions &options, const BlankOutline &blank, const Refusal &refuse)
    {
      refuse.unless(options.web_thickness > 0.,
                    "Body/web thickness",
                    "must be positive, not " + millimetres(options.web_thickness) +
                      " (choose web = none for a rim without web)");
      refuse.unless(options.web_angle > 0. && options.web_angle <= pi / 2,
                    "Body/web angle",
                    "must lie above 0 and not above 90 deg");
      refuse.unless(options.hub_radius > options.bore_radius,
                    "Body/bore radius",
                    millimetres(options.bore_radius) + " is not smaller than the hub radius " +
                      millimetres(options.hub_radius));
      // the web must leave its wall at an angle
      const bool   at_toe = options.web_attachment == WebAttachment::toe;
      const double turn   = ConicalWeb::turn_from_wall(blank, options);
      // An angle just at the limit may miss it by round-off.
      refuse.unless(std::abs(turn) <= largest_turn + 1e-9,
                    at_toe ? "Body/web angle" : "Body/web attachment",
                    std::string("a web at this angle and direction ") +
                      (std::abs(turn) < .5 * pi ? "leaves the " : "does not leave the ") +
                      (at_toe ? "toe face" : "rim's underside") +
                      (std::abs(turn) < .5 * pi
                         ? " at " + std::to_string(90. - std::abs(turn) / degree) +
                             " deg to it; at least 15 deg are needed"
                         : ", it would run into the rim; choose another direction or attachment"));

      // its foot must fit on the wall: the depth of the rim at the toe, the underside elsewhere
      const double     inner = blank.inner_cone_distance(), outer = blank.outer_cone_distance;
      const ConicalWeb web(blank, options, -blank.dedendum(inner), -blank.dedendum(outer));
      const double     first = web.wall_place(0.), last = web.wall_place(1.);
      if (at_toe)
        refuse.unless(first >= least_free_part * options.rim_thickness &&
                        last <= (1. - least_free_part) * options.rim_thickness,
                      options.rim_fillet_radius > 0. ? "Body/rim fillet radius"
                                                     : "Body/web thickness",
                      "a web " + millimetres(options.web_thickness) +
                        " thick takes with its fillets " + millimetres(last - first) +
                        " and does not fit under the root of a rim " +
                        millimetres(options.rim_thickness) + " thick");
      else
        refuse.unless(first >= inner + least_free_part * blank.face_width &&
                        (options.web_attachment == WebAttachment::heel ||
                         last <= outer - least_free_part * blank.face_width),
                      "Body/web attachment",
                      "the foot of the web with its fillets is " + millimetres(last - first) +
                        " long and does not fit on the rim's underside, " +
                        millimetres(blank.face_width) + " long");
      // hub inside the foot, a straight part between the fillets, a hub as long as the web's end
      const double start = std::min(web.point(0., 0.)[0], web.point(0., 1.)[0]);
      refuse.unless(options.hub_radius < start,
                    "Body/hub radius",
                    millimetres(options.hub_radius) +
                      " leaves no room for a web, which starts at r = " + millimetres(start));
      refuse.unless(web.straight_start() < web.straight_end(),
                    "Body/hub fillet radius",
                    "the fillets leave no straight part of the web");
      refuse.unless(options.hub_length > web.foot_on_hub(),
                    "Body/hub length",
                    millimetres(options.hub_length) + " is shorter than the web's foot on the hub");
    }
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
      declare_choice(prm,
                     "web direction",
                     web_direction,
                     web_directions,
                     "Where the web goes from the rim inward");
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
  }

  void GearBodyOptions::check(const std::string &section, const BlankOutline &blank) const
  {
    const Refusal refuse(section);
    shaft.check(section + "/Shaft");
    refuse.unless(!shaft.present() || web != WebKind::none,
                  "Shaft/sections",
                  "a body with web = none has no bore that a shaft could go through; allowed with "
                  "web = conical or solid");
    if (shaft.present())
      {
        GearBodyOptions bare = *this;
        bare.shaft           = {};
        check_mesh_size(section + "/Shaft", n_cells(blank.teeth) - bare.n_cells(blank.teeth));
      }
    refuse.unless(element_size == 0. || element_size >= least_size_part * blank.face_width,
                  "Mesh/element size",
                  millimetres(element_size) + " is too small, at least " +
                    millimetres(least_size_part * blank.face_width));
    if (element_size == 0.)
      {
        check_counts(*this, refuse);
        check_mesh_size(section + "/Mesh", n_cells(blank.teeth));
      }

    const double L = blank.inner_cone_distance();
    // under the root: the bore of a solid body, or a rim that does not reach the axis
    const Vector2 inner = root_point(blank, L);
    if (web == WebKind::solid)
      {
        refuse.unless(bore_radius > 0. && bore_radius < inner[0],
                      "Body/bore radius",
                      millimetres(bore_radius) +
                        " must be positive and smaller than the root at the toe, " +
                        millimetres(inner[0]));
        return;
      }
    const double underside = blank.meridian_point({L, -blank.dedendum(L) - rim_thickness})[0];
    refuse.unless(rim_thickness > 0., "Body/rim thickness", "must be positive");
    refuse.unless(underside > 0.,
                  "Body/rim thickness",
                  millimetres(rim_thickness) + " reaches the axis at the toe");
    if (web == WebKind::conical)
      check_conical(*this, blank, refuse);
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
    return options;
  }
} // namespace vfife
