// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// The law of the mesh: from a loaded contact analysis, its energy, its inverse; series.
#include "../refusal.h"
#include "../tests.h"

#include <vfife/base/types.h>
#include <vfife/lumped/mesh_law.h>

using namespace vfife;

Table loaded_contact(const double second)
{
  Table table;
  for (const char *name : {"position",
                           "unloaded transmission error",
                           "transmission error",
                           "contact torque on the gear",
                           "tangent stiffness"})
    table.add_column(name, "-");
  table.add_row({0., 1., -80., 800., 2.3e6});
  table.add_row({second, -2., -82., 800., 2.2e6});
  table.add_row({2 * second, -1., -81.5, 800., 2.4e6});
  return table;
}

int main()
{
  const FourierSeries series = FourierSeries::interpolate({1., 4., -2., .5, 3.});
  check_close("series: sample", series.value(.4), -2., 1e-13);
  check_close("series: repeats", series.value(7.8), 3., 1e-12);
  check_close("series: mean", series.mean(), 1.3, 1e-14);
  check_close("series: slope",
              series.slope(.33),
              (series.value(.33 + 1e-5) - series.value(.33 - 1e-5)) / 2e-5,
              1e-6);
  check_close("series: even number", FourierSeries::interpolate({1., 3.}).value(.5), 3., 1e-14);

  const Table table = loaded_contact(1. / 3.);
  for (const LoadLaw kind : {LoadLaw::power, LoadLaw::tangent, LoadLaw::secant})
    {
      MeshLaw law  = MeshLaw::from_table(table, "table", kind);
      law.backlash = 3e-4;
      for (unsigned int i = 0; i < 3; ++i)
        {
          const double x = i / 3.;
          const double s =
            law.unloaded_error.value(x) - table.numbers("transmission error")[i] * arcsecond;
          check_ratio("torque of the table", law.torque(s, x) / 8e5, 1e-12);
          check_ratio("compression", law.compression(8e5, x) / s, 1e-12);
          if (kind != LoadLaw::secant)
            check_ratio("tangent of the table",
                        law.slope(s, x) / (1e3 * table.numbers("tangent stiffness")[i]),
                        1e-12);
          if (kind != LoadLaw::tangent)
            check_close("flanks touch where they do without load",
                        law.unloaded_error.value(x),
                        table.numbers("unloaded transmission error")[i] * arcsecond,
                        1e-16);
        }
      const double h = 1e-9;
      for (const double s : {2e-4, -1e-4, -5e-4})
        {
          // Central differences: 1e-18 of the energies' curvature.
          check_close("torque is the slope of the energy",
                      (law.energy(s + h, .1) - law.energy(s - h, .1)) / (2 * h) / 8e5,
                      law.torque(s, .1) / 8e5,
                      1e-6);
          check_close("energy over the position",
                      (law.energy(s, .1 + 1e-6) - law.energy(s, .1 - 1e-6)) / 2e-6,
                      law.energy_slope(s, .1),
                      1e-5);
        }
      check("no torque within the backlash",
            law.torque(-1e-4, .2) == 0 && law.slope(-1e-4, .2) == 0);
      check_close("coast flanks mirror drive flanks",
                  law.torque(-3e-4 - 1e-4, .2),
                  -law.torque(1e-4, .2),
                  1e-6);
    }
  check("unequal positions are refused",
        refuses([] { MeshLaw::from_table(loaded_contact(.3), "table", LoadLaw::power); }));
  return 0;
}
