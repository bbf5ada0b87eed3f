// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// Moments on bodies that move: an end face under a moment stays quiet however far it turns, and a
// ring that is spun up closes its energy ledger from the first sample on.
#include "../tests.h"
#include "quick_pair.h"

#include <vfife/base/process/mpi_session.h>
#include <vfife/base/types.h>

#include <algorithm>
#include <cmath>

using namespace vfife;

namespace
{
  /** A short cantilever that an end moment bends by 9 degrees, in equilibrium at the start: what
   * its end face then does by itself. */
  void bent_end(Communicator &world)
  {
    auto        run   = run_text("bent_end",
                        R"(
subsection Study
  set kind = run
end
subsection Model
  set bodies      = beam
  set constraints = clamp
  set loads       = end
  set probes      = corner
  subsection Body beam
    set mesh               = beam
    set length             = 10 mm
    set width              = 5 mm
    set height             = 2 mm
    set cells along length = 10
    set cells across width = 1
    set cells over height  = 2
  end
  subsection Constraint clamp
    set kind  = fixed
    set nodes = x-
  end
  subsection Load end
    set kind   = moment
    set nodes  = x+
    set moment = 0, -10786.1346, 0 N mm
  end
  subsection Probe corner
    set point = 10, 2.5, 1 mm
  end
end
subsection Material steel
  set Poisson's ratio = 0
end
subsection Dynamics
  set start    = static preload
  set end time = 4 ms
  subsection Relaxation
    set tolerance               = 1e-5
    set largest number of steps = 100000
  end
end
subsection Output
  set history every = 50
  set pictures      = no
  set verbosity     = quiet
end
)",
                        world);
    const auto &place = run["corner displacement z"];
    check("enough samples", place.size() > 100);
    // What the tolerance of the relaxation has left swings on, some 2e-4 of the way. A circulatory
    // load would have multiplied it by then: the end face with forces that turn node by node is
    // turned inside out after 2.9 ms.
    const auto swing = [&](const std::size_t first, const std::size_t last) {
      const auto [low, high] = std::minmax_element(place.begin() + first, place.begin() + last);
      return *high - *low;
    };
    const std::size_t n = place.size();
    check_below("bent end: swing of its corner over its way", swing(0, n) / place[0], 1e-3);
    check_close("bent end: swing in the last quarter over that in the first",
                swing(3 * n / 4, n) / swing(0, n / 4),
                1.,
                0.05);
  }

  /** A ring at rest on its axis under a moment about it: M = I alpha, E = M^2 t^2/(2 I). */
  void spin_up(Communicator &world)
  {
    auto run = run_text("spin_up",
                        R"(
subsection Study
  set kind = run
end
subsection Model
  set bodies = ring
  set loads  = drive
  subsection Body ring
    set mesh         = ring
    set inner radius = 20 mm
    set outer radius = 30 mm
    set height       = 5 mm
    set radial cells = 2
    set cells around = 24
    set axial cells  = 1
    set bearing      = yes
  end
  subsection Load drive
    set kind   = moment
    set nodes  = inner
    set moment = 0, 0, 1000 N mm
  end
end
subsection Dynamics
  set end time = 2 ms
end
subsection Output
  set history every = 20
  set pictures      = no
  set verbosity     = quiet
end
)",
                        world);
    // Sudden, so that the first samples hold what the start has left: second order in the step.
    double largest = 0;
    for (const double error : run["energy error"])
      largest = largest_of(largest, std::abs(error));
    check_below("spin-up: largest energy error", largest, 1e-2);
    check_below("spin-up: energy error at the end", run["energy error"].back(), 1e-5);
    // I = rho h pi (b^4 - a^4)/2 of the round ring; 24 cells make it smaller.
    const double t       = run["time"].back();
    const double inertia = 7.85e-9 * 5 * pi * (std::pow(30., 4) - std::pow(20., 4)) / 2;
    check_close("spin-up: kinetic energy over M^2 t^2/(2 I)",
                run["kinetic energy"].back() / (1e6 * t * t / (2 * inertia)),
                1.,
                0.05);
    check_close("spin-up: kinetic energy over the work of the load",
                run["kinetic energy"].back() / run["work of the loads"].back(),
                1.,
                1e-3);
  }
} // namespace

int main(int argc, char **argv)
{
  MpiSession session(argc, argv);
  bent_end(session.world());
  spin_up(session.world());
}
