// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/text/column_names.h>
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
} // namespace vfife
