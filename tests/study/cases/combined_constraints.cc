// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// A quarter of a ring with its planes of symmetry, whose corners are held along x or y and led in
// radius at once: against Lame's thick ring and against the whole ring, by all solvers.
#include "../../refusal.h"
#include "../quick_pair.h"

#include <vfife/base/process/mpi_session.h>
#include <vfife/base/types.h>

using namespace vfife;

constexpr double       inner = 50, outer = 80, height = 5, grown = 0.01, poisson = 0.29;
constexpr unsigned int n_radial = 6, n_around = 12; // in a quarter

/** Writes the mesh of the quarter with the cells of the whole ring: sets INNER, X0, Y0, FRONT. */
void write_quarter(const std::string &file)
{
  std::ofstream out(file);
  out.precision(17);
  std::map<std::string, std::string> sets;
  const auto number = [](const unsigned int i, const unsigned int j, const unsigned int k) {
    return 1 + k + 2 * (j + (n_around + 1) * i);
  };
  out << "*NODE\n";
  for (unsigned int i = 0; i <= n_radial; ++i)
    for (unsigned int j = 0; j <= n_around; ++j)
      for (unsigned int k = 0; k < 2; ++k)
        {
          const double radius = inner + (outer - inner) * i / n_radial,
                       angle  = pi / 2 * j / n_around;
          const auto node     = std::to_string(number(i, j, k));
          out << node << ", " << radius * std::cos(angle) << ", " << radius * std::sin(angle)
              << ", " << k * height << "\n";
          if (i == 0)
            sets["INNER"] += node + ",\n";
          if (j == 0)
            sets["Y0"] += node + ",\n";
          if (j == n_around)
            sets["X0"] += node + ",\n";
          if (k == 0)
            sets["FRONT"] += node + ",\n";
        }
  out << "*ELEMENT, TYPE=C3D8, ELSET=BODY\n";
  unsigned int e = 0;
  for (unsigned int i = 0; i < n_radial; ++i)
    for (unsigned int j = 0; j < n_around; ++j)
      {
        out << ++e;
        for (unsigned int k = 0; k < 2; ++k)
          out << ", " << number(i, j, k) << ", " << number(i + 1, j, k) << ", "
              << number(i + 1, j + 1, k) << ", " << number(i, j + 1, k);
        out << "\n";
      }
  for (const auto &[name, nodes] : sets)
    out << "*NSET, NSET=" << name << "\n" << nodes;
}

std::string hold(const std::string &name,
                 const std::string &nodes,
                 const std::string &directions,
                 const std::string &more = "")
{
  return "  subsection Constraint " + name +
         "\n    set kind = displacement\n    set nodes = " + nodes +
         "\n    set directions = " + directions + "\n" + more + "  end\n";
}

const std::string led = "    set displacement = 0.01, 0, 0 mm\n";

/** @p more: names of more constraints (", again") and their sections. */
std::string quarter(const std::string &radius, const std::string &names, const std::string &more)
{
  return "subsection Model\n  set bodies = ring\n  set constraints = radius, x plane, y plane, "
         "z plane" +
         names + "\n  set probes = ax, ay\n" +
         "  subsection Body ring\n    set mesh = file\n    set file = quarter.inp\n  end\n" +
         hold("radius", "INNER", "r", radius) + hold("x plane", "X0", "x") +
         hold("y plane", "Y0", "y") + hold("z plane", "FRONT", "z") + more +
         "  subsection Probe ax\n    set point = 80, 0, 0 mm\n  end\n"
         "  subsection Probe ay\n    set point = 0, 80, 0 mm\n  end\nend\n";
}

/** The ring is held in y at one diameter: there is no other rigid motion than its turn. */
std::string whole(const std::string &radius)
{
  return "subsection Model\n  set bodies = ring\n  set constraints = radius, turn, z plane\n"
         "  set probes = ax, ay\n"
         "  subsection Body ring\n    set mesh = ring\n    set inner radius = 50 mm\n"
         "    set outer radius = 80 mm\n    set height = 5 mm\n    set radial elements = 6\n"
         "    set elements around = 48\n    set axial elements = 1\n  end\n" +
         hold("radius", "inner", "r", radius) +
         hold("turn", "all", "y", "    set where = abs(y) < 1e-6 && abs(x) > 79.9\n") +
         hold("z plane", "bottom", "z") +
         "  subsection Probe ax\n    set point = 80, 0, 0 mm\n  end\n"
         "  subsection Probe ay\n    set point = 0, 80, 0 mm\n  end\nend\n";
}

std::string study(const std::string &kind)
{
  return "subsection Study\n  set kind = " + kind +
         "\nend\nsubsection Output\n  set verbosity = quiet\n  set report = no\nend\n";
}

const std::string relaxed = "  subsection Relaxation\n    set tolerance = 1e-9\n  end\n";
const std::string preload = "subsection Dynamics\n  set start = static equilibrium\n"
                            "  set end time = 20 us\n" +
                            relaxed + "end\n";

/** Growth outside on both planes against Lame's in plane stress, and against the whole ring. */
void widened(const std::string &kind,
             const std::string &more,
             const double       of_ring,
             Communicator      &world)
{
  // u = (1 - nu) A r + (1 + nu) B/r, sigma_r(b) = 0: B = A b^2.
  const double lame =
    grown * 2 * outer / ((1 - poisson) * inner + (1 + poisson) * outer * outer / inner);
  auto one   = run_text("quarter", study(kind) + more + quarter(led, "", ""), world);
  auto other = run_text("whole", study(kind) + more + whole(led), world);
  for (const std::string probe : {"ax displacement x", "ay displacement y"})
    {
      // Chords of 7.5 degrees, six cells.
      check_ratio(kind + ": growth outside over Lame's, " + probe, one[probe].back() / lame, 5e-3);
      check_ratio(kind + ": over that of the whole ring, " + probe,
                  one[probe].back() / other[probe].back(),
                  of_ring);
    }
  check_below(kind + ": held on its planes [mm]",
              std::abs(one["ax displacement y"].back()) + std::abs(one["ay displacement x"].back()),
              1e-14);
}

/** Widened suddenly from rest, waves and all. */
void shaken(Communicator &world)
{
  const std::string history = led + "    set history = 1 - cos(2e5*t)\n";
  const std::string more    = "subsection Dynamics\n  set end time = 50 us\nend\nsubsection "
                              "Output\n  set steps per sample = 1\nend\n";
  auto   one     = run_text("quarter", study("run") + more + quarter(history, "", ""), world);
  auto   other   = run_text("whole", study("run") + more + whole(history), world);
  double largest = 0, difference = 0;
  for (const std::string probe : {"ax displacement x", "ay displacement y"})
    for (std::size_t i = 0; i < one[probe].size(); ++i)
      {
        raise_to(largest, std::abs(other[probe][i]));
        raise_to(difference, std::abs(one[probe][i] - other[probe].at(i)));
      }
  check("run: the ring swings beyond its static growth", largest > grown);
  check_below("run: quarter less whole ring over the largest displacement",
              difference / largest,
              1e-9);
  check_ratio("run: work of the drive, four times over that of the whole ring",
              4 * one["work of the drive"].back() / other["work of the drive"].back(),
              1e-8);
}

/** Every mode of the quarter is one of the whole ring. */
void modes(Communicator &world)
{
  const auto frequencies = [&world](const std::string &name, const std::string &text) {
    std::ofstream(name + ".prm") << text;
    run_pair(name + ".prm", name, world);
    return read_columns(name + "/modes.csv").at("frequency");
  };
  const std::string modal =
    "subsection Study\n  set kind = modal\nend\nsubsection Fem\n  set modes = ";
  const auto one   = frequencies("quarter", modal + "6\nend\n" + quarter("", "", ""));
  const auto other = frequencies("whole", modal + "30\nend\n" + whole(""));
  double     worst = 0;
  for (const double frequency : one)
    {
      double nearest = 1;
      for (const double of_ring : other)
        nearest = std::min(nearest, std::abs(of_ring / frequency - 1));
      raise_to(worst, nearest);
    }
  check("modes of the quarter", one.size() == 6);
  check_below("modes: the quarter's among the whole ring's, relative", worst, 1e-7);
}

void refused(const std::string &kind, const std::string &text, Communicator &world)
{
  std::cout << kind << ": ";
  print_refusal([&] { run_text("refused", study(kind) + text, world); });
}

void agreement(Communicator &world)
{
  // The same direction at the same value is one; radius and y of the corner on x = 0 as well.
  auto once  = run_text("once", study("linear static") + quarter(led, "", ""), world);
  auto twice = run_text(
    "twice",
    study("linear static") +
      quarter(led,
              ", again, corner",
              hold("again", "X0", "x") +
                hold("corner",
                     "X0",
                     "y",
                     "    set where = abs(y - 50) < 1e-6\n    set displacement = 0, 0.01, 0 mm\n")),
    world);
  check_below("the same direction twice: displacement less that of once [mm]",
              std::abs(twice["ax displacement x"].back() - once["ax displacement x"].back()) +
                std::abs(twice["ay displacement y"].back() - once["ay displacement y"].back()),
              1e-14);
}

void contradictions(Communicator &world)
{
  const std::string end = "subsection Dynamics\n  set end time = 1 us\nend\n";
  // Another value along the same direction; the radius of a corner that is held along it.
  const std::string moved  = quarter(led, ", other", hold("other", "X0", "x", led)),
                    corner = quarter(led, ", other", hold("other", "X0", "y"));
  for (const std::string &text : {moved, corner})
    {
      refused("linear static", text, world);
      refused("static", text, world);
      refused("run", text + end, world);
    }
  // Equal at time zero only.
  refused("run",
          quarter(led + "    set history = t\n", ", other", hold("other", "X0", "y")) + end,
          world);
}

int main(int argc, char **argv)
{
  MpiSession session(argc, argv);
  write_quarter("quarter.inp");
  widened("linear static", "", 1e-8, session.world());
  widened("static", "subsection Dynamics\n" + relaxed + "end\n", 1e-6, session.world());
  widened("run", preload, 1e-6, session.world());
  shaken(session.world());
  modes(session.world());
  agreement(session.world());
  contradictions(session.world());
  return 0;
}
