// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// Moments on bodies that move: an end face under a moment stays quiet however far it turns, and a
// ring that is spun up closes its energy ledger from the first sample on.
#include "../../model_sections.h"
#include "../../parts.h"
#include "../quick_pair.h"

#include <vfife/base/types.h>

using namespace vfife;

std::string moment(const std::string &nodes, const std::string &value)
{
  return "subsection Load end\n set kind = moment\n set nodes = " + nodes +
         "\n set moment = " + value + " N mm\nend\n";
}

/** A short cantilever that an end moment bends by 9 degrees, in equilibrium at the start: what
 * its end face then does by itself. */
void bent_end(Communicator &world)
{
  auto run =
    run_text("bent_end",
             model_text::study("run") +
               "subsection Model\n set bodies = beam\n"
               " set constraints = clamp\n set loads = end\n set probes = corner\n" +
               model_text::block("beam", {{10, 5, 2}}, {{10, 1, 2}}) +
               model_text::section("Constraint clamp", "set nodes = x-\n") +
               moment("x+", "0, -10786.1346, 0") + model_text::probe("corner", "10, 5, 2 mm") +
               "end\n" + model_text::no_contraction() + R"(
subsection Dynamics
  set start    = static equilibrium
  set end time = 4 ms
  subsection Relaxation
    set tolerance               = 1e-5
    set maximum number of steps = 100000
  end
end
)" + quiet_output(50),
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
  check_ratio("bent end: swing in the last quarter over that in the first",
              swing(3 * n / 4, n) / swing(0, n / 4),
              0.05);
}

/** A ring at rest on its axis under a moment about it: M = I alpha, E = M^2 t^2/(2 I). */
void spin_up(Communicator &world)
{
  auto run =
    run_text("spin_up",
             model_text::study("run") +
               "subsection Model\n"
               " set bodies = ring\n set loads = end\n" +
               model_text::ring("ring", {{20, 30, 5}}, {{2, 24, 1}}, "set rotating = yes\n") +
               moment("inner", "0, 0, 1000") +
               "end\nsubsection Dynamics\n set end time = 2 ms\nend\n" + quiet_output(20),
             world);
  // Sudden, so that the first samples hold what the start has left: second order in the step.
  check_below("spin-up: largest energy error", largest_size(run["energy error"]), 1e-2);
  check_below("spin-up: energy error at the end", run["energy error"].back(), 1e-5);
  // I = rho h pi (b^4 - a^4)/2 of the round ring; 24 cells make it smaller.
  const double t       = run["time"].back();
  const double inertia = 7.85e-9 * 5 * pi * (std::pow(30., 4) - std::pow(20., 4)) / 2;
  check_ratio("spin-up: kinetic energy over M^2 t^2/(2 I)",
              run["kinetic energy"].back() / (1e6 * t * t / (2 * inertia)),
              0.05);
  check_ratio("spin-up: kinetic energy over the work of the load",
              run["kinetic energy"].back() / run["work of the loads"].back(),
              1e-3);
}

int main(int argc, char **argv)
{
  return run_parts(argc, argv, {bent_end, spin_up});
}
