// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// Study kind lumped: by values with a sweep, and with inertias of a gear pair's bodies and a table;
// lumped.json of made-up results.
#include "../../lumped/pair.h"
#include "../../read_files.h"
#include "../../refusal.h"
#include "../quick_pair.h"

#include <vfife/base/process/mpi_session.h>
#include <vfife/lumped/speed_sweep.h>
#include <vfife/study/gear/lumped_study.h>

#include <filesystem>

using namespace vfife;

double number(const nlohmann::json &json, const char *part, const char *name)
{
  return json.at(part).at(name).at("value").get<double>();
}

/** One inertia on one spring, with a sweep of three speeds up and down. */
void made_up_results()
{
  LumpedPair pair   = linear_pair();
  pair.law.backlash = 300 * arcsecond;
  const LumpedModel model(pair);
  Table             sweep    = make_resonance_response_table();
  const double      speeds[] = {100, 200, 300, 300, 200, 100}; // [rad/s]
  const double      swings[] = {4, 5, 20, 21, 4.5, 30};        // [arcsec]
  for (unsigned int i = 0; i < 6; ++i)
    {
      LumpedResponse at_speed;
      at_speed.pp_error   = swings[i] * arcsecond;
      at_speed.time_apart = i == 4 ? .3 : 0;
      add_response(i < 3 ? "up" : "down", speeds[i], model.pair().driver_teeth, at_speed, sweep);
    }
  const nlohmann::json json  = make_lumped_json(model, made_up_response(), 100 * pi, sweep);
  const auto           close = [&json](const char *part, const char *name, const double expected) {
    check_close(std::string("made up: ") + name,
                number(json, part, name),
                expected,
                1e-12 * expected);
  };
  close("model", "torque on the gear", 800); // N m
  close("model", "gear inertia", 20000);     // kg mm^2
  close("model", "pinion inertia", 300);
  close("model",
        "inertia of the torsional mode, at the gear",
        20000); // the pinion turns as prescribed
  close("model", "mesh stiffness, mean at the torque", 2.2e6);
  close("model", "lever arm", 90);
  close("model", "backlash angle of the gear", 300);
  close("response", "speed", 3000);
  close("response", "mean dte", 11);
  close("response", "rms dte", 12);
  close("response", "peak to peak dte", 13);
  close("response", "mean force", 14);
  close("response", "rms force", 15);
  close("response", "peak to peak force", 16);
  close("response", "losses of contact", 18);
  close("response", "time without contact", .19);
  close("response", "time on coast flanks", .2);
  close("response", "energy error", .21);
  // The pinion's speeds at which harmonics 1, 2, 3 of 27 teeth meet the swing.
  const double frequency = std::sqrt(2.2e9 / 20) / (2 * pi);
  const auto  &critical =
    json.at("modes")[0].at("critical pinion speeds of mesh orders 1, 2, 3 [rpm]");
  for (unsigned int k = 1; k <= 3; ++k)
    check_close("made up: critical speed [rpm]",
                critical[k - 1].get<double>(),
                60 * frequency / (27. * k),
                1e-8);
  close("sweep", "largest peak to peak dte", 30);
  close("sweep", "at the speed", 100 * 30 / pi);
  // At 100 rad/s 4 going up, 30 going down.
  close("sweep", "largest difference of both directions", 26);
  close("sweep", "difference at the speed", 100 * 30 / pi);
  const auto &lost = json.at("sweep").at("contact lost at");
  check("made up: contact lost once",
        lost.size() == 1 && lost[0].at("direction") == "down" &&
          std::abs(lost[0].at("speed [rpm]").get<double>() - 200 * 30 / pi) < 1e-9);
}

void refuse(const std::string &lines, Communicator &world)
{
  std::ofstream("wrong.prm") << "subsection Study\n set kind = lumped\nend\n"
                             << "subsection Operation\n set speed = 20000 rpm\n"
                             << " set torque = 800 N m\nend\nsubsection Lumped\n"
                             << lines << "end\n";
  print_refusal([&] { run_case("wrong.prm", "lumped_results", world); });
}

int main(int argc, char **argv)
{
  MpiSession session(argc, argv);
  std::filesystem::remove_all("lumped_results");
  made_up_results();
  std::ofstream("values.prm")
    << "include " << tree_folder()
    << "/prm/lumped/torsional_pair.prm\n"
       "subsection Lumped\n set speeds = 5\n set settling mesh cycles = 300\n"
       " set recorded mesh cycles = 5\n set report = no\nend\n";
  run_case("values.prm", "lumped_results", session.world());
  const nlohmann::json values = read_json("lumped_results/lumped.json");
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
  check("64 samples in five mesh cycles", motion["dte"].size() == 320);
  std::ifstream sweep("lumped_results/resonance.csv");
  unsigned int  rows = 0;
  for (std::string line; std::getline(sweep, line);)
    ++rows;
  check("five speeds up, five down", rows == 11);

  // Upwards only: the same rows as before the turn.
  const auto both = read_columns("lumped_results/resonance.csv");
  std::ofstream("up.prm") << "include values.prm\nsubsection Lumped\n set sweep = up\nend\n";
  std::filesystem::remove_all("lumped_results");
  run_case("up.prm", "lumped_results", session.world());
  const auto up   = read_columns("lumped_results/resonance.csv");
  bool       same = up.at("speed").size() == 5;
  for (const auto &[name, numbers] : up)
    same = same && numbers == std::vector<double>(both.at(name).begin(), both.at(name).begin() + 5);
  check("five speeds up, as when the sweep comes down again", same);

  std::ofstream("table.csv")
    << "position [mesh cycles],unloaded transmission error [arcsec],transmission error [arcsec],"
       "contact torque on the gear [N m],tangent stiffness [N m/rad]\n"
       "0,1,-54,800,3.8e6\n0.5,-1,-56,800,3.7e6\n";
  // The kind knows no Dynamics and no Output.
  const std::string all =
    quick_pair("set body type = rim only", "set elements through rim = 2", "1e-5");
  std::ofstream("pair.prm")
    << all.substr(0, all.find("subsection Dynamics"))
    << "subsection Study\n set kind = lumped\nend\n"
       "subsection Lumped\n set mesh = loaded contact\n"
       " set table = table.csv\n set settling mesh cycles = 100\n"
       " set recorded mesh cycles = 5\n set report = no\n set supports = axial, tilt\n"
       " subsection Support axial\n set direction = 0, 0, 1\n"
       " set mass = 1.7 kg\n set stiffness = 1e6\n end\n"
       " subsection Support tilt\n set motion = tilt\n"
       " set direction = 0, 1, 0\n set inertia = 9000\n"
       " set tilt stiffness = 1 MN m/rad\n end\nend\n";
  run_case("pair.prm", "lumped_results", session.world());
  const nlohmann::json pair = read_json("lumped_results/lumped.json");
  check("three modes", pair.at("modes").size() == 3);
  check_close("mean tangent stiffness of the table [N m/rad]",
              number(pair, "model", "mesh stiffness, mean at the torque"),
              3.75e6,
              2e3);
  // 0.12 mm along the normal at the mean point; the arms of both sides differ a little.
  check_close("backlash of the pair [arcsec]",
              number(pair, "model", "backlash angle of the gear") * arcsecond,
              .12 / number(pair, "model", "lever arm"),
              2e-2 * .12 / 90);
  check_close("arm of the pair: force under the torque [N]",
              number(pair, "response", "mean force"),
              8e5 / number(pair, "model", "lever arm"),
              .01 * 8e5 / 90);
  check_below("energy error", number(pair, "response", "energy error"), 1e-6);

  // The stiffness of the table is that of the cold pair.
  std::ofstream("warm.prm") << "include pair.prm\n"
                            << "subsection Gear pair\n subsection Gear\n"
                            << "  set temperature = 60\n end\nend\n";
  std::filesystem::remove_all("lumped_results");
  run_case("warm.prm", "lumped_results", session.world());
  check("warm pair: a warning",
        read_text("lumped_results/run.log").find("a temperature acts in the lumped model only") !=
          std::string::npos);

  refuse(" set stiffness = 2 MN m/rad\n", session.world());
  refuse(" set stiffness = 2 MN m/rad\n set stiffness cosines = 0.7, 0.4\n set pinion teeth = 27\n"
         " set gear teeth = 79\n set gear inertia = 1\n set lever arm = 90\n set backlash = 0\n",
         session.world());
  refuse(" set mesh = loaded contact\n set table = nothing.csv\n set pinion teeth = 27\n"
         " set gear teeth = 79\n set gear inertia = 1\n set lever arm = 90\n set backlash = 0\n",
         session.world());
  refuse(" set stiffness = 2 MN m\n", session.world());
  return 0;
}
