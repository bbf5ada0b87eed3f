// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// Entries of sections Fem and Linear static that files hardly ever set, in models of a few
// elements.
#include "../tests.h"
#include "quick_pair.h"

#include <vfife/base/process/mpi_session.h>
#include <vfife/base/types.h>

#include <algorithm>

using namespace vfife;

namespace
{
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

  const std::string cantilever = R"(
  set bodies      = beam
  set constraints = clamp
  subsection Body beam
    set mesh               = beam
    set width              = 5 mm
    set cells along length = 20
    set cells across width = 1
  end
  subsection Constraint clamp
    set nodes = x-
  end
)";

  void solvers(Communicator &world)
  {
    const auto log_says = [](const std::string &words) {
      std::ifstream      file("modes/run.log");
      std::ostringstream text;
      text << file.rdbuf();
      return text.str().find(words) != std::string::npos;
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
            deviation =
              std::max(deviation,
                       std::abs(modes.numbers("frequency")[k] / reference.numbers("frequency")[k] -
                                1));
            residual = std::max(residual, modes.numbers("residual")[k]);
          }
        check_below("eigenvalue solver: frequencies by LOBPCG", deviation, 1e-9);
        if (fine)
          check_below("eigenvalue tolerance: a fine one", residual, 1e-8);
        else
          check("eigenvalue tolerance: a rough one", residual > 1e-6 && residual < 1e-3);
      }
  }

  /** A wheel whose hub turns freely or is held: its torsion, J1(ka) Y2(kb) = Y1(ka) J2(kb). */
  void hubs(Communicator &world)
  {
    const std::string wheel = R"(
  set bodies      = wheel
  set constraints = hub
  subsection Body wheel
    set mesh         = ring
    set inner radius = 20
    set outer radius = 40
    set height       = 30
    set radial cells = 8
    set cells around = 96
    set axial cells  = 2
  end
  subsection Constraint hub
    set kind  = free rotation
    set nodes = inner
  end
)";
    const std::string umbrella =
      "  set modes = 3\n  set cyclic symmetry = yes\n  set largest nodal diameter = 0\n";
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
    check_close("hold hubs: torsion of the wheel over the closed form",
                held.numbers("frequency")[0] / (low * shear_speed / (2 * pi)),
                1.,
                5e-3);
  }

  /** Waves of a ring split by 4 n/(n^2 + 1) Omega (Bryan 1890). */
  void coriolis(Communicator &world)
  {
    const std::string ring = R"(
  set bodies = ring
  subsection Body ring
    set mesh         = ring
    set inner radius = 49.5
    set outer radius = 50.5
    set height       = 4
    set radial cells = 1
    set cells around = 72
    set axial cells  = 1
  end
)";
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
    const std::string pulled = R"(
  set bodies      = bar
  set constraints = foot
  set loads       = pull
  set probes      = tip
  subsection Body bar
    set mesh               = beam
    set width              = 5 mm
    set cells along length = 40
    set cells across width = 6
    set cells over height  = 10
  end
  subsection Constraint foot
    set nodes = x-
  end
  subsection Load pull
    set nodes = x+
    set force = 1000, 0, 0
  end
  subsection Probe tip
    set point = 100, 0, 0
  end
)";
    const auto        solve  = [&](const std::string &solver) {
      return run_text("pulled",
                      study("linear static", pulled, "  set linear solver = " + solver) +
                        "subsection Output\n  set pictures = no\n  set fields every = 0\nend\n",
                      world)["tip displacement x"]
        .back();
    };
    const double exact = solve("direct\n");
    const double fine  = solve("multigrid\n  set linear tolerance = 1e-12\n"),
                 rough = solve("multigrid\n  set linear tolerance = 1e-2\n");
    check_close("linear tolerance: a fine one", fine / exact, 1., 1e-9);
    check_close("linear tolerance: a rough one", rough / exact, 1., 1e-2);
    check("linear tolerance: the rough one shows", std::abs(rough / exact - 1) > 1e-7);
  }

  /** A thin ring that turns grows by rho omega^2 r^3/E. */
  void centrifugal(Communicator &world)
  {
    const std::string spun = R"(
  set bodies      = ring
  set constraints = guide
  set probes      = rim
  subsection Body ring
    set mesh         = ring
    set inner radius = 99.5
    set outer radius = 100.5
    set height       = 2
    set radial cells = 1
    set cells around = 90
    set axial cells  = 1
    set bearing      = yes
    set speed        = 100 rad/s
  end
  subsection Constraint guide
    set kind       = displacement
    set directions = theta, z
    set nodes      = all
  end
  subsection Probe rim
    set point = 100.5, 0, 0
    set axes  = r, theta, z
  end
)";
    for (const bool is_on : {true, false})
      check_close(is_on ? "centrifugal: growth of a ring over that of a thin one"
                        : "not centrifugal: none",
                  run_text("spun",
                           study("linear static", spun, "") + "subsection Material steel\n" +
                             "  set Poisson's ratio = 0\nend\nsubsection Linear static\n" +
                             "  set centrifugal = " + (is_on ? "yes" : "no") +
                             "\nend\nsubsection Output\n  set pictures = no\nend\n",
                           world)["rim displacement r"]
                      .back() /
                    (7.85e-9 * 1e4 * 1e6 / 206000),
                  is_on ? 1. : 0.,
                  // chords of 4 degrees
                  is_on ? 5e-3 : 0.);
  }
} // namespace

int main(int argc, char **argv)
{
  MpiSession session(argc, argv);
  solvers(session.world());
  hubs(session.world());
  coriolis(session.world());
  linear_solver(session.world());
  centrifugal(session.world());
}
