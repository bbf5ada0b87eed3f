// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// A pair on shafts in a run: its step is that of the teeth, and turned slowly through a tooth mesh
// it is on average where the loaded tooth contact analysis has it.
#include "../../parts.h"
#include "../../tests.h"
#include "../shaft_pair.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <numeric>

using namespace vfife;
using namespace shaft_pair;

namespace
{
  double mean(const std::vector<double> &values)
  {
    return std::accumulate(values.begin(), values.end(), 0.) / values.size();
  }

  std::string on_shafts()
  {
    return pair_on_shafts("", Laws(), many_teeth());
  }

  /** Step of a run [s], and the largest that its elements allow. */
  std::array<double, 2> find_steps(const std::string &folder)
  {
    std::ifstream file(folder + "/summary.json");
    const auto    summary = nlohmann::ordered_json::parse(file);
    return {{summary.at("run").at("step").at("value").get<double>(),
             summary.at("figures").at("stable step without contact").at("value").get<double>()}};
  }

  void step(Communicator &world)
  {
    // Steps are known before the start, whose equilibrium may be found as roughly as it can be.
    const std::string rest = operation("20000 rpm") + kind("run") +
                             "subsection Dynamics\nset largest number of steps = 1\n"
                             "set start = ramp\nset start solver = relaxation\n"
                             "subsection Relaxation\nset tolerance = 0.01\nend\nend\n";
    // A tooth mesh has a whole number of samples: of single steps.
    const std::vector<std::string> fine = {"Output/history every=1"};
    run_pair(write("bores", many_teeth() + rest), "bores", world, fine);
    run_pair(write("shafts", on_shafts() + rest), "shafts", world, fine);
    run_pair("shafts.prm",
             "undamped",
             world,
             {fine.front(), "Gear pair/Pinion/Shaft/End/torsional damping=0"});
    const auto bores = find_steps("bores"), shafts = find_steps("shafts"),
               undamped = find_steps("undamped");
    // Sectors have other levels where they meet the shaft, which moves their worst element.
    check_close("stable step without contact, on shafts over ideal bores",
                shafts[1] / bores[1],
                1.,
                1e-3);
    // To the rounding to whole steps in a tooth mesh.
    check_close("step on shafts and springs over ideal bores", undamped[0] / bores[0], 1., 2e-3);
    // A damper of 1e4 N mm s/rad on the ring of the shaft's end has a share of it.
    check("the coupling's damper costs less than 3 % of it",
          shafts[0] / bores[0] > .97 && shafts[0] < undamped[0]);
  }

  /** Means of a bearing's forces over a table, along the fixed frame. */
  std::map<std::string, Vector3> mean_forces(const std::string &folder)
  {
    const Table                         table = read_result_table(folder + "/bearings.csv");
    std::map<std::string, Vector3>      sums;
    std::map<std::string, unsigned int> n;
    const auto                         &names = table.column("bearing").texts;
    for (std::size_t i = 0; i < names.size(); ++i)
      {
        std::map<std::string, double> row;
        for (const char *c : {"force x", "force y", "force z"})
          row[c] = table.numbers(c)[i];
        sums.try_emplace(names[i], Vector3::Zero()).first->second += force_of(names[i], row);
        ++n[names[i]];
      }
    for (auto &[name, sum] : sums)
      sum /= n[name];
    return sums;
  }

  void slow_run(Communicator &world)
  {
    const std::string pair = on_shafts() + operation("1700 rpm");
    run_pair(write("slow_loaded",
                   kind("loaded tooth contact analysis") + pair +
                     "subsection Loaded contact\nset positions = 8\nend\n"),
             "slow_loaded",
             world);
    run_pair(write("slow_run", kind("run") + pair), "slow_run", world);
    const auto run    = read_columns("slow_run/history.csv");
    const auto loaded = read_columns("slow_loaded/loaded_contact.csv");
    check_close("slow run: mean transmission error over that of the analysis",
                mean(run.at("dte")) / mean(loaded.at("transmission error")),
                1.,
                .01);
    const auto of_run = mean_forces("slow_run"), of_analysis = mean_forces("slow_loaded");
    double     apart = 0, largest = 0;
    for (const auto &[name, force] : of_analysis)
      {
        apart   = largest_of(apart, (of_run.at(name) - force).norm());
        largest = std::max(largest, force.norm());
      }
    check("slow run: five bearings", of_run.size() == 5 && of_analysis.size() == 5);
    check_below("slow run: mean forces of the bearings less the analysis', over the largest",
                apart / largest,
                .01);
    const auto moved    = read_columns("slow_run/misalignment.csv"),
               expected = read_columns("slow_loaded/misalignment.csv");
    for (const char *c : {"offset", "pinion axial shift", "gear axial shift", "shaft angle error"})
      check_close(std::string("slow run: mean ") + c + " over the analysis'",
                  mean(moved.at(c)) / mean(expected.at(c)),
                  1.,
                  .01);
  }
} // namespace

int main(int argc, char **argv)
{
  run_parts<Communicator>(argc, argv, {&step, &slow_run});
  return 0;
}
