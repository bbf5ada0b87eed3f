// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/text/column_names.h>
#include <vfife/model/load.h>
#include <vfife/output/measures/bearing_columns.h>

namespace vfife
{
  namespace
  {
    constexpr double arcminute = 60 * arcsecond;
  }

  SampleColumns<BearingSample> list_bearing_columns()
  {
    using Of = const BearingSample &;
    SampleColumns<BearingSample> columns;
    columns.add_text(column::bearing, [](Of of) { return of.bearing; });
    for (unsigned int c = 0; c < 3; ++c)
      columns.add(std::string("force ") + column::fixed_axes[c], "N", [c](Of of) {
        return of.state.load[c];
      });
    for (unsigned int c = 0; c < 2; ++c)
      columns.add(std::string("moment ") + column::fixed_axes[c], "N m", [c](Of of) {
        return 1e-3 * of.state.load[3 + c];
      });
    for (unsigned int c = 0; c < 3; ++c)
      columns.add(column::displacements(column::fixed_axes)[c], "um", [c](Of of) {
        return 1e3 * of.state.displacement[c];
      });
    for (unsigned int c = 0; c < 2; ++c)
      columns.add(std::string("tilt ") + column::fixed_axes[c], "arcmin", [c](Of of) {
        return of.state.displacement[3 + c] / arcminute;
      });
    columns.add("radial force", "N", [](Of of) { return of.state.load.head<2>().norm(); });
    columns.add("radial displacement", "um", [](Of of) {
      return 1e3 * of.state.displacement.head<2>().norm();
    });
    return columns;
  }

  Table make_bearing_curves(const std::vector<Bearing> &bearings)
  {
    /** Points on either side of the undisplaced bearing. */
    constexpr int n = 20;
    Table         table;
    table.add_text_column(column::bearing);
    table.add_text_column(column::direction);
    table.add_column(column::displacement, "um");
    table.add_column(column::force, "N");
    table.add_column("stiffness", "N/um");
    for (const Bearing &bearing : bearings)
      if (const double range = bearing.law->curve_range(); range > 0)
        for (const unsigned int c : {0u, 2u})
          for (int i = -n; i <= n; ++i)
            {
              const double          way      = range * i / n;
              const BearingResponse response = bearing.law->evaluate(way * Vector5::Unit(c));
              table.add_row({bearing.name,
                             c == 0 ? "radial" : "axial",
                             1e3 * way,
                             -response.load[c],
                             1e-3 * response.stiffness(c, c)});
            }
    return table;
  }

  SampleColumns<Mounting> list_mounting_columns()
  {
    SampleColumns<Mounting> columns;
    const auto              names = list_numbers(Mounting());
    for (std::size_t k = 0; k < names.size(); ++k)
      columns.add(names[k].name, names[k].unit, [k](const Mounting &of) {
        return list_numbers(of)[k].value;
      });
    return columns;
  }
} // namespace vfife
