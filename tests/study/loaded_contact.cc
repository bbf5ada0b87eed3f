// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// Loaded tooth contact analysis of a coarse pair by finite elements.
#include "../tests.h"
#include "quick_pair.h"

#include <vfife/base/process/mpi_session.h>

#include <filesystem>

using namespace vfife;

int main(int argc, char **argv)
{
  MpiSession session(argc, argv);
  std::filesystem::remove_all("loaded_contact_results");
  std::ofstream("loaded_contact.prm")
    << quick_pair("set web = none", "set rim rows = 2", "1e-5")
    << "subsection Study\n set kind = loaded tooth contact analysis\nend\n"
    << "subsection Loaded contact\n set positions = 2\nend\n";
  run_pair("loaded_contact.prm", "loaded_contact_results", session.world());

  check("loaded_teeth.csv is written",
        std::filesystem::exists("loaded_contact_results/loaded_teeth.csv"));
  auto columns = read_columns("loaded_contact_results/loaded_contact.csv");
  check("two positions", columns["position"].size() == 2);
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
