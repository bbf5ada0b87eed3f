// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/mesh/gear/gear_body_sizes.h>

#include <algorithm>
#include <cmath>

namespace vfife
{
  namespace
  {
    /** Length along the axis that the web takes on the hub with its fillets; 0 without a web [mm].
     */
    double foot_on_hub(const GearBodyOptions &options, const BlankOutline &blank)
    {
      // What no web can be is refused later.
      if (options.web != WebKind::conical || !(options.web_thickness > 0.) ||
          !(options.web_angle > 0.) || !(options.hub_radius > 0.))
        return 0.;
      return ConicalWeb(blank, options).foot_on_hub();
    }
  } // namespace

  GearBodyOptions with_open_sizes(GearBodyOptions options, const BlankOutline &blank)
  {
    const auto fill = [](double &size, const double proposed) {
      if (size == 0.)
        size = std::round(10. * proposed) / 10.;
    };
    const double inner  = blank.inner_cone_distance();
    const double root   = blank.meridian_point({inner, -blank.dedendum(inner)})[0];
    const double module = blank.outer_module();
    if (options.web_direction == WebDirection::fitting)
      {
        options.web_direction = WebDirection::back;
        if (!ConicalWeb::leaves_wall(blank, options))
          options.web_direction = WebDirection::apex;
      }
    // The rim of a small gear leaves a third of the root's radius to web, hub and bore: the web
    // must start outside the hub.
    const double size = std::min(module, 0.34 / 2.7 * root / std::cos(blank.pitch_angle));
    fill(options.web_thickness, 1.587 * size);
    fill(options.rim_thickness, 2.7 * size);
    fill(options.hub_radius, 0.632 * root);
    fill(options.bore_radius,
         options.web == WebKind::solid ? 0.64 * root : options.hub_radius * 5. / 6.);
    fill(options.hub_length, std::max(0.379 * root, 1.2 * foot_on_hub(options, blank)));
    if (options.element_size == 0.)
      {
        options.element_size = options.edge_in_modules * module;
        options.has_fineness = options.edge_in_modules > 0.;
      }
    return options;
  }

  GearBodyOptions with_counts_of_size(GearBodyOptions options, const GearGeometry &gear)
  {
    const double size = options.element_size;
    if (size == 0.)
      return options;
    // Of a fineness the edges differ by what they change of the transmission error per element: the
    // root bends over few flank rows, a rim without a web below it over few of its rows, and the
    // layers of a web do little.
    const auto count = [&](const double length, const unsigned int least, const double factor) {
      const double edge = options.has_fineness ? factor * size : size;
      return std::max<unsigned int>(least, std::lround(length / edge));
    };
    const BlankOutline &blank  = gear.blank();
    const double        L      = blank.mean_cone_distance;
    const bool          on_web = options.web == WebKind::conical;
    options.element_size       = 0.;

    // teeth at mid-face, then what lies under them, down to bore, underside or hub
    options.cells_lengthwise = count(blank.face_width, 1, on_web ? 1.25 : 1.);
    options.cells_across     = count(gear.tooth_thickness(L, 0.), 2, 1.25);
    options.flank_rows       = count(blank.flank_tip(L) + blank.dedendum(L), 1, .9);
    if (options.web == WebKind::solid)
      {
        const double root = blank.meridian_point({L, -blank.dedendum(L)})[0];
        options.rim_rows =
          count((root - options.bore_radius) / std::cos(blank.pitch_angle), 1, 1.25);
        return options;
      }
    options.rim_rows = count(options.rim_thickness, 1, on_web ? 1. : .8);
    if (!on_web)
      return options;
    // 2, 5, 8 ... cells across let the web be coarser than the teeth.
    options.cells_across = std::max(2u, (options.cells_across + 2) / 3 * 3 - 1);
    options.web_layers   = count(options.web_thickness, options.has_fineness ? 2 : 1, 1.5);
    unsigned int &rows =
      options.web_attachment == WebAttachment::toe ? options.rim_rows : options.cells_lengthwise;
    rows = std::max(rows, options.web_layers + 2);
    options.web_rows =
      count(ConicalWeb(blank, options).length(), options.has_fineness ? 6 : 2, 2.5);
    options.hub_rows = count(options.hub_radius - options.bore_radius, 1, 1.25);
    options.hub_side_cells =
      count(.5 * (options.hub_length - options.web_thickness / std::sin(options.web_angle)),
            1,
            1.25);
    return options;
  }
} // namespace vfife
