// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// Study kind lumped: by values with a sweep, and with inertias of a gear pair's bodies and a table.
#include "../refusal.h"
#include "../tests.h"
#include "quick_pair.h"

#include <vfife/base/errors.h>
#include <vfife/base/process/mpi_session.h>

#include <nlohmann/json.hpp>

#include <filesystem>

using namespace vfife;

namespace
{
  nlohmann::json read_results(const std::string &folder)
  {
    std::ifstream      file(folder + "/lumped.json");
    std::ostringstream text;
    text << file.rdbuf();
    return nlohmann::json::parse(text.str());
  }

  double number(const nlohmann::json &json, const char *part, const char *name)
  {
    return json.at(part).at(name).at("value").get<double>();
  }

  void refuse(const std::string &lines, Communicator &world)
  {
    std::ofstream("wrong.prm") << "subsection Study\n set kind = lumped\nend\n"
                               << "subsection Operation\n set speed = 20000 rpm\n"
                               << " set torque = 800 N m\nend\nsubsection Lumped\n"
                               << lines << "end\n";
    print_refusal([&] { run_pair("wrong.prm", "lumped_results", world); });
  }
} // namespace

int main(int argc, char **argv)
{
  MpiSession session(argc, argv);
  std::filesystem::remove_all("lumped_results");
  std::ofstream("values.prm") << "include " << SOURCE_DIR
                              << "/../../prm/lumped/torsional_pair.prm\n"
                                 "subsection Lumped\n set speeds = 5\n set settling meshes = 300\n"
                                 " set measured meshes = 5\n set pictures = no\nend\n";
  run_pair("values.prm", "lumped_results", session.world());
  const nlohmann::json values = read_results("lumped_results");
  // sqrt(2.2e9/27.978)/(2 pi)
  check_close("frequency [Hz]",
              values.at("modes")[0].at("frequency [Hz]").get<double>(),
              1411.312341,
              1e-5);
  check_close("static part of the force [N]",
              number(values, "response", "mean force"),
              8e5 / 89.8,
              .01 * 8e5 / 89.8);
  auto motion = read_columns("lumped_results/lumped.csv");
  check("64 samples in five tooth meshes", motion["dte"].size() == 320);
  std::ifstream sweep("lumped_results/resonance.csv");
  unsigned int  rows = 0;
  for (std::string line; std::getline(sweep, line);)
    ++rows;
  check("five speeds up, five down", rows == 11);

  std::ofstream("table.csv")
    << "position [tooth meshes],unloaded transmission error [arcsec],transmission error [arcsec],"
       "contact torque on the gear [N m],tangent stiffness [N m/rad]\n"
       "0,1,-54,800,3.8e6\n0.5,-1,-56,800,3.7e6\n";
  // The kind knows no Dynamics and no Output.
  const std::string all = quick_pair("set web = none", "set rim rows = 2", "1e-5");
  std::ofstream("pair.prm")
    << all.substr(0, all.find("subsection Dynamics"))
    << "subsection Study\n set kind = lumped\nend\n"
       "subsection Lumped\n set mesh = loaded contact\n"
       " set table = table.csv\n set settling meshes = 100\n"
       " set measured meshes = 5\n set pictures = no\n set supports = axial, tilt\n"
       " subsection Support axial\n set direction = 0, 0, 1\n"
       " set mass = 1.7 kg\n set stiffness = 1e6\n end\n"
       " subsection Support tilt\n set motion = tilt\n"
       " set direction = 0, 1, 0\n set inertia = 9000\n"
       " set tilt stiffness = 1 MN m/rad\n end\nend\n";
  run_pair("pair.prm", "lumped_results", session.world());
  const nlohmann::json pair = read_results("lumped_results");
  check("three modes", pair.at("modes").size() == 3);
  check_close("mean tangent stiffness of the table [N m/rad]",
              number(pair, "model", "mesh stiffness, mean at the torque"),
              3.75e6,
              2e3);
  check("backlash of the pair", number(pair, "model", "backlash, turn of the gear") > 100);
  check_below("energy error", number(pair, "response", "energy error"), 1e-6);

  refuse(" set stiffness = 2 MN m/rad\n", session.world());
  refuse(" set stiffness = 2 MN m/rad\n set stiffness cosines = 0.7, 0.4\n set pinion teeth = 27\n"
         " set gear teeth = 79\n set gear inertia = 1\n set arm = 90\n set backlash = 0\n",
         session.world());
  refuse(" set mesh = loaded contact\n set table = nothing.csv\n set pinion teeth = 27\n"
         " set gear teeth = 79\n set gear inertia = 1\n set arm = 90\n set backlash = 0\n",
         session.world());
  refuse(" set stiffness = 2 MN m\n", session.world());
}
