// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// From a parameter file to results: one tooth mesh of a coarse pair with a conical web.
#include "../tests.h"
#include "quick_pair.h"

#include <vfife/base/process/mpi_session.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>
#include <numeric>

using namespace vfife;

int main(int argc, char **argv)
{
  MpiSession session(argc, argv);
  std::filesystem::remove_all("gear_pair_results");
  std::ofstream("gear_pair.prm") << quick_pair(
    "set web = conical\nset web thickness = 5 mm\nset web angle = 70 deg", coarse_web, "1e-5");
  run_pair("gear_pair.prm", "gear_pair_results", session.world());

  for (const char *file : {"parameters.prm", "run.log", "history.csv", "teeth.csv", "summary.json"})
    check(std::string(file) + " is written",
          std::filesystem::exists(std::string("gear_pair_results/") + file));
  std::ifstream      file("gear_pair_results/summary.json");
  std::ostringstream text;
  text << file.rdbuf();
  const nlohmann::json summary = nlohmann::json::parse(text.str());
  check("the run is complete", summary.at("status") == "finished");

  auto        columns = read_columns("gear_pair_results/history.csv");
  const auto &dte = columns["dte"], &force = columns["contact force total"],
             &torque       = columns["contact torque on the gear"];
  const double mean_force  = std::accumulate(force.begin(), force.end(), 0.) / force.size();
  const double mean_torque = std::accumulate(torque.begin(), torque.end(), 0.) / torque.size();
  const auto   lag         = std::minmax_element(dte.begin(), dte.end());
  const double at_rest =
    summary.at("figures").at("torque over effective arm").at("value").get<double>();
  // The mean normals of the flanks differ from that of the mean contact, and 0.1 ms are less than a
  // swing.
  check_close("mean contact force over torque over arm", mean_force / at_rest, 1., 0.1);
  // The start is the equilibrium to 1e-5 of all forces, the centrifugal ones included, some 10^2 of
  // the contact's.
  check_close("contact torque at the start [N m]", torque.front(), 800., 1.);
  check_close("mean contact torque over the load", mean_torque / 800., 1., 0.1);
  check("samples of one tooth mesh", force.size() == 99);
  check("the gear lags by 20 to 200 arcsec", *lag.first > -200 && *lag.second < -20);
}
