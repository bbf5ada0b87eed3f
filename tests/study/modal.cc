// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// From a parameter file to natural vibrations: the coarsest gear, one sector, two speeds.
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
  std::string modal(const std::string &fem)
  {
    return coarse_pair("", coarse_web) + R"(
subsection Study
  set kind = modal
end
subsection Operation
  set speed  = 20000 rpm
  set torque = 800 N m
end
subsection Fem
)" + fem + "end\n";
  }

  nlohmann::json read_json(const std::string &path)
  {
    std::ifstream      file(path);
    std::ostringstream text;
    text << file.rdbuf();
    return nlohmann::json::parse(text.str());
  }

  std::size_t column(const nlohmann::json &table, const std::string &name)
  {
    for (std::size_t i = 0; i < table.at("columns").size(); ++i)
      if (table.at("columns")[i].at("name") == name)
        return i;
    throw std::runtime_error("no column " + name);
  }
} // namespace

int main(int argc, char **argv)
{
  MpiSession session(argc, argv);
  std::filesystem::remove_all("modal_results");
  std::ofstream("modal.prm") << modal(
    "set bodies = gear\nset modes = 3\nset cyclic symmetry = yes\n"
    "set largest nodal diameter = 2\nset speeds = 0, 10000\n"
    "set mesh orders = 1\n");
  run_pair("modal.prm", "modal_results", session.world());
  for (const char *file : {"modes.csv",
                           "modes.json",
                           "campbell.csv",
                           "campbell.json",
                           "resonances.csv",
                           "modes/gear_0_rpm.vtu",
                           "modes/gear_10000_rpm.vtu"})
    check(std::string(file) + " is written",
          std::filesystem::exists(std::string("modal_results/") + file));

  const nlohmann::json table = read_json("modal_results/modes.json");
  const nlohmann::json rows  = table.at("rows");
  check("three modes for each diameter and speed", rows.size() == 18);
  const std::size_t speed = column(table, "speed"), frequency = column(table, "frequency"),
                    diameter = column(table, "nodal diameter");
  check("the hub turns freely", rows[0][diameter] == 0 && rows[0][frequency].get<double>() < 1.);
  // The first umbrella or tilting mode: spin stiffens the web, which spins in tension.
  double at_rest = 0, spun = 0;
  for (const auto &row : rows)
    if (row[diameter] == 1)
      {
        double &lowest = row[speed] == 0 ? at_rest : spun;
        if (lowest == 0)
          lowest = row[frequency].get<double>();
      }
  check("tilting mode between 0.3 and 6 kHz", at_rest > 300 && at_rest < 6000);
  check("spin changes it by less than 20 %, and does",
        std::abs(spun / at_rest - 1) < .2 && spun != at_rest);

  const auto refusal = [&session](const std::string &bodies) {
    std::ofstream("modal.prm") << modal("set bodies = " + bodies + "\n");
    return message_of([&] { run_pair("modal.prm", "modal_results", session.world()); });
  };
  check("a misspelt body is named",
        refusal("geer").find("did you mean \"gear\"") != std::string::npos);
  const std::string unlike = refusal("flywheel");
  check("bodies are listed where none is alike",
        unlike.find("did you mean") == std::string::npos &&
          unlike.find("there is no body \"flywheel\" (bodies: pinion, gear)") != std::string::npos);
}
