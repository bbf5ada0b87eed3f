// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// The nearest resonance to a speed: weak ones nearby do not count.
#include "../parts.h"

#include <vfife/reduced/resonance/nearest_wave.h>

using namespace vfife;

/** With the square of its amplitude at resonance, and a pole of 1 rad/s beside the real axis. */
ContactMeeting meeting(const double rate, const double strength)
{
  ContactMeeting found;
  found.rate   = {rate, 1.};
  found.energy = strength;
  return found;
}

double find(const std::vector<ContactMeeting> &meetings)
{
  // The driver turns three times as fast, at 3000 rad/s.
  const auto found = find_nearest_wave(meetings, 1. / 3., 3000.);
  return found ? found->speed : 0.;
}

void nearest()
{
  check("no resonances", !find_nearest_wave({}, 1. / 3., 3000.));
  check_close("nearest of equal ones",
              find({meeting(950, 1), meeting(1020, 1), meeting(1060, 1)}),
              3060,
              1e-9);
  check_close("a twentieth of the amplitude does not count",
              find({meeting(950, 1), meeting(1001, 1. / 400)}),
              2850,
              1e-9);
  check_close("a ninth does", find({meeting(950, 1), meeting(1001, 1. / 81)}), 3003, 1e-9);
  check_close("a strong one is far away", find({meeting(1300, 1e6), meeting(1050, 1)}), 3150, 1e-9);
  check_close("none within 10 %", find({meeting(700, 1e-6), meeting(1300, 1)}), 3900, 1e-9);
  // Half the decay is twice the amplitude.
  ContactMeeting sharp = meeting(1001, 1. / 400);
  sharp.rate           = {1001, 1. / 20};
  check_close("weak forces, little damping", find({meeting(950, 1), sharp}), 3003, 1e-9);
  // A third of the amplitude has the same kinetic energy at three times the frequency.
  ContactMeeting third = meeting(1001, 1. / 49);
  third.mesh_order     = 3;
  check_close("a seventh of the velocity at order 3", find({meeting(950, 1), third}), 2850, 1e-9);
}

int main()
{
  return run_parts({nearest});
}
