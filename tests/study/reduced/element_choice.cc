// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// Elements of reduced bodies by default: quadratic where a pair affords them, and then the modes
// of kind modal; otherwise those of the run.
#include "../../parts.h"
#include "../../read_files.h"
#include "../few_teeth.h"

using namespace vfife;

void chosen(Communicator &world)
{
  struct Row
  {
    const char              *file;
    std::vector<std::string> entries;
    const char              *expected; ///< nullptr: nothing is chosen
  };
  const std::vector<Row> rows = {
    {"reduced/spiral_bevel_quick.prm", {}, "quadratic elements on the exact surfaces"},
    {"reduced/spiral_bevel_quick.prm", {"Reduced/element type=cubic"}, nullptr},
    {"reduced/spiral_bevel.prm", {}, "as the run"},
    {"supports/spiral_bevel_shafts_reduced.prm", {}, "as the run"},
    {"waves/predict.prm", {}, "quadratic elements on the exact surfaces"},
    {"waves/one_wave_runs.prm", {}, "as the run"}};
  for (const Row &row : rows)
    {
      const std::string said  = check_case(tree_folder() + "/prm/" + row.file, world, row.entries),
                        begin = "Reduced/element type = auto: ";
      check(row.file + std::string(row.expected ? "" : ", given"),
            row.expected ? has_text(said, begin + row.expected) : !has_text(said, begin));
    }
}

/** Frequencies of waves at rest, which are those of the gear alone by kind modal. */
void modes_of_the_gear(Communicator &world)
{
  std::ofstream("quadratic.prm")
    << quick_few_teeth("set body type = conical web", coarse_web, "1e-6")
    << "subsection Study\n set kind = waves\nend\nsubsection Waves\n set simulate response = no\n"
       " set lowest speed = 0 rpm\n set highest speed = 3000 rpm\n set nodal diameters = 2, 3\n"
       " set modes per diameter = 1\n set mesh harmonics = 1\nend\n";
  run_pair("quadratic.prm",
           "quadratic",
           world,
           {"Reduced/element type=auto", "Reduced/cutoff frequency=8 kHz"});
  run_pair("quadratic.prm",
           "quadratic_modal",
           world,
           {"Study/kind=modal",
            "Fem/element type=auto",
            "Fem/bodies=gear",
            "Fem/modes=1",
            "Fem/cyclic symmetry=yes",
            "Fem/maximum nodal diameter=3"});
  const Columns waves = read_columns("quadratic/waves_frequencies.csv"),
                modes = read_columns("quadratic_modal/modes.csv");
  const auto find     = [](const Columns &columns, const double n) {
    for (std::size_t i = 0; i < columns.at("frequency").size(); ++i)
      if (columns.at("nodal diameter")[i] == n && columns.at("speed")[i] == 0)
        return columns.at("frequency")[i];
    return 0.;
  };
  for (const double n : {2., 3.})
    check_ratio("a frequency of both kinds", find(waves, n) / find(modes, n), 1e-6);
}

int main(int argc, char **argv)
{
  run_parts<Communicator>(argc, argv, {chosen, modes_of_the_gear});
  return 0;
}
