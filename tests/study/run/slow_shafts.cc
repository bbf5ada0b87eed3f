// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// A pair on shafts in a run: its step is that of the teeth, and turned slowly through a mesh cycle
// it is on average where the loaded tooth contact analysis has it.
#include "../../parts.h"
#include "../shaft_pair.h"

using namespace vfife;
using namespace shaft_pair;

std::string on_shafts()
{
  return pair_on_shafts("", Laws(), many_teeth());
}

double number_after(const std::string &text, const std::string &words)
{
  const std::size_t at = text.find(words);
  return at == std::string::npos ? std::nan("") : std::stod(text.substr(at + words.size()));
}

/** Steps of a run, and the largest that its elements allow [ns]: both are known before the start,
 * as --check says them. */
struct Steps
{
  double in_mesh, stable;
};

Steps find_steps(const std::string              &file,
                 const std::vector<std::string> &overrides,
                 Communicator                   &world)
{
  const std::string said = check_case(file, world, overrides);
  return {number_after(said, "the run has "),
          number_after(said, "the stable step of the assembly is ")};
}

void step(Communicator &world)
{
  const std::string rest = operation("20000 rpm") + study("run");
  // A mesh cycle has a whole number of samples: of single steps.
  std::vector<std::string> entries = {"Output/samples per mesh cycle=1"};
  const Steps              bores = find_steps(write("bores", many_teeth() + rest), entries, world),
              shafts             = find_steps(write("shafts", on_shafts() + rest), entries, world);
  entries.emplace_back("Gear pair/Pinion/Shaft/End/torsional damping=0");
  const Steps undamped = find_steps("shafts.prm", entries, world);
  // Sectors have other levels where they meet the shaft, which moves their worst element.
  check_ratio("stable step without contact, on shafts over ideal bores",
              shafts.stable / bores.stable,
              1e-3);
  // To the rounding to whole steps per mesh cycle.
  check_ratio("step on shafts and springs over ideal bores",
              bores.in_mesh / undamped.in_mesh,
              2e-3);
  // A damper of 1e4 N mm s/rad on the ring of the shaft's end has a share of it.
  check("the coupling's damper costs less than 3 % of it",
        bores.in_mesh / shafts.in_mesh > .97 && shafts.in_mesh > undamped.in_mesh);
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

/** At this speed the transmission error lacks less than 1e-3 without centrifugal forces, which
 * the analysis leaves out. */
void slow_run(Communicator &world)
{
  const std::string pair = on_shafts() + operation("1700 rpm");
  run_pair(write("slow_loaded",
                 study("loaded tooth contact analysis") + pair +
                   "subsection Loaded contact\nset positions = 8\nset centrifugal = no\nend\n"),
           "slow_loaded",
           world);
  run_pair(write("slow_run", study("run") + pair), "slow_run", world);
  const auto run    = read_columns("slow_run/history.csv");
  const auto loaded = read_columns("slow_loaded/loaded_contact.csv");
  check_ratio("slow run: mean transmission error over that of the analysis",
              mean_of(run.at("dte")) / mean_of(loaded.at("transmission error")),
              .01);
  const auto of_run = mean_forces("slow_run"), of_analysis = mean_forces("slow_loaded");
  double     apart = 0, largest = 0;
  for (const auto &[name, force] : of_analysis)
    {
      raise_to(apart, (of_run.at(name) - force).norm());
      largest = std::max(largest, force.norm());
    }
  check("slow run: five bearings", of_run.size() == 5 && of_analysis.size() == 5);
  check_below("slow run: mean forces of the bearings less the analysis', over the largest",
              apart / largest,
              .01);
  const auto moved    = read_columns("slow_run/misalignment.csv"),
             expected = read_columns("slow_loaded/misalignment.csv");
  for (const char *c : {"offset", "pinion axial shift", "gear axial shift", "shaft angle error"})
    check_ratio(std::string("slow run: mean ") + c + " over the analysis'",
                mean_of(moved.at(c)) / mean_of(expected.at(c)),
                .01);
}

int main(int argc, char **argv)
{
  run_parts<Communicator>(argc, argv, {&step, &slow_run});
  return 0;
}
