// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/parameters/parameters.h>
#include <vfife/mesh/gear/gear_body_options.h>

#include <algorithm>
#include <cmath>

namespace vfife
{
  double GearBodyOptions::n_cells(const unsigned int teeth) const
  {
    // In numbers that do not overflow. The tooth has a row for the fillet besides those of the
    // flank.
    const double in_teeth = cells_lengthwise * (flank_rows + 1.) * cells_across;
    const double in_rim   = static_cast<double>(cells_lengthwise) * rim_rows * columns();
    double       n        = in_teeth + in_rim;
    if (surface_layer > 0.)
      n += cells_lengthwise * (cells_across + 2. * (flank_rows + 3.));
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
    return teeth * n * std::pow(8., refinements);
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

  double GearBodyOptions::foot_on_hub(const BlankOutline &blank) const
  {
    // What no web can be is refused later.
    if (web != WebKind::conical || !(web_thickness > 0.) || !(web_angle > 0.) || !(hub_radius > 0.))
      return 0.;
    const ConicalWeb cone(blank,
                          *this,
                          -blank.dedendum(blank.inner_cone_distance()),
                          -blank.dedendum(blank.outer_cone_distance));
    return cone.foot_on_hub();
  }

  GearBodyOptions GearBodyOptions::with_open_sizes(const BlankOutline &blank) const
  {
    GearBodyOptions sized = *this;
    const auto      fill  = [](double &size, const double proposed) {
      if (size == 0.)
        size = std::round(10. * proposed) / 10.;
    };
    const double inner = blank.inner_cone_distance();
    const double root  = blank.meridian_point({inner, -blank.dedendum(inner)})[0];
    const double module =
      2. * blank.meridian_point({blank.outer_cone_distance, 0.})[0] / blank.teeth;
    if (web_direction == WebDirection::fitting)
      {
        sized.web_direction = WebDirection::back;
        if (!ConicalWeb::leaves_wall(blank, sized))
          sized.web_direction = WebDirection::apex;
      }
    // The rim of a small gear leaves a third of the root's radius to web, hub and bore: the web
    // must start outside the hub.
    const double size = std::min(module, 0.34 / 2.7 * root / std::cos(blank.pitch_angle));
    fill(sized.web_thickness, 1.587 * size);
    fill(sized.rim_thickness, 2.7 * size);
    fill(sized.hub_radius, 0.632 * root);
    fill(sized.bore_radius, web == WebKind::solid ? 0.64 * root : sized.hub_radius * 5. / 6.);
    fill(sized.hub_length, std::max(0.379 * root, 1.2 * sized.foot_on_hub(blank)));
    if (element_size == 0.)
      {
        sized.element_size = edge_in_modules * module;
        sized.has_fineness = edge_in_modules > 0.;
      }
    return sized;
  }

  GearBodyOptions GearBodyOptions::with_counts_of_size(const GearGeometry &gear) const
  {
    GearBodyOptions sized = *this;
    if (element_size == 0.)
      return sized;
    // Of a fineness the edges differ by what they change of the transmission error per element: the
    // root bends over few flank rows, a rim without a web below it over few of its rows, and the
    // layers of a web do little.
    const auto count = [this](const double length, const unsigned int least, const double factor) {
      const double edge = has_fineness ? factor * element_size : element_size;
      return std::max<unsigned int>(least, std::lround(length / edge));
    };
    const BlankOutline &blank  = gear.blank();
    const double        L      = blank.mean_cone_distance;
    const bool          on_web = web == WebKind::conical;
    sized.element_size         = 0.;

    // teeth at mid-face, then what lies under them, down to bore, underside or hub
    sized.cells_lengthwise = count(blank.face_width, 1, on_web ? 1.25 : 1.);
    sized.cells_across     = count(gear.tooth_thickness(L, 0.), 2, 1.25);
    sized.flank_rows       = count(blank.addendum(L) + blank.dedendum(L), 1, .9);
    if (web == WebKind::solid)
      {
        const double root = blank.meridian_point({L, -blank.dedendum(L)})[0];
        sized.rim_rows    = count((root - bore_radius) / std::cos(blank.pitch_angle), 1, 1.25);
        return sized;
      }
    sized.rim_rows = count(rim_thickness, 1, on_web ? 1. : .8);
    if (!on_web)
      return sized;
    // 2, 5, 8 ... cells across let the web be coarser than the teeth.
    sized.cells_across = std::max(2u, (sized.cells_across + 2) / 3 * 3 - 1);
    sized.web_layers   = count(web_thickness, has_fineness ? 2 : 1, 1.5);
    (web_attachment == WebAttachment::toe ? sized.rim_rows : sized.cells_lengthwise) =
      std::max(web_attachment == WebAttachment::toe ? sized.rim_rows : sized.cells_lengthwise,
               sized.web_layers + 2);
    const ConicalWeb cone(blank,
                          *this,
                          -blank.dedendum(blank.inner_cone_distance()),
                          -blank.dedendum(blank.outer_cone_distance));
    sized.web_rows       = count(cone.length(), has_fineness ? 6 : 2, 2.5);
    sized.hub_rows       = count(hub_radius - bore_radius, 1, 1.25);
    sized.hub_side_cells = count(.5 * (hub_length - web_thickness / std::sin(web_angle)), 1, 1.25);
    return sized;
  }
} // namespace vfife
