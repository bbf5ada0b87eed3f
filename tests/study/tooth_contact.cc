// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// From a parameter file to the unloaded tooth contact of the paper's pair; what is said to the
// tables as they are printed.
#include "../tests.h"
#include "quick_pair.h"

#include <vfife/base/errors.h>
#include <vfife/base/process/mpi_session.h>

#include <nlohmann/json.hpp>

#include <filesystem>

using namespace vfife;

int main(int argc, char **argv)
{
  MpiSession session(argc, argv);
  std::filesystem::remove_all("tca_results");
  std::ofstream("tca.prm") << "include " << SOURCE_DIR << "/../../prm/paper_pair.prm\n"
                           << "subsection Study\n  set kind = tooth contact analysis\nend\n";
  run_pair("tca.prm", "tca_results", session.world());
  for (const char *file : {"tca.json", "tca.csv", "path.csv", "ease_off.csv", "pair.prm"})
    check(std::string(file) + " is written",
          std::filesystem::exists(std::string("tca_results/") + file));

  std::ifstream        file("tca_results/tca.json");
  const nlohmann::json json  = nlohmann::json::parse(file);
  const nlohmann::json drive = json.at("drive");
  const auto           value = [](const nlohmann::json &group, const char *name) {
    return group.at(name).at("value").get<double>();
  };
  // Reference: doc/gear.md. Its path is sampled in steps of 0.02 pitches and ends inside the true
  // one; its place of the hand-over is rounded to 5e-4 pitches, over which the lag changes
  // by 3.5e-3.
  check_close("contact ratio", value(drive.at("path"), "contact ratio"), 1.97, 0.01);
  check_close("hand-over [pitches]", value(drive.at("hand-over"), "place"), 0.487, 5e-4);
  check_close("lag at the hand-over [arcsec]", value(drive.at("hand-over"), "lag"), 1.795, 4e-3);
  check_close("semi-axis a [mm]",
              value(drive.at("ellipse at the mean contact"), "semi-axis a"),
              5.583,
              5e-4);
  check("the coast side is there", json.contains("coast"));

  try
    {
      run_pair(std::string(SOURCE_DIR) + "/../../prm/gear/printed_tables.prm",
               "tca_results",
               session.world());
      std::cout << "FAILED: the printed tables are accepted" << std::endl;
    }
  catch (const InputError &error)
    {
      const std::string text = error.what();
      check("printed cutter diameter: file and line",
            text.find("printed_tables.prm:12 (") != std::string::npos);
      check("printed root angle: file and line",
            text.find("printed_tables.prm:53 (") != std::string::npos);
      check("consequences follow the causes", text.find("hence: ") != std::string::npos);
    }
}
