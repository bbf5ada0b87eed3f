// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// Words of choices that files hardly ever set: each in a model of a few elements whose numbers tell
// it from its neighbours. contrib/check_entries asks for every word.
#include "../../model_sections.h"
#include "../../parts.h"
#include "../quick_pair.h"

#include <vfife/base/types.h>

using namespace vfife;

/** Contact force at the start of two bodies one of which lies in the other [N]. */
double press(const std::string &bodies, const std::string &contact, Communicator &world)
{
  const std::string text =
    "subsection Model\n  set bodies = over, under\n  set contacts = touch\n" + bodies +
    model_text::section("Contact touch", R"(
    set slave body        = over
    set slave surface     = x-
    set master body       = under
    set penalty           = 100
    set integration       = explicit
    set contact depth limit = 1 mm
    set abort penetration ratio = 1
    set edge fading       = 0
)" + contact) +
    "end\n";
  return run_text("pressed",
                  text + model_text::one_step() + quiet_output(1),
                  world)["contact force total"]
    .front();
}

/** A facet of 2 x 2 mm lies 10 um deep in a floor and 0.5 mm over its edge. */
void discretizations(Communicator &world)
{
  const std::string bodies =
    model_text::block("under", {{2, 20, 20}}, {{1, 10, 10}}) +
    model_text::block("over", {{2, 2, 2}}, {{1, 1, 1}}, "set position = 1.99, 8, 18.5 mm\n");
  const auto force = [&](const std::string &kind) {
    return press(bodies, "set master surface = x+\nset discretization = " + kind + "\n", world);
  };
  const double full = 100 * 0.01 * 4;
  // Gauss points at 0.225, 1 and 1.775 mm from the inner side, weights 5/18, 8/18, 5/18.
  check_close("surface points: two of three rows press",
              force("surface points"),
              full * 13 / 18,
              1e-9);
  check_close("nodes: two of four corners press", force("nodes"), full / 2, 1e-9);
}

/** The middle of a facet of a ring of 24, and a small block 10 um deep in it. */
void surfaces(Communicator &world)
{
  const double       half = pi / 24, middle = 30 * std::cos(half), depth = 0.01;
  std::ostringstream place;
  place.precision(17);
  place << "set position = " << middle - depth << ", -0.1, 1.9 mm\n";
  const std::string bodies =
    model_text::ring("under",
                     {{20, 30, 4}},
                     {{2, 24, 1}},
                     "set rotation axis = 0, 0, 1\nset rotation angle = -7.5 deg\n") +
    model_text::block("over", {{0.2, 0.2, 0.2}}, {{1, 1, 1}}, place.str());
  const auto force = [&](const std::string &kind) {
    return press(bodies, "set master surface = outer\nset surface = " + kind + "\n", world);
  };
  const double by_depth = 100 * 0.04;
  // Along normals that lean by up to 0.1/30 within the block.
  check_ratio("flat facets: the chord [N]", force("flat facets") / (by_depth * depth), 1e-5);
  check_ratio("true flank of a ring's mesh, which has no offsets: the chord [N]",
              force("true flank") / (by_depth * depth),
              1e-5);
  // The parabola that is normal to the radii at both ends rises by r sin(a) tan(a)/2, the circle
  // by r (1 - cos(a)), 0.4 % less; both fall away by y^2/(2 r) towards the block's sides.
  const double rise = 30 * std::sin(half) * std::tan(half) / 2 - 0.01 / 3 / 60;
  check_ratio("smooth patches: the arc [N]",
              force("smooth patches") / (by_depth * (depth + rise)),
              1e-3);
}

/** A cube of one cell on springs that act on all nodes alike. */
std::string cube(const std::string &start)
{
  return R"(
subsection Model
  set bodies      = cube
  set constraints = springs
  set loads       = weight
  set probes      = corner
)" + model_text::block("cube", {{5, 5, 5}}, {{1, 1, 1}}) +
         R"(
  subsection Constraint springs
    set kind      = spring
    set nodes     = all
    set stiffness = 1000, 1000, 1000 N/mm
  end
  subsection Load weight
    set kind         = acceleration
    set nodes        = all
    set acceleration = 0, -1e6, 0 mm/s^2
  end
)" + model_text::probe("corner", "0, 0, 0 mm") +
         "end\n" +
         model_text::relaxation("1e-9", "set start = " + start + "\nset end time = 0.5 ms\n");
}

void starts(Communicator &world)
{
  const double mass = 125 * 7.85e-9, omega = std::sqrt(1000 / mass), sag = 1e6 * mass / 1000;
  for (const std::string &start : {std::string("undeformed"), std::string("static equilibrium")})
    {
      auto        h     = run_text("cube", cube(start) + quiet_output(10), world);
      const auto &way   = h["corner displacement y"];
      double      error = 0;
      for (std::size_t i = 0; i < way.size(); ++i)
        {
          const double swing = start == "undeformed" ? std::cos(omega * h["time"][i]) : 0.;
          raise_to(error, std::abs(way[i] + sag * (1 - swing)) / sag);
        }
      // Central differences are faster by (omega dt)^2/24, 4e-5 of 16 rad; a run that starts out
      // of balance is half a step ahead (doc/theory/dynamics.md).
      const double ahead = start == "undeformed" ? omega * (h["time"][1] - h["time"][0]) / 20 : 0.;
      check_below("start " + start + ": way over the sag, less the closed form",
                  error,
                  ahead + 1e-3);
    }
}

/** A cantilever of 10 x 2 x 2 cells under a moment, nu = 0. */
void elements(Communicator &world)
{
  for (const bool full : {true, false})
    {
      auto h =
        run_text("bent",
                 model_text::study("linear static") + R"(
subsection Model
  set bodies      = bar
  set constraints = foot
  set loads       = bend
  set probes      = tip, top
)" + model_text::block("bar", {{100, 10, 10}}, {{10, 2, 2}}) +
                   model_text::section("Constraint foot", "set nodes = x-\n") +
                   model_text::section("Load bend",
                                       "set nodes = x+\nset kind = moment\n"
                                       "set moment = 0, -20000, 0 N mm\n") +
                   model_text::probe("tip", "100, 5, 5 mm") +
                   model_text::probe("top", "50, 5, 10 mm") + "end\n" +
                   model_text::no_contraction() + "subsection Fem\n  set element type = " +
                   (full ? "full integration" : "incompatible modes") + "\nend\n" + quiet_output(),
                 world);
      // Trilinear cells of length a cannot follow the parabola: their shear is -kappa x from the
      // middle on, which stiffens E I by G A a^2/12 = E A a^2/24.
      const double      E = 206000, I = 1e4 / 12, stiffer = full ? 1 + 100 * 100 / 24. / I : 1.;
      const std::string name = full ? "full: " : "incompatible modes: ";
      check_close(name + "deflection over M L^2/(2 E I)",
                  h["tip displacement z"].back() / (20000. * 1e4 / (2 * E * I)),
                  1 / stiffer,
                  1e-8);
      check_close(name + "stress over M z/I",
                  h["top stress x"].back() / (-20000. * 5 / I),
                  1 / stiffer,
                  1e-8);
    }
}

/** What the screen says of a static case. */
std::string screen_of(const std::string &verbosity, Communicator &world)
{
  std::ofstream("said.prm") << model_text::study("static")
                            << "subsection Model\n  set bodies = bar\n  set constraints = foot\n"
                            << "  set loads = pull\n"
                            << model_text::block("bar", {{100, 5, 5}}, {{20, 1, 1}})
                            << model_text::section("Constraint foot", "set nodes = x-\n")
                            << model_text::section("Load pull",
                                                   "set nodes = x+\nset force = 0, 0, 1 N\n")
                            << "end\n"
                            << model_text::relaxation("1e-9")
                            << "subsection Output\n  set report = no\n  set verbosity = "
                            << verbosity << "\nend\n";
  CommandLine line;
  line.parameter_file = "said.prm";
  line.output_folder  = "said";
  std::ostringstream screen;
  Log                log(screen, true, Verbosity::normal);
  run_study(line, world, log);
  return screen.str();
}

void verbosities(Communicator &world)
{
  const std::string quiet = screen_of("quiet", world), normal = screen_of("normal", world),
                    detailed = screen_of("detailed", world);
  check("quiet: nothing of the bodies", !has_text(quiet, "20 elements"));
  check("normal: the bodies, no steps of the relaxation",
        has_text(normal, "20 elements") && !has_text(normal, "relaxation step "));
  check("detailed: both",
        has_text(detailed, "20 elements") && has_text(detailed, "relaxation step "));
}

int main(int argc, char **argv)
{
  return run_parts(argc, argv, {discretizations, surfaces, starts, elements, verbosities});
}
