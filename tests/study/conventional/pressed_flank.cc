// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// One tooth of the reference pinion under pressure, from a parameter file: a row of
// doc/verification/gear-pair.md, and what is refused.
#include "../../refusal.h"
#include "../program/documented_page.h"

using namespace vfife;

void tooth(Communicator &world)
{
  const auto row =
    row_of(pair_page, "The same tooth has curved elements", "quadratic | 8, 4, 3, 6");
  const std::string folder =
    do_case("prm/stress/pressed_tooth.prm",
            {"Gear pair/Pinion/Mesh/elements along face width=8", "Output/report=no"},
            world);
  const nlohmann::json figures = read_json(folder + "summary.json").at("figures");
  const auto           value   = [&figures](const char *name) {
    return figures.at(name).at("value").get<double>();
  };
  compare("tension [MPa]", row[3], 0, value("pinion root tension"));
  compare("compression [MPa]", row[3], 1, value("pinion root compression"));
  // Twice the work over pressure and the area of the flank.
  compare("mean deflection [um]",
          row[4],
          0,
          2e3 * value("work of the pressure") / (100. * 175.157));
  check_ratio("resultant", value("resultant of the pressure") / 17315., 1e-4);
  const Columns stresses = read_columns(folder + "root_stress.csv");
  check("a row per fillet of the tooth", stresses.at("tension").size() == 2);
}

/** The other flank of the other member bends its tooth the other way. */
void convex_flank_of_the_gear(Communicator &world)
{
  const std::string folder   = do_case("prm/stress/pressed_tooth.prm",
                                     {"Linear static/Pressed flank/member=gear",
                                        "Linear static/Pressed flank/side=convex",
                                        "Linear static/Pressed flank/tooth=3",
                                        "Fem/element type=incompatible modes",
                                        "Output/report=no"},
                                     world);
  const Table       stresses = read_result_table(folder + "root_stress.csv");
  for (std::size_t i = 0; i < stresses.n_rows(); ++i)
    {
      const auto text = [&](const std::string &name) {
        for (const Table::Column &column : stresses.columns())
          if (column.name == name)
            return column.texts[i];
        return std::string();
      };
      const bool pressed = has_text(text("fillet"), "convex");
      check(text("body") + ", " + text("fillet"),
            text("body") == "gear" && stresses.numbers("tooth")[i] == 3 &&
              (stresses.numbers("tension")[i] > -stresses.numbers("compression")[i]) == pressed);
    }
  check("no stress of the pinion",
        !read_json(folder + "summary.json").at("figures").contains("pinion root tension"));
}

void refusals(Communicator &world)
{
  const auto refuse = [&](const std::string &entry) {
    print_refusal<InputError>([&] {
      do_case("prm/stress/pressed_tooth.prm", {entry, "Output/report=no"}, world);
    });
  };
  refuse("Linear static/Pressed flank/tooth=27");
  refuse("Linear static/Adaptive refinement/result=strain energy");
}

int main(int argc, char **argv)
{
  return run_parts(argc, argv, {tooth, convex_flank_of_the_gear, refusals});
}
