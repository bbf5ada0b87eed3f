// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// How far a swinging pair departs from its static curve: closed form of one and two modes, choice
// of the modes.
#include "../../tests.h"

#include <vfife/base/types.h>
#include <vfife/study/compare/pair/quasi_static.h>

using namespace vfife;

/** Modes of 1000 Hz (all of the turn) and 4000 Hz (a hundredth of it). */
Table make_modes(const std::string &axes)
{
  Table table;
  table.add_text_column("axes");
  table.add_column("frequency", "Hz");
  table.add_column("share of the static rotation", "-");
  table.add_row({axes, 1000., 1.});
  table.add_row({axes, 4000., .01});
  return table;
}

/** -80 + 3 cos(2 pi p + 1) + cos(4 pi p - 2) at n places of a mesh cycle. */
double estimate(const unsigned int n, const double mesh_frequency, const double least_share)
{
  std::vector<double> curve;
  for (unsigned int i = 0; i < n; ++i)
    {
      const double p = static_cast<double>(i) / n;
      curve.push_back(-80. + 3. * std::cos(2 * pi * p + 1.) + std::cos(4 * pi * p - 2.));
    }
  return estimate_swing(curve, mesh_frequency, TurningModes(make_modes("fixed"), least_share));
}

/** r^2/(1 - r^2) of a mode. */
double added(const double r)
{
  return r * r / (1. - r * r);
}

int main()
{
  // Both harmonics below the mode.
  check_close("one mode", estimate(16, 250., .02), 3. * added(.25) + added(.5), 1e-12);
  check_close("two modes",
              estimate(16, 250., 0.),
              3. * (added(.25) + .01 * added(.0625)) + added(.5) + .01 * added(.125),
              1e-12);
  check("slow: nothing is added", estimate(16, 1., .02) < 1e-5);
  check("the second harmonic near the mode counts", estimate(16, 499., .02) > 100.);

  Table both = make_modes("fixed");
  both.add_row({std::string("rotating"), 900., .5});
  check("modes standing in space are taken where there are such",
        TurningModes(both, .02).frequencies == std::vector<double>{1000.});
  check("else those in turning axes",
        TurningModes(make_modes("rotating"), .02).frequencies == std::vector<double>{1000.});
  return 0;
}
