// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// From a measured flank to machine settings by files: a pair with changed settings writes its grid,
// the unchanged pair finds the flank from it, and the pair that it writes has that flank.
#include "../../read_files.h"
#include "../../refusal.h"
#include "../quick_pair.h"

#include <vfife/base/process/mpi_session.h>

#include <filesystem>

using namespace vfife;

double largest_distance(const Table &one, const Table &two)
{
  double most = one.n_rows() == two.n_rows() ? 0. : 1e9;
  for (std::size_t i = 0; i < one.n_rows(); ++i)
    for (const char *axis : {"x", "y", "z"})
      raise_to(most, std::abs(one.numbers(axis)[i] - two.numbers(axis)[i]));
  return most;
}

int main(int argc, char **argv)
{
  MpiSession session(argc, argv);
  for (const char *folder : {"measured", "found", "again"})
    std::filesystem::remove_all(folder);
  const std::string kind = "subsection Study\n  set kind = flank fit\nend\n";
  std::ofstream("pair.prm") << "include " << tree_folder() << "/prm/paper_pair.prm\n" << kind;
  const std::string grid = "grid_pinion_concave.csv";
  run_pair("pair.prm",
           "measured",
           session.world(),
           {"Gear pair/Pinion/Concave flank/radial distance=104.60 mm",
            "Gear pair/Pinion/Concave flank/blade angle=20.04 deg",
            "Gear pair/Pinion/Concave flank/blank offset=1.45 mm",
            "Flank fit/Grid/rows=6",
            "Flank fit/Grid/columns=7"});
  for (const char *file : {"grid_pinion_concave.csv",
                           "grid_pinion_convex.csv",
                           "grid_gear_concave.csv",
                           "grid_gear_convex.csv",
                           "flank_fit.json"})
    check(std::string(file) + " is written",
          std::filesystem::exists(std::string("measured/") + file));
  const Table measured = read_result_table("measured/" + grid);
  check("rows and columns", measured.n_rows() == 42);

  run_pair("pair.prm",
           "found",
           session.world(),
           {"Flank fit/member=pinion",
            "Flank fit/flank=concave",
            "Flank fit/measured flank=measured/" + grid,
            "Flank fit/free turn=no",
            "Flank fit/threshold=1e-7",
            "Flank fit/settings=radial distance, blade angle, blank offset, ratio of roll"});
  const nlohmann::json json = read_json("found/flank_fit.json");
  const auto value = [](const nlohmann::json &figure) { return figure.at("value").get<double>(); };
  check("far away before [um]", value(json.at("largest before")) > 20.);
  check_below("found [um]", value(json.at("largest after")), 1.);
  const nlohmann::json &settings = json.at("settings");
  check_close("radial distance [mm]",
              value(settings.at("radial distance").at("found")),
              104.60,
              1e-4);
  check_close("its change [mm]", value(settings.at("radial distance").at("change")), .07, 1e-4);
  check_close("blade angle [deg]", value(settings.at("blade angle").at("found")), 20.04, 1e-4);
  check_close("blank offset [mm]", value(settings.at("blank offset").at("found")), 1.45, 1e-4);

  // The pair that was written, read again.
  std::ofstream("again.prm") << "include found/fitted_pair.prm\n" << kind;
  run_pair("again.prm",
           "again",
           session.world(),
           {"Flank fit/Grid/rows=6", "Flank fit/Grid/columns=7"});
  check_below("the pair with the settings found has the flank [um]",
              1e3 * largest_distance(measured, read_result_table("again/" + grid)),
              1.);

  // A flank that is as designed needs no change.
  run_pair("pair.prm",
           "same",
           session.world(),
           {"Flank fit/member=gear",
            "Flank fit/flank=convex",
            "Flank fit/measured flank=measured/grid_gear_convex.csv"});
  const nlohmann::json same = read_json("same/flank_fit.json");
  check_below("the gear's convex flank is there [um]", value(same.at("largest before")), 1e-6);
  check_below("and stays: radial distance [mm]",
              value(same.at("settings").at("radial distance").at("change")),
              1e-6);

  for (const char *wrong :
       {"Flank fit/settings=radial distanc", "Flank fit/measured flank=nowhere.csv"})
    print_refusal([&] {
      run_pair("pair.prm",
               "wrong",
               session.world(),
               {"Flank fit/measured flank=measured/" + grid, wrong});
    });
  return 0;
}
