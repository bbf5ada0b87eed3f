// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// From a parameter file to natural vibrations: the coarsest gear, one sector, two speeds, its files
// against each other; a clamped bar against the closed form of its mesh.
#include "../../model_sections.h"
#include "../../read_files.h"
#include "../../refusal.h"
#include "../../vtu_file.h"
#include "../quick_pair.h"

#include <vfife/base/process/mpi_session.h>

#include <filesystem>

using namespace vfife;

std::string modal(const std::string &fem)
{
  return coarse_pair("", coarse_web) + R"(
subsection Study
  set kind = modal
end
subsection Operation
  set speed  = 20000 rpm
  set torque = 800 N m
end
subsection Fem
)" + fem +
         "end\n";
}

std::size_t column(const nlohmann::json &table, const std::string &name)
{
  for (std::size_t i = 0; i < table.at("columns").size(); ++i)
    if (table.at("columns")[i].at("name") == name)
      return i;
  throw std::runtime_error("no column " + name);
}

/** Crossings lie on both: k times the speed, and the branch between its two speeds. */
void check_resonances(const Table &campbell, const Table &resonances, const unsigned int teeth)
{
  double       of_force = 0, of_branch = 0;
  unsigned int found = 0;
  for (std::size_t i = 0; i < resonances.n_rows(); ++i)
    {
      const double n = resonances.numbers("nodal diameter")[i],
                   m = resonances.numbers("mesh order")[i], speed = resonances.numbers("speed")[i],
                   f    = resonances.numbers("frequency")[i];
      const bool   with = resonances.column("wave").texts[i] == "forward";
      const double k    = m * teeth + (with ? -n : n);
      raise_to(of_force, std::abs(k * speed / 60 / f - 1));
      std::vector<double> speeds, frequencies;
      for (std::size_t j = 0; j < campbell.n_rows(); ++j)
        if (campbell.numbers("nodal diameter")[j] == n &&
            campbell.numbers("order")[j] == resonances.numbers("order")[i])
          {
            speeds.push_back(campbell.numbers("speed")[j]);
            frequencies.push_back(campbell.numbers("frequency")[j]);
          }
      if (speeds.size() != 2)
        continue;
      ++found;
      const double part = (speed - speeds[0]) / (speeds[1] - speeds[0]);
      raise_to(of_branch,
               std::abs((frequencies[0] + part * (frequencies[1] - frequencies[0])) / f - 1));
    }
  check("crossings are there", found == resonances.n_rows() && found > 0);
  check_below("crossings: multiple of the speed", of_force, 1e-12);
  check_below("crossings: on the branch", of_branch, 1e-12);
}

/** Shapes are scaled to 1 mm; their shares of motion, by areas instead of masses, are roughly
 * those of the table. */
void check_shapes(const Table &modes, const VtuFile &shapes, const double speed)
{
  unsigned int k     = 0;
  double       scale = 0, shares = 0;
  for (std::size_t row = 0; row < modes.n_rows(); ++row)
    if (std::abs(modes.numbers("speed")[row] - speed) < 1e-6)
      {
        char name[64];
        std::snprintf(name, sizeof name, "mode %u, %.1f Hz", ++k, modes.numbers("frequency")[row]);
        double largest = 0, axial = 0, all = 0;
        for (std::size_t i = 0; i < 8 * shapes.n_cells(); ++i)
          {
            const Vector3 u = shapes.vector(name, shapes.corner(i / 8, i % 8));
            raise_to(largest, u.norm());
            axial += u[2] * u[2];
            all += u.squaredNorm();
          }
        raise_to(scale, std::abs(largest - 1));
        raise_to(shares, std::abs(axial / all - modes.numbers("axial")[row]));
      }
  check("shapes of all modes", shapes.n_arrays() == k && k == 9);
  check_below("shapes: largest displacement is 1 mm", scale, 1e-6);
  check_below("shapes: axial share", shares, .15);
}

void gear_files()
{
  const Table modes      = read_result_table("modal_results/modes.csv"),
              campbell   = read_result_table("modal_results/campbell.csv"),
              resonances = read_result_table("modal_results/resonances.csv");
  // Each vibration that is not the turn of the hub is on a branch, a pair's two waves on one.
  unsigned int missing = 0, elastic = 0;
  for (std::size_t i = 0; i < modes.n_rows(); ++i)
    if (modes.numbers("frequency")[i] > 1)
      {
        bool is_there = false;
        for (std::size_t j = 0; j < campbell.n_rows(); ++j)
          is_there = is_there ||
                     (std::abs(campbell.numbers("frequency")[j] / modes.numbers("frequency")[i] -
                               1) < 1e-8 &&
                      campbell.numbers("speed")[j] == modes.numbers("speed")[i] &&
                      campbell.numbers("nodal diameter")[j] == modes.numbers("nodal diameter")[i]);
        missing += !is_there;
        ++elastic;
      }
  check("all modes are on branches", missing == 0 && elastic == 16);
  double of_one = 0, of_parts = 0;
  for (std::size_t i = 0; i < modes.n_rows(); ++i)
    {
      // A sector's mode has one diameter; its motion has three parts.
      of_one = largest_of(of_one, std::abs(modes.numbers("share of the diameter")[i] - 1));
      raise_to(of_parts,
               std::abs(modes.numbers("axial")[i] + modes.numbers("radial")[i] +
                        modes.numbers("tangential")[i] - 1));
    }
  check_below("share of the diameter", of_one, 1e-9);
  check_below("sum of the shares of motion", of_parts, 1e-12);
  check_resonances(campbell, resonances, 79);
  check_shapes(modes, VtuFile("modal_results/modes/gear_0_rpm.vtu"), 0);
  check_shapes(modes, VtuFile("modal_results/modes/gear_10000_rpm.vtu"), 10000);
}

/**
 * A bar of 40 x 10 x 10 mm, clamped at x = 0, nu = 0: sections move along x as nodes of a chain
 * of n linear elements of length h, u_j = sin(k x_j), k = pi/(2 L): omega^2 = 6 (E/rho)/h^2 (1 -
 * cos kh)/(2 + cos kh).
 */
void clamped_bar(Communicator &world)
{
  constexpr unsigned int n = 8;
  std::filesystem::remove_all("modal_bar");
  std::ofstream("modal_bar.prm")
    << model_text::study("modal")
    << model_text::section("Model",
                           "set bodies = bar\nset constraints = foot\n" +
                             model_text::block("bar", {{40, 10, 10}}, {{n, 2, 2}}) +
                             model_text::section("Constraint foot",
                                                 "set kind = fixed\nset nodes = x-\n"))
    << model_text::no_contraction()
    << "subsection Fem\n set modes = 8\n set mass = consistent\nend\n";
  run_pair("modal_bar.prm", "modal_bar", world);
  const Table  modes   = read_result_table("modal_bar/modes.csv");
  const auto  &along   = modes.numbers("effective mass x");
  const auto   largest = std::max_element(along.begin(), along.end()) - along.begin();
  const double L = 40, h = L / n, k = pi / (2 * L), c2 = 206000 / 7.85e-9;
  const double omega = std::sqrt(6 * c2 / (h * h) * (1 - std::cos(k * h)) / (2 + std::cos(k * h)));
  check_ratio("clamped bar: longitudinal frequency over that of the chain",
              modes.numbers("frequency")[largest] / (omega / (2 * pi)),
              1e-8);
  // (sum m u)^2/(u . M u) of the chain: elements with masses m/6 (2 1; 1 2).
  double moved = 0, square = 0;
  for (unsigned int j = 0; j < n; ++j)
    {
      const double a = std::sin(k * h * j), b = std::sin(k * h * (j + 1));
      moved += (a + b) / 2;
      square += (a * a + a * b + b * b) / 3;
    }
  const double mass = 7.85e-9 * 1e3 * 10 * 10 * h; // of an element [kg]
  check_close("clamped bar: effective mass [kg]",
              along[largest],
              mass * moved * moved / square,
              1e-9);
  check_below("clamped bar: none across [kg]",
              modes.numbers("effective mass y")[largest] +
                modes.numbers("effective mass z")[largest],
              1e-9);
  // Of the slender beam, less some per cent by shear and the sections' own inertia at 4:1.
  check_close("clamped bar: first bending over the slender beam",
              modes.numbers("frequency")[0] /
                (1.8751 * 1.8751 / (2 * pi) * std::sqrt(c2 * 100. / 12) / (L * L)),
              .96,
              .04);
  check("clamped bar: numbered, at rest",
        modes.numbers("mode")[largest] == largest + 1 && modes.numbers("speed")[largest] == 0);
}

/** One sector by default, which has the lowest modes of the whole body. */
void lowest_by_sectors(Communicator &world)
{
  std::ofstream("modal_sectors.prm") << modal("set bodies = gear\nset modes = 12\n");
  run_pair("modal_sectors.prm", "modal_sectors", world);
  run_pair("modal_sectors.prm", "modal_whole", world, {"Fem/cyclic symmetry=no"});
  const Table sectors = read_result_table("modal_sectors/modes.csv"),
              whole   = read_result_table("modal_whole/modes.csv");
  const auto &found = sectors.numbers("frequency"), &expected = whole.numbers("frequency");
  check("sectors: as many modes", found.size() == 12 && expected.size() == 12);
  double difference = 0, inertia = 0;
  for (std::size_t k = 0; k < found.size(); ++k)
    {
      raise_to(difference, std::abs(found[k] - expected[k]) / expected.back());
      raise_to(inertia,
               std::abs(sectors.numbers("effective inertia z")[k] -
                        whole.numbers("effective inertia z")[k]));
    }
  check_below("sectors: frequencies", difference, 1e-6);
  check_below("sectors: effective inertia about the axis, over that of the body",
              inertia / whole.numbers("effective inertia z")[0],
              1e-6);
}

int main(int argc, char **argv)
{
  MpiSession session(argc, argv);
  std::filesystem::remove_all("modal_results");
  std::ofstream("modal.prm") << modal(
    "set bodies = gear\nset modes = 3\nset cyclic symmetry = yes\n"
    "set maximum nodal diameter = 2\nset speeds = 0, 10000\n");
  run_pair("modal.prm", "modal_results", session.world(), {"Fem/mesh harmonics=1"});
  for (const char *file : {"modes.csv",
                           "modes.json",
                           "campbell.csv",
                           "campbell.json",
                           "resonances.csv",
                           "modes/gear_0_rpm.vtu",
                           "modes/gear_10000_rpm.vtu"})
    check(std::string(file) + " is written",
          std::filesystem::exists(std::string("modal_results/") + file));

  const nlohmann::json table = read_json("modal_results/modes.json");
  const nlohmann::json rows  = table.at("rows");
  check("three modes for each diameter and speed", rows.size() == 18);
  const std::size_t speed = column(table, "speed"), frequency = column(table, "frequency"),
                    diameter = column(table, "nodal diameter");
  check("the hub turns freely", rows[0][diameter] == 0 && rows[0][frequency].get<double>() < 1.);
  // The first umbrella or tilting mode: spin stiffens the web, which spins in tension.
  double at_rest = 0, spun = 0;
  for (const auto &row : rows)
    if (row[diameter] == 1)
      {
        double &lowest = row[speed] == 0 ? at_rest : spun;
        if (lowest == 0)
          lowest = row[frequency].get<double>();
      }
  check("tilting mode between 0.3 and 6 kHz", at_rest > 300 && at_rest < 6000);
  check("spin changes it by less than 20 %, and does",
        std::abs(spun / at_rest - 1) < .2 && spun != at_rest);

  gear_files();
  clamped_bar(session.world());
  lowest_by_sectors(session.world());

  const auto refusal = [&session](const std::string &bodies) {
    std::ofstream("modal.prm") << modal("set bodies = " + bodies + "\n");
    return message_of([&] { run_pair("modal.prm", "modal_results", session.world()); });
  };
  check("a misspelt body is named", has_text(refusal("geer"), "did you mean \"gear\""));
  const std::string unlike = refusal("flywheel");
  check("bodies are listed where none is alike",
        !has_text(unlike, "did you mean") &&
          has_text(unlike, "expected a body, got \"flywheel\" (bodies: pinion, gear)"));
  return 0;
}
