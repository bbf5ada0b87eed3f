// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// Entries of sections Fem and Linear static that files hardly ever set, in models of a few
// elements.
#include "../../model_sections.h"
#include "../../parts.h"
#include "../../read_files.h"
#include "../../refusal.h"
#include "../quick_pair.h"

#include <vfife/base/types.h>

using namespace vfife;

std::string study(const std::string &kind, const std::string &model, const std::string &fem)
{
  return "subsection Study\n  set kind = " + kind + "\nend\nsubsection Model\n" + model +
         "end\nsubsection Fem\n" + fem + "end\n";
}

/** modes.csv of a body. */
Table find_modes(const std::string &model, const std::string &fem, Communicator &world)
{
  std::ofstream("modes.prm") << study("modal", model, fem);
  run_pair("modes.prm", "modes", world);
  return read_result_table("modes/modes.csv");
}

/** A beam of 5 mm width, clamped at x-, with entries of its mesh. */
std::string clamped_beam(const std::string &cells)
{
  return "set bodies = beam\nset constraints = clamp\n" +
         model_text::section("Body beam", "set mesh = beam\nset width = 5 mm\n" + cells) +
         model_text::section("Constraint clamp", "set nodes = x-\n");
}

const std::string cantilever =
  clamped_beam("set elements along length = 20\nset elements across width = 1\n");

void solvers(Communicator &world)
{
  const auto log_says = [](const std::string &words) {
    return has_text(read_text("modes/run.log"), words);
  };
  const std::string four      = "  set modes = 4\n";
  const Table       reference = find_modes(cantilever, four, world);
  check("count modes: by a second factorization", log_says("counted by factorization"));
  const Table uncounted = find_modes(cantilever, four + "  set count modes = no\n", world);
  check("count modes: not, the same frequencies",
        log_says("not counted") &&
          uncounted.numbers("frequency") == reference.numbers("frequency"));

  // The frequency is as exact as the square of the residual.
  const std::string lobpcg = four + "  set eigenvalue solver = lobpcg\n";
  for (const bool fine : {false, true})
    {
      const Table modes =
        find_modes(cantilever,
                   lobpcg + "  set eigenvalue tolerance = " + (fine ? "1e-11\n" : "1e-5\n"),
                   world);
      double deviation = 0, residual = 0;
      for (unsigned int k = 0; k < 4; ++k)
        {
          raise_to(deviation,
                   std::abs(modes.numbers("frequency")[k] / reference.numbers("frequency")[k] - 1));
          raise_to(residual, modes.numbers("residual")[k]);
        }
      check_below("eigenvalue solver: frequencies by LOBPCG", deviation, 1e-9);
      if (fine)
        check_below("eigenvalue tolerance: a fine one", residual, 1e-8);
      else
        check("eigenvalue tolerance: a rough one", residual > 1e-6 && residual < 1e-3);
    }
}

void loose_tolerance(Communicator &world)
{
  // Shift and factorization are far better than what they are asked for.
  const std::string loose = "  set modes = 4\n  set eigenvalue tolerance = 1e-4\n";
  check("eigenvalue tolerance: a loose one for shift-invert",
        find_modes(cantilever, loose, world).numbers("residual")[3] < 1e-3);
  check("eigenvalue tolerance: a loose one is refused for LOBPCG",
        has_text(message_of([&] {
                   find_modes(cantilever, loose + "  set eigenvalue solver = lobpcg\n", world);
                 }),
                 "must be at most 1e-5 with \"lobpcg\""));
}

/** A wheel whose hub turns freely or is held: its torsion, J1(ka) Y2(kb) = Y1(ka) J2(kb). */
void hubs(Communicator &world)
{
  const std::string wheel =
    "set bodies = wheel\nset constraints = hub\n" +
    model_text::ring("wheel", {{20, 40, 30}}, {{8, 96, 2}}) +
    model_text::section("Constraint hub", "set kind = free rotation\nset nodes = inner\n");
  const std::string umbrella =
    "  set modes = 3\n  set cyclic symmetry = yes\n  set maximum nodal diameter = 0\n";
  const double a = 20, b = 40, shear_speed = std::sqrt(206000 / (2 * 1.29) / 7.85e-9);
  const auto   remainder = [=](const double k) {
    return std::cyl_bessel_j(1, k * a) * std::cyl_neumann(2, k * b) -
           std::cyl_neumann(1, k * a) * std::cyl_bessel_j(2, k * b);
  };
  double low = .02, high = .1;
  while (high - low > 1e-12)
    {
      const double middle                                   = (low + high) / 2;
      (remainder(middle) * remainder(low) > 0 ? low : high) = middle;
    }
  const Table free = find_modes(wheel, umbrella, world);
  check("hold hubs: a free one turns at 0 Hz", free.numbers("frequency")[0] < 1.);
  const Table held = find_modes(wheel, umbrella + "  set hold hubs = yes\n", world);
  // 8 linear elements over a quarter of a wave
  check_ratio("hold hubs: torsion of the wheel over the closed form",
              held.numbers("frequency")[0] / (low * shear_speed / (2 * pi)),
              5e-3);
}

/** Waves of a ring split by 4 n/(n^2 + 1) Omega (Bryan 1890). */
void coriolis(Communicator &world)
{
  const std::string ring =
    "set bodies = ring\n" + model_text::ring("ring", {{49.5, 50.5, 4}}, {{1, 72, 1}});
  for (const bool is_on : {false, true})
    {
      const Table modes =
        find_modes(ring,
                   std::string("  set modes = 10\n  set speeds = 600 rpm\n  set coriolis = ") +
                     (is_on ? "yes\n" : "no\n"),
                   world);
      std::vector<double> waves;
      for (std::size_t i = 0; i < modes.n_rows(); ++i)
        if (modes.numbers("nodal diameter")[i] == 2 && modes.numbers("axial")[i] < .1 &&
            modes.numbers("frequency")[i] > 100)
          waves.push_back(modes.numbers("frequency")[i]);
      check("coriolis: two waves", waves.size() == 2);
      check_close(is_on ? "coriolis: split over the speed" : "no coriolis: none",
                  std::abs(waves.at(1) - waves.at(0)) / 10,
                  is_on ? 1.6 : 0.,
                  5e-3);
    }
}

/** 1000 N pull a bar, whose 9,471 displacements multigrid does not solve at once. */
void linear_solver(Communicator &world)
{
  const std::string pulled =
    clamped_beam("set elements along length = 40\nset elements across width = 6\nset cells over "
                 "height = 10\n") +
    "set loads = pull\nset probes = tip\n" +
    model_text::section("Load pull", "set nodes = x+\nset force = 1000, 0, 0\n") +
    model_text::probe("tip", "100, 0, 0");
  const auto solve = [&](const std::string &solver) {
    return run_text(
             "pulled",
             study("linear static", pulled, "  set linear solver = " + solver) +
               "subsection Output\n  set report = no\n  set field output interval = 0\nend\n",
             world)["tip displacement x"]
      .back();
  };
  const double exact = solve("direct\n");
  const double fine  = solve("multigrid\n  set linear tolerance = 1e-12\n"),
               rough = solve("multigrid\n  set linear tolerance = 1e-2\n");
  check_ratio("linear tolerance: a fine one", fine / exact, 1e-9);
  check_ratio("linear tolerance: a rough one", rough / exact, 1e-2);
  check("linear tolerance: the rough one shows", std::abs(rough / exact - 1) > 1e-7);
}

/** A thin ring that turns grows by rho omega^2 r^3/E. */
void centrifugal(Communicator &world)
{
  const std::string spun =
    "set bodies = ring\nset constraints = guide\nset probes = rim\n" +
    model_text::ring("ring",
                     {{99.5, 100.5, 2}},
                     {{1, 90, 1}},
                     "set rotating = yes\nset rotational speed = 100 rad/s\n") +
    model_text::section("Constraint guide",
                        "set kind = displacement\nset directions = theta, z\n"
                        "set nodes = all\n") +
    model_text::probe("rim", "100.5, 0, 0", "r, theta, z");
  for (const bool is_on : {true, false})
    check_close(is_on ? "centrifugal: growth of a ring over that of a thin one"
                      : "not centrifugal: none",
                run_text("spun",
                         study("linear static", spun, "") + "subsection Material steel\n" +
                           "  set Poisson's ratio = 0\nend\nsubsection Linear static\n" +
                           "  set centrifugal = " + (is_on ? "yes" : "no") +
                           "\nend\nsubsection Output\n  set report = no\nend\n",
                         world)["rim displacement r"]
                    .back() /
                  (7.85e-9 * 1e4 * 1e6 / 206000),
                is_on ? 1. : 0.,
                // chords of 4 degrees
                is_on ? 5e-3 : 0.);
}

int main(int argc, char **argv)
{
  run_parts(argc, argv, {solvers, loose_tolerance, hubs, coriolis, linear_solver, centrifugal});
  return 0;
}
