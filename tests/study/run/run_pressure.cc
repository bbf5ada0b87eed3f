// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// Pressures on their own grid at instants of runs of a coarse pair: their sum is the force of the
// tooth pair, a run and a reduced pair in equilibrium have those of the loaded tooth contact
// analysis, friction stays out of them; instants that are none are refused.
#include "../../model_sections.h"
#include "../../refusal.h"
#include "../quick_pair.h"

#include <vfife/base/process/mpi_session.h>
#include <vfife/output/files/run_figures.h>

using namespace vfife;

bool verbose = false; // says the numbers

Table read(const std::string &folder, const std::string &file)
{
  return read_result_table(folder + "/" + file);
}

std::string pressure(const std::string &entries)
{
  return "subsection Pressure\n set pressure cells = 8\n" + entries + "end\n";
}

/** What a table has of a pinion tooth at a place of its engagement or time; NaN: it has none. */
double find(const Table       &table,
            const std::string &column,
            const std::string &key,
            const double       value,
            const double       tooth)
{
  for (std::size_t i = 0; i < table.n_rows(); ++i)
    if (std::abs(table.numbers(key)[i] - value) < 1e-9 && table.numbers("pinion tooth")[i] == tooth)
      return table.numbers(column)[i];
  return std::nan("");
}

/** The grids' forces over those of the teeth of the run at the same sample: the resultants, or
 * their parts along the normals, mean pressure times area. */
void check_forces(const std::string &folder, const bool rubs, const double bound)
{
  const Table found = read(folder, "pressure.csv"), teeth = read(folder, "teeth.csv"),
              field = read(folder, "pressure_field.csv");
  double worst      = 0;
  for (std::size_t i = 0; i < found.n_rows(); ++i)
    {
      const auto run = [&](const std::string &column) {
        return find(
          teeth, column, "time", found.numbers("time")[i], found.numbers("pinion tooth")[i]);
      };
      const double force = rubs ? run("mean pressure") * run("area") : run("force");
      raise_to(worst, std::abs(found.numbers("force")[i] / force - 1.));
    }
  if (verbose)
    std::cerr << folder << ": forces differ from the run's by " << worst << ", " << found.n_rows()
              << " rows" << std::endl;
  check_below(folder + ": forces", worst, bound);
  check(folder + ": teeth at both instants", found.n_rows() >= 4);
  check(folder + ": field of the same instants",
        field.numbers("time").front() == found.numbers("time").front() &&
          field.numbers("time").back() == found.numbers("time").back());
}

/** At the start of a run, in equilibrium, beside the analysis at position 0: the forces are those
 * of the penalty's equilibrium there. On the grids of the analysis teeth share the load anew; in
 * between pressures and sides of Hertz's ellipses grow as the third root of the force. */
void check_start(const std::string &folder)
{
  const Table run    = read(folder, "pressure.csv"),
              loaded = read("run_pressure_loaded", "pressure.csv"),
              teeth  = read("run_pressure_loaded", "loaded_teeth.csv");
  double force = 0, pressure = 0, length = 0;
  for (std::size_t i = 0; i < loaded.n_rows(); ++i)
    {
      const double tooth = loaded.numbers("pinion tooth")[i];
      const auto   here  = [&](const std::string &column) {
        return find(run, column, "position", 0., tooth);
      };
      const double penalty = find(teeth, "force", "position", 0., tooth);
      raise_to(force, std::abs(here("force") / penalty - 1.));
      const double root = std::cbrt(here("force") / loaded.numbers("force")[i]);
      const auto   over = [&](const std::string &column) {
        return std::abs(here(column) / (root * loaded.numbers(column)[i]) - 1.);
      };
      raise_to(pressure, over("largest pressure inside"));
      // At edges the ellipse is cut off.
      if (loaded.numbers("on edge")[i] == 0)
        raise_to(length, over("contact length"));
    }
  if (verbose)
    std::cerr << folder << " beside the analysis: force " << force << ", pressure " << pressure
              << ", length " << length << std::endl;
  check(folder + ": as many teeth", loaded.n_rows() == 3);
  check_below(folder + ": force at the start", force, 1e-3);
  check_below(folder + ": pressure at the start", pressure, .015);
  check_below(folder + ": length at the start", length, .03);
}

void check_refusals(const std::string &pair, Communicator &world)
{
  const auto refuse = [&](const std::string &text, const std::vector<std::string> &more = {}) {
    std::ofstream("run_pressure_refused.prm") << text;
    print_refusal(
      [&] { run_pair("run_pressure_refused.prm", "run_pressure_refused", world, more); });
  };
  for (const char *entries : {"set instants = 0.5, soon\n",
                              "set instants = -0.5\n",
                              "set instants = 1.5\n",
                              "set instants = 1 s\n",
                              "set instants = 5 mm\n",
                              "set every = 2\n",
                              "set every = 0.5\n set last = 3\n",
                              "set every = 0.0005\n"})
    refuse(pair + model_text::study("run") + pressure(entries));
  refuse(pair + model_text::study("reduced") + pressure("set every = 0.5\n"),
         {"Reduced/sweep=up", "Reduced/lowest speed=1000 rpm", "Reduced/highest speed=2000 rpm"});
}

int main(int argc, char **argv)
{
  MpiSession    session(argc, argv);
  Communicator &world = session.world();
  verbose             = argc > 1;
  const std::string pair =
    quick_pair("set body type = rim only", "set elements through rim = 2", "1e-6");

  // Instants at samples, one of them given as a time.
  const std::string instants =
    pressure(" set instants = 0.5, 0\n set every = 0.5\n set last = 0.5\n");
  std::ofstream("run_pressure.prm") << pair << model_text::study("run") << instants;
  run_pair("run_pressure.prm", "run_pressure", world);
  check_forces("run_pressure", false, 1e-8);
  const Table                teeth = read("run_pressure", "pressure.csv");
  const std::vector<double> &all   = teeth.numbers("largest pressure");
  check_ratio("figure over the table",
              read_figure("run_pressure/summary.json",
                          "/figures/largest pressure on its own grid") /
                *std::max_element(all.begin(), all.end()),
              1e-9);
  std::ofstream("run_pressure_loaded.prm")
    << pair << model_text::loaded_contact(1, "set pressure cells = 8\n");
  run_pair("run_pressure_loaded.prm", "run_pressure_loaded", world);
  check_start("run_pressure");

  std::ofstream("run_pressure_reduced.prm") << pair << model_text::study("reduced") << instants;
  run_pair("run_pressure_reduced.prm", "run_pressure_reduced", world);
  check_forces("run_pressure_reduced", false, 1e-6);
  check_start("run_pressure_reduced");

  // Tangential tractions stay where they are.
  std::ofstream("run_pressure_rubbed.prm")
    << pair << model_text::study("run")
    << "subsection Contact\n set friction coefficient = 0.2\nend\n"
    << instants;
  run_pair("run_pressure_rubbed.prm", "run_pressure_rubbed", world);
  check_forces("run_pressure_rubbed", true, 1e-8);
  check_refusals(pair, world);
  return 0;
}
