// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// A coarse pair without web on a rigid hub whose torque grows from nothing: flanks that just touch,
// the balance of angular momentum, and a run that ends after a number of steps.
#include "../tests.h"
#include "quick_pair.h"

#include <vfife/base/process/mpi_session.h>
#include <vfife/base/types.h>

#include <nlohmann/json.hpp>

#include <filesystem>

using namespace vfife;

namespace
{
  nlohmann::json read_summary(const std::string &folder)
  {
    std::ifstream file(folder + "/summary.json");
    return nlohmann::json::parse(file);
  }

  double figure(const nlohmann::json &summary, const std::string &name)
  {
    return summary.at("figures").at(name).at("value").get<double>();
  }
} // namespace

int main(int argc, char **argv)
{
  MpiSession session(argc, argv);
  std::filesystem::remove_all("ramp_results");
  std::ofstream("ramp.prm") << quick_pair("set web = none", "set rim rows = 2", "1e-5") +
                                 "subsection Operation\n  set hub = rigid hub\n"
                                 "  set ramp = 0.5\nend\n"
                                 "subsection Dynamics\n  set start = ramp\n"
                                 "  set damping = 0\n  set mesh damping = 0\nend\n";
  run_pair("ramp.prm", "ramp_results", session.world());

  auto        columns = read_columns("ramp_results/history.csv");
  const auto &time = columns["time"], &angle = columns["gear angle"],
             &torque       = columns["contact torque on the gear"];
  const auto   summary     = read_summary("ramp_results");
  const double inertia     = summary.at("mesh").at("bodies").at(1).at("axial inertia").at("value");
  const double mesh_period = 1. / figure(summary, "mesh frequency");
  // A thousandth of 800 N m, found to 1e-5 of all forces: the centrifugal ones are some 10^2 of the
  // contact's at full load.
  check_close("contact torque at the start [N m]", torque.front(), 0.8, 0.8);
  // The lag grows with the load: I d omega = integral of contact torque - load.
  double impulse = 0;
  for (std::size_t i = 1; i < time.size(); ++i)
    {
      const double middle = 0.5 * (time[i] + time[i - 1]);
      const double load   = 800 * std::min(1., middle / (0.5 * mesh_period));
      impulse += (0.5 * (torque[i] + torque[i - 1]) - load) * (time[i] - time[i - 1]);
    }
  const std::size_t last = time.size() - 1, n = 10;
  const double      rate_end   = (angle[last] - angle[last - n]) / (time[last] - time[last - n]);
  const double      rate_start = (angle[n] - angle[0]) / (time[n] - time[0]);
  const double      gain       = inertia * (rate_end - rate_start) * pi / 180;
  // Rates over a tenth of the run at either end, and of the rim's underside instead of the whole
  // gear, which still vibrates: a full torque from the start would change the impulse by a third.
  check_close("angular momentum over the impulse", gain / impulse, 1., 0.15);
  check("the load slows the gear down", impulse < 0);
  check("the swing's stiffness is that of the pair: some 10^6 N m/rad",
        figure(summary, "torsional stiffness") > 1e6 &&
          figure(summary, "torsional stiffness") < 1e7);

  std::filesystem::remove_all("part_results");
  std::ofstream("part.prm") << "include ramp.prm\nsubsection Dynamics\n"
                               "  set largest number of steps = 100\nend\n";
  run_pair("part.prm", "part_results", session.world());
  const auto part = read_summary("part_results");
  check("a part of the run is a finished run",
        part.at("status") == "finished" && part.at("run").at("steps") == 100);
  check("too short for a steady part", !part.at("steady part").at("found").get<bool>());
  auto part_columns = read_columns("part_results/history.csv");
  bool same         = true;
  for (std::size_t i = 0; i < part_columns["dte"].size(); ++i)
    same = same && part_columns["dte"][i] == columns["dte"][i];
  check("the part has the same digits", same && part_columns["dte"].size() >= 5);
}
