// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// Pressures on their own grid of a loaded tooth contact analysis of a coarse pair: the penalty
// leaves no trace in them, and the tables agree.
#include "../shaft_pair.h"

#include <vfife/base/process/mpi_session.h>
#include <vfife/output/files/run_figures.h>

using namespace vfife;

Table read(const std::string &folder, const std::string &file)
{
  return read_result_table(folder + "/" + file);
}

/** A file by a soft and a hard penalty: rows of the same teeth at the same place. */
void compare_penalties(const std::string              &file,
                       const std::string              &name,
                       std::vector<std::string>        entries,
                       const std::vector<std::string> &columns,
                       Communicator                   &world)
{
  entries.emplace_back("Contact/penalty=4e5");
  run_pair(file, name + "_soft", world, entries);
  entries.back() = "Contact/penalty=4e6";
  run_pair(file, name + "_hard", world, entries);
  const Table soft = read(name + "_soft", "pressure.csv"),
              hard = read(name + "_hard", "pressure.csv");
  check(name + ", penalties: the same teeth carry", soft.n_rows() == hard.n_rows());
  const auto worst = [&](const std::string &column) {
    double largest = 0;
    for (std::size_t i = 0; i < std::min(soft.n_rows(), hard.n_rows()); ++i)
      if (hard.numbers("share of torque")[i] > .1)
        raise_to(largest, std::abs(soft.numbers(column)[i] / hard.numbers(column)[i] - 1.));
    return largest;
  };
  // Measured 5e-5, with quadratic elements 2e-4: gaps are linear in the displacements, but for
  // the turn of the normals.
  for (const std::string &column : columns)
    check_below(name + ", penalties: " + column, worst(column), 1e-3);
}

void check_tables(const std::string &folder)
{
  const Table teeth = read(folder, "pressure.csv"), field = read(folder, "pressure_field.csv");
  const auto &shares = teeth.numbers("share of torque");
  const auto &torque = teeth.numbers("torque");
  check_ratio("shares", std::accumulate(shares.begin(), shares.end(), 0.), 1e-9);
  check_close("torques [N m]", std::accumulate(torque.begin(), torque.end(), 0.), 800., 1e-4);
  const auto largest = [](const std::vector<double> &values) {
    return *std::max_element(values.begin(), values.end());
  };
  check_ratio("largest pressure of the field over that of teeth",
              largest(field.numbers("pressure")) / largest(teeth.numbers("largest pressure")),
              1e-9);
  check_ratio("figure over the table",
              read_figure(folder + "/figures.json", "/largest pressure inside on its own grid") /
                largest(teeth.numbers("largest pressure inside")),
              1e-9);
  // Teeth of 30 mm face width, 5.3 mm deep.
  const auto &along = field.numbers("along the face, pinion"),
             &up    = field.numbers("along the profile, pinion");
  check("places on the flank",
        std::abs(largest(along)) < 15.5 &&
          std::abs(*std::min_element(along.begin(), along.end())) < 15.5 && largest(up) < 5. &&
          *std::min_element(up.begin(), up.end()) > -3.);
}

int main(int argc, char **argv)
{
  MpiSession session(argc, argv);
  std::ofstream("grid_pressure.prm")
    << quick_pair("set body type = rim only", "set elements through rim = 2", "1e-5")
    << model_text::loaded_contact(1, "set pressure cells = 8\n");
  const std::vector<std::string> columns = {"share of torque",
                                            "transmission error",
                                            "contact length",
                                            "largest pressure inside"};
  compare_penalties("grid_pressure.prm", "grid_pressure", {}, columns, session.world());
  check_tables("grid_pressure_hard");
  // The surface between the nodes bends under the penalty's forces. Pressures of single cells
  // depend on how the coarse grid lies, to 1 %.
  compare_penalties("grid_pressure.prm",
                    "quadratic",
                    {"Fem/element type=quadratic", "Fem/geometry=curved"},
                    {"share of torque", "transmission error", "contact length"},
                    session.world());
  // Points of divided elements hang in the layer below the flanks.
  compare_penalties("grid_pressure.prm",
                    "divided",
                    {"Fem/local refinement=flanks 1"},
                    {"share of torque", "transmission error", "contact length"},
                    session.world());
  const auto error_of = [](const std::string &folder) {
    return read(folder, "pressure.csv").numbers("transmission error").front();
  };
  // A small chamfer changes little (measured 3e-4, proportional to it), although the layer under
  // the flank then ends at other elements.
  compare_penalties("grid_pressure.prm",
                    "chamfer",
                    {"Gear pair/Gear/tip chamfer=0.002", "Gear pair/Pinion/tip chamfer=0.002"},
                    {"share of torque", "transmission error"},
                    session.world());
  check_ratio("small chamfer over none, transmission error",
              error_of("chamfer_hard") / error_of("grid_pressure_hard"),
              1e-3);
  const double softer = error_of("divided_hard") / error_of("grid_pressure_hard") - 1.;
  check("divided flanks are more compliant", softer > 0. && softer < .1);
  std::ofstream("grid_pressure_shafts.prm")
    << shaft_pair::pair_on_shafts("", shaft_pair::Laws(), shaft_pair::many_teeth())
    << shaft_pair::operation("60 rpm")
    << model_text::loaded_contact(1, "set pressure cells = 8\nset centrifugal = no\n");
  // On bearings the redistribution sees their linear stiffness alone.
  compare_penalties(
    "grid_pressure_shafts.prm", "grid_pressure_shafts", {}, columns, session.world());
  return 0;
}
