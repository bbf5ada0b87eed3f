// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// Loaded tooth contact analysis of a coarse pair by finite elements against the equilibrium that an
// explicit run of the same file finds by relaxation.
#include "../tests.h"
#include "quick_pair.h"

#include <vfife/base/mpi_session.h>

#include <nlohmann/json.hpp>

#include <filesystem>

using namespace vfife;

int main(int argc, char **argv)
{
  MpiSession        session(argc, argv);
  const std::string pair = quick_pair("set web = none", "set rim rows = 2", "1e-7");
  for (const char *folder : {"loaded_run", "loaded_fem"})
    std::filesystem::remove_all(folder);
  std::ofstream("loaded_run.prm") << pair
                                  << "subsection Dynamics\n set largest number of steps = 1\nend\n";
  run_pair("loaded_run.prm", "loaded_run", session.world());
  std::ofstream("loaded_fem.prm")
    << pair << "subsection Study\n set kind = loaded tooth contact analysis\nend\n"
    << "subsection Loaded contact\n set positions = 3\nend\n";
  run_pair("loaded_fem.prm", "loaded_fem", session.world());

  std::ifstream      file("loaded_run/summary.json");
  std::ostringstream text;
  text << file.rdbuf();
  const nlohmann::json summary = nlohmann::json::parse(text.str());
  const double         relaxed =
    summary.at("transmission error").at("total at the start").at("value").get<double>();

  auto columns = read_columns("loaded_fem/loaded_contact.csv");
  check("three positions", columns["position"].size() == 3);
  // Linear elasticity in axes that turn with the hub against finite rotations of each element.
  check_close("transmission error at the reference position",
              columns["transmission error"][0],
              relaxed,
              .01);
  for (std::size_t i = 0; i < columns["position"].size(); ++i)
    {
      // Newton's method stops at 1e-9 of the torque.
      check_close("contact torque [N m]", columns["contact torque on the gear"][i], 800., 1e-6);
      check("the gear lags the more under load",
            columns["transmission error"][i] < columns["unloaded transmission error"][i]);
      // Further teeth and points come into contact as the load grows.
      check("the tangent is stiffer than the secant",
            columns["tangent stiffness"][i] > columns["secant stiffness"][i]);
    }
}
