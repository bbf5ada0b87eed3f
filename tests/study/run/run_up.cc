// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// A gear pair whose speed grows: angles against the integral of the table, samples and the end of
// the run, orders over the speed; a run that goes on and one that is made longer have the same
// digits; what is refused.
#include "../../refusal.h"
#include "../child_program.h"
#include "../quick_pair.h"

#include <vfife/base/types.h>

using namespace vfife;

/** 20,000 rpm, from 0.05 ms on 2e6 rpm more a second, from 0.25 ms on 20,400 rpm. */
constexpr char table[] = "time [ms],speed [rpm]\n0.05,20000\n0.25,20400\n";

double speed_at(const double time)
{
  return 20000 + 2e6 * std::clamp(time - 5e-5, 0., 2e-4);
}

/** Its integral, in degrees. */
double turn_at(const double time)
{
  const double ramp = std::clamp(time - 5e-5, 0., 2e-4), after = std::max(time - 2.5e-4, 0.);
  return 6 * (20000 * time + 2e6 * (ramp * ramp / 2 + 2e-4 * after));
}

void check_history(const Columns &history)
{
  const auto &time  = history.at("time");
  double      angle = 0, speed = 0, mesh = 0, interval = 0;
  for (std::size_t i = 0; i < time.size(); ++i)
    {
      raise_to(angle,
               std::abs(history.at("pinion angle")[i] - history.at("pinion angle")[0] -
                        turn_at(time[i])));
      raise_to(speed, std::abs(history.at("speed")[i] / speed_at(time[i]) - 1));
      raise_to(mesh, std::abs(history.at("mesh frequency")[i] / (speed_at(time[i]) * 27 / 60) - 1));
      if (i > 1)
        raise_to(interval, std::abs((time[i] - time[i - 1]) / (time[1] - time[0]) - 1));
    }
  check_below("angle of the pinion less the integral of its speed [deg]", angle, 1e-10);
  check_below("column speed", speed, 1e-13);
  check_below("column mesh frequency", mesh, 1e-13);
  check_below("samples are equally spaced", interval, 1e-9);
  // 30 samples in a mesh cycle at 20,400 rpm; the end is the first sample after 3 meshes.
  const double fastest = 20400. * 27 / 60, meshes = turn_at(time.back()) * 27 / 360;
  check_close("samples in a mesh cycle at the largest speed",
              1 / (fastest * (time[1] - time[0])),
              30,
              1e-9);
  check("the end: 3 mesh cycles and less than a sample more", meshes >= 3 && meshes < 3 + 1. / 25);
}

void check_orders()
{
  const auto orders = read_columns("whole/orders.csv");
  check("orders: two windows of two meshes, two orders", orders.at("time").size() == 4);
  bool grows = true;
  for (const double amplitude : orders.at("dte amplitude"))
    grows = grows && amplitude > 0 && amplitude < 30;
  check("orders: amplitudes of arcsec", grows);
  check_ratio("orders: speed at the middle of a window",
              orders.at("speed")[0] / speed_at(orders.at("time")[0]),
              1e-12);
  const auto summary = read_json("whole/summary.json");
  check("no steady part, and no figures that hold at one speed only",
        !summary.contains("steady part") && !summary.at("figures").contains("mesh frequency") &&
          summary.at("figures").contains("mesh frequency at the start"));
}

void check_same(const std::string &name, const std::string &other)
{
  for (const char *file : {"history.csv", "teeth.csv", "orders.csv", "rim_orders.csv"})
    check(name + ", " + file + ": same digits",
          read_text("whole/" + std::string(file)) == read_text(other + "/" + file));
}

/** The file that is shipped, on coarser meshes, with one penalty and over its first
 * millisecond. */
void shipped_file(Communicator &world)
{
  std::vector<std::string> entries = {"Operation/end time=1 ms",
                                      "Output/order window=2",
                                      quick_penalty,
                                      "Output/report=no",
                                      "Output/verbosity=quiet"};
  for (const std::string member : {"Pinion", "Gear"})
    for (const char *cells : {"elements along face width=2", "elements along profile=2"})
      entries.push_back("Gear pair/" + member + "/Mesh/" + cells);
  for (const char *cells : {"elements through web=1",
                            "elements along web=3",
                            "elements through hub=1",
                            "elements beside web=1"})
    entries.push_back(std::string("Gear pair/Gear/Mesh/") + cells);
  run_pair(tree_folder() + "/prm/waves/run_up.prm", "shipped", world, entries);
  const auto orders  = read_columns("shipped/orders.csv"),
             history = read_columns("shipped/history.csv");
  // 7,500 rpm hardly grow in the first of 16 ms: 2000 (2 pi)^2/6 (1/16)^3 rpm.
  check("shipped file: two windows of six orders", orders.at("time").size() == 12);
  check_close("shipped file: speed after 1 ms [rpm]", history.at("speed").back(), 7503.2, .2);
  check("shipped file: contact is kept",
        *std::min_element(history.at("contact force total").begin(),
                          history.at("contact force total").end()) > 0);
  const auto figures = read_json("shipped/summary.json").at("figures");
  check_close("shipped file: damping by its ratio [1/s]",
              figures.at("damping").at("value").get<double>(),
              4 * pi * 3700 * .005,
              1e-9);
}

void refusals(Communicator &world)
{
  const auto refuse = [&](const std::vector<std::string> &overrides, const bool restart = false) {
    print_refusal([&] { run_pair("run_up.prm", "refused", world, overrides, restart); });
  };
  const std::string speed = "Operation/speed=", torque = "Operation/torque=";
  refuse({speed + "20000 - 1e8*t"});
  refuse({speed + "20000 - 1e8*t", "Operation/end time=0.3 ms"});
  refuse({speed + "1e5*t"});
  refuse({torque + "800 + 1e5*t", "Dynamics/start=ramp"});
  refuse({"Study/kind=lumped", speed + "run_up.csv"});
  refuse({"Study/kind=loaded tooth contact analysis", torque + "800 + 1e5*t"});
  // Its samples follow from the end that it was begun for.
  const std::string formula = speed + "20000 + 1e6*t";
  run_pair("run_up.prm", "formula", world, {formula, "Dynamics/maximum number of steps=20"});
  print_refusal([&] {
    run_pair("run_up.prm", "formula", world, {formula, "Operation/mesh cycles=4"}, true);
  });
}

int main(int argc, char **argv)
{
  MpiSession    session(argc, argv);
  Communicator &world = session.world();
  for (const char *folder : {"whole", "parts", "longer", "shipped", "refused", "formula"})
    std::filesystem::remove_all(folder);
  std::ofstream("run_up.csv") << table;
  std::ofstream("run_up.prm") << quick_pair("set body type = rim only",
                                            "set elements through rim = 2",
                                            "1e-4");
  const std::vector<std::string> entries = {"Operation/speed=run_up.csv",
                                            "Operation/torque=800 + 2e5*t",
                                            "Operation/mesh cycles=3",
                                            "Output/samples per mesh cycle=30",
                                            "Output/tracked mesh harmonics=2",
                                            "Output/order window=2"};
  const auto                     with    = [&entries](const std::string &more) {
    std::vector<std::string> all = entries;
    all.push_back(more);
    return all;
  };
  run_pair("run_up.prm", "whole", world, entries);
  check_history(read_columns("whole/history.csv"));
  check_orders();
  run_pair("run_up.prm", "parts", world, with("Dynamics/maximum number of steps=300"));
  run_pair("run_up.prm", "parts", world, entries, true);
  check_same("in two parts", "parts");
  run_pair("run_up.prm", "longer", world, with("Operation/mesh cycles=2"));
  run_pair("run_up.prm", "longer", world, entries, true);
  check("made longer, history.csv: same digits",
        read_text("whole/history.csv") == read_text("longer/history.csv"));
  shipped_file(world);
  refusals(world);
  return 0;
}
