// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// Study kind `reduced` beside an explicit run of the same file; what it refuses.
#include "../../parts.h"
#include "../../read_files.h"
#include "../../refusal.h"
#include "../few_teeth.h"

#include <vfife/base/text/column_names.h>

#include <filesystem>

using namespace vfife;

std::string pair_text(const std::string &kind)
{
  return quick_pair("set body type = conical web", coarse_web, "1e-6") +
         "subsection Study\n set kind = " + kind + "\nend\n";
}

/** A reduced pair whose bodies are made and moved in a third of the time, for what needs no run
 * beside it. */
std::string few_teeth_text()
{
  return quick_few_teeth("set body type = conical web", coarse_web, "1e-6") +
         "subsection Study\n set kind = reduced\nend\n";
}

Columns run_pair_of_kind(const std::string &kind, Communicator &world)
{
  std::ofstream(kind + "_pair.prm") << pair_text(kind);
  std::vector<std::string> entries = {"Operation/mesh cycles=2",
                                      "Dynamics/start=static equilibrium"};
  if (kind == "reduced")
    entries.emplace_back("Reduced/store=bodies");
  run_pair(kind + "_pair.prm", kind + "_pair", world, entries);
  return read_columns(kind + "_pair/history.csv");
}

std::vector<std::string> names_of(const Columns &columns)
{
  std::vector<std::string> names;
  for (const auto &column : columns)
    names.push_back(column.first);
  return names;
}

void beside_run(Communicator &world)
{
  Columns run = run_pair_of_kind("run", world), reduced = run_pair_of_kind("reduced", world);
  check("columns of a run", names_of(run) == names_of(reduced));
  check("samples of a run", run["time"].size() == reduced["time"].size());
  // Whole bodies deform nonlinearly, here 4e-4; the equilibrium's waves are differences over
  // sectors there and exact here.
  check_ratio("transmission error at the start", reduced["dte"][0] / run["dte"][0], 2e-3);
  check_ratio("its mean", mean_of(reduced["dte"]) / mean_of(run["dte"]), 2e-3);
  check_ratio("of the rim", mean_of(reduced["rim dte"]) / mean_of(run["rim dte"]), 2e-3);
  check_ratio("contact force",
              mean_of(reduced["contact force total"]) / mean_of(run["contact force total"]),
              3e-3);
  double distance = 0, ripple = 0;
  for (std::size_t i = 0; i < run["dte"].size(); ++i)
    {
      distance += std::pow(reduced["dte"][i] - run["dte"][i], 2);
      ripple += std::pow(run["dte"][i] - mean_of(run["dte"]), 2);
    }
  check_below("curve of two mesh cycles over its ripple", std::sqrt(distance / ripple), .1);

  const auto probes = read_columns("run_pair/probes.csv"),
             same   = read_columns("reduced_pair/probes.csv");
  // Displacements along theta are counted from other rotations: of the momentum here, of the hub
  // at the start there.
  for (const char *column : {"displacement r", "displacement z", "von mises"})
    {
      const std::string over       = std::string(column) == "von mises" ? column : "displacement r";
      double            difference = 0, largest = 0;
      for (std::size_t i = 0; i < probes.at(column).size(); ++i)
        {
          difference += std::abs(same.at(column)[i] - probes.at(column)[i]);
          raise_to(largest, std::abs(probes.at(over)[i]));
        }
      check_below(std::string("probes: ") + column,
                  difference / probes.at(column).size() / largest,
                  5e-2);
    }
  const auto rim = read_columns("run_pair/rim.csv"), waves = read_columns("reduced_pair/rim.csv");
  for (const char *column : {"r cos 0", "z cos 1", "z sin 1", "z cos 2", "r sin 3"})
    {
      // Over the largest of all waves.
      double difference = 0, largest = 0;
      for (std::size_t i = 0; i < rim.at(column).size(); ++i)
        {
          raise_to(difference, std::abs(waves.at(column)[i] - rim.at(column)[i]));
          raise_to(largest, std::abs(rim.at("z cos 1")[i]));
        }
      check_below(std::string("rim: ") + column, difference / largest, 3e-2);
    }
  check("teeth, pattern, summary",
        std::filesystem::exists("reduced_pair/teeth.csv") &&
          std::filesystem::exists("reduced_pair/pattern.csv") &&
          read_json("reduced_pair/summary.json").at("status") == "finished");
  const auto summary = read_json("reduced_pair/summary.json"),
             of_run  = read_json("run_pair/summary.json");
  const auto swing   = [](const nlohmann::json &s) {
    return s.at("figures").at("torsional mode frequency, estimated").at("value").get<double>();
  };
  check_ratio("swing", swing(summary) / swing(of_run), 1e-2);
  check_below("energy", std::abs(reduced["energy error"].back()), 2e-3);
}

/** Upwards and downwards: each speed from the motion at the one before, so nothing jumps. */
void speeds(Communicator &world)
{
  std::ofstream("sweep.prm") << few_teeth_text();
  run_pair("sweep.prm",
           "sweep",
           world,
           {"Reduced/sweep=up and down",
            "Reduced/lowest speed=12000 rpm",
            "Reduced/highest speed=20000 rpm",
            "Reduced/speeds=2",
            "Reduced/settling mesh cycles=12",
            "Reduced/recorded mesh cycles=3",
            "Reduced/cutoff frequency=20 kHz",
            "Output/samples per mesh cycle=10"});
  const Columns response = read_columns("sweep/resonance.csv"),
                waves    = read_columns("sweep/wave_response.csv");
  check("a row a speed and direction", response.at("speed").size() == 4);
  const std::vector<double> expected = {12000, 20000, 20000, 12000};
  double                    worst    = 0;
  for (std::size_t i = 0; i < 4; ++i)
    {
      raise_to(worst, std::abs(response.at("speed")[i] / expected[i] - 1.));
      raise_to(worst, std::abs(response.at("mesh frequency")[i] / (expected[i] / 6.) - 1.));
    }
  check_below("speeds in their order", worst, 1e-12);
  // What is left of the swing when speeds change, here after 1.3 ms.
  check_ratio("the same speed again: transmission error",
              response.at("mean dte")[2] / response.at("mean dte")[1],
              4e-3);
  check_ratio("the first speed again",
              response.at("mean dte")[3] / response.at("mean dte")[0],
              2e-3);
  // Spin takes both flanks outwards.
  check("faster, less lag", response.at("mean dte")[1] > response.at("mean dte")[0] + 1.);
  check_ratio("a wave that stands in space does so at all speeds",
              waves.at("stationary wave 1")[3] / waves.at("stationary wave 1")[1],
              2e-2);
  check("waves run little beside it",
        waves.at("travelling wave 1")[2] < .2 * waves.at("stationary wave 1")[2]);
  check("contact is not lost", response.at("losses of contact")[3] == 0);
  // The summary has range, time and steps of all speeds.
  const auto summary = read_json("sweep/summary.json");
  const auto figure  = [&](const char *name) {
    return summary.at("figures").at(name).at("value").get<double>();
  };
  check_close("lowest speed [rpm]", figure("lowest speed"), 12000, 1e-9);
  check_close("highest speed [rpm]", figure("highest speed"), 20000, 1e-9);
  double meshes = 0;
  for (const double frequency : response.at("mesh frequency"))
    meshes += 1. / frequency;
  check("time of 15 mesh cycles and what the low pass takes",
        summary.at("run").at("time").at("value").get<double>() > 15 * meshes &&
          summary.at("run").at("time").at("value").get<double>() < 24 * meshes);
  check("steps of 15 mesh cycles of 10 or more at each speed",
        summary.at("run").at("steps").get<double>() > 4 * 15 * 10);
  check("speeds too far apart are said",
        has_text(summary.at("warnings").dump(), "the speeds are 8000 rpm apart"));
}

/** Stresses over speed: so slowly that hardly anything vibrates, and faster. */
void stresses(Communicator &world)
{
  std::ofstream("stresses.prm") << pair_text("reduced");
  const auto sweep =
    [&](const std::string &folder, const std::string &lowest, const std::string &frequency) {
      // Strong dampers: four of their decay times are few mesh cycles.
      run_pair("stresses.prm",
               folder,
               world,
               {"Reduced/sweep=up",
                "Reduced/lowest speed=" + lowest,
                "Reduced/highest speed=18000 rpm",
                "Reduced/speeds=2",
                "Reduced/settling mesh cycles=1",
                "Reduced/settling decay times=4",
                "Reduced/recorded mesh cycles=1",
                "Dynamics/mass proportional damping=6000",
                "Reduced/cutoff frequency=20 kHz",
                "Reduced/store=bodies_to_20_kHz",
                "Reduced/allowed amplification=1.03",
                "Reduced/highest frequency=" + frequency,
                "Fillets/teeth=all",
                "Output/samples per mesh cycle=50"});
    };
  sweep("stresses", "150 rpm", "20 kHz");
  const Columns stress = read_columns("stresses/stress_response.csv");
  const Table   table  = read_result_table("stresses/stress_response.csv");
  const auto   &places = table.column("place").texts;
  check("a row a speed and place",
        places == std::vector<std::string>({"node A front",
                                            "node A back",
                                            "concave fillet",
                                            "convex fillet",
                                            "node A front",
                                            "node A back",
                                            "concave fillet",
                                            "convex fillet"}));
  for (std::size_t i = 0; i < 4; ++i)
    {
      check_ratio(places[i] + ", slowly", stress.at("amplification")[i], 5e-3);
      check(places[i] + ", faster: vibrates",
            stress.at("amplification")[i + 4] > stress.at("amplification")[i]);
    }
  // Without vibration: in some position of the mesh more than in the equilibrium that a reduced
  // pair at that speed starts from.
  std::ofstream("one_speed.prm") << pair_text("reduced");
  const auto start = [&](const std::string &speed) {
    run_pair("one_speed.prm",
             "one_speed",
             world,
             {"Operation/speed=" + speed,
              "Operation/mesh cycles=1",
              "Dynamics/start=static equilibrium",
              "Reduced/cutoff frequency=20 kHz",
              "Reduced/store=bodies_to_20_kHz",
              "Fillets/teeth=all",
              "Output/stress wave diameters=1"});
    return read_columns("one_speed/probe_waves.csv").at("largest von mises");
  };
  const std::vector<double> slow = start("150 rpm"), fast = start("18000 rpm"),
                            &rest = stress.at("stress without vibration");
  for (unsigned int p = 0; p < 2; ++p)
    {
      check(places[p] + ": more in some position of the mesh",
            rest[p] > slow[p] && rest[p] < 1.1 * slow[p]);
      check(places[p] + ": of this speed", rest[p + 4] > fast[p] && rest[p + 4] < 1.1 * fast[p]);
    }
  // Without any vibration of the mesh's orders what passes the sectors with the mesh is left.
  sweep("slow_stresses", "17999 rpm", "4 kHz");
  const Columns without = read_columns("slow_stresses/stress_response.csv");
  for (unsigned int p = 0; p < 4; ++p)
    check_ratio(places[p] + ", faster without vibration", without.at("amplification")[p], 2e-2);
  const Columns ranges         = read_columns("stresses/exceedances.csv");
  const auto   &amplifications = ranges.at("largest amplification");
  check("exceedances are above what is allowed",
        !amplifications.empty() &&
          *std::min_element(amplifications.begin(), amplifications.end()) > 1.03);
}

/** Speed and torque over time, beside a run. */
void run_up(Communicator &world)
{
  const auto turn = [&](const std::string &kind) {
    std::ofstream(kind + "_up.prm") << pair_text(kind);
    run_pair(kind + "_up.prm",
             kind + "_up",
             world,
             {"Operation/speed=16000 + 5e6*t",
              "Operation/torque=800 - 1e5*t",
              "Operation/end time=0.5 ms",
              "Output/tracked mesh harmonics=2",
              "Output/order window=2"});
    return read_columns(kind + "_up/history.csv");
  };
  Columns run = turn("run"), reduced = turn("reduced");
  check("run-up: samples", run["time"].size() == reduced["time"].size());
  check_ratio("turn", reduced["pinion angle"].back() / run["pinion angle"].back(), 1e-9);
  check_ratio("speed", reduced["speed"].back() / run["speed"].back(), 1e-9);
  // The gear's inertia is carried by the flanks from the first step on.
  check("the contact carries more than the torque",
        mean_of(run["contact torque on the gear"]) > 1500.);
  double distance = 0, ripple = 0;
  for (std::size_t i = 0; i < run["dte"].size(); ++i)
    {
      distance += std::pow(reduced["dte"][i] - run["dte"][i], 2);
      ripple += std::pow(run["dte"][i] - mean_of(run["dte"]), 2);
    }
  check_below("curve over its own", std::sqrt(distance / ripple), 3e-2);
  for (const char *column :
       {"contact torque on the gear", "kinetic energy", "work of the drive", "work of the torques"})
    check_ratio(column, mean_of(reduced[column]) / mean_of(run[column]), 3e-3);
  Columns orders = read_columns("run_up/orders.csv"), same = read_columns("reduced_up/orders.csv");
  check("orders",
        orders.at("dte amplitude").size() == same.at("dte amplitude").size() &&
          !same.at("dte amplitude").empty());
}

/** Bodies that are kept. */
void store(Communicator &world)
{
  std::filesystem::remove_all("kept");
  std::ofstream("store.prm") << few_teeth_text();
  const auto turn = [&](const std::string &folder, std::vector<std::string> entries) {
    entries.emplace_back("Reduced/store=kept");
    entries.emplace_back("Operation/mesh cycles=1");
    run_pair("store.prm", folder, world, entries);
  };
  turn("store_first", {});
  const std::string first = read_text("kept/gear.reduction");
  turn("store_second", {"Operation/torque=800 N m"});
  check("kept bodies: the same history",
        read_text("store_second/history.csv") == read_text("store_first/history.csv"));
  check("bodies of a file, not reduced ones",
        has_text(read_text("store_second/run.log"), "from \"kept\"") &&
          !has_text(read_text("store_first/run.log"), "from \"kept\""));
  // Slower and under another torque they serve as well.
  turn("store_slower", {"Operation/speed=15000 rpm", "Operation/torque=500 N m"});
  check("another speed and torque",
        has_text(read_text("store_slower/run.log"), "from \"kept\"") &&
          first == read_text("kept/gear.reduction"));
  const auto refuse = [&](const std::vector<std::string> &entries) {
    print_refusal([&]() { turn("store_refused", entries); });
  };
  refuse({"Gear pair/Gear/Body/web thickness=7 mm"});
  refuse({"Material steel/density=7000 kg/m^3"});
  std::string damaged = first;
  damaged[damaged.size() / 2] ^= 1;
  std::ofstream("kept/gear.reduction", std::ios::binary) << damaged;
  refuse({});
  std::ofstream("kept/gear.reduction", std::ios::binary) << first.substr(0, 1000);
  check("a cut file is refused",
        has_text(message_of([&] { turn("store_refused", {}); }), "is damaged: it has"));
  std::ofstream("kept/gear.reduction", std::ios::binary) << "something else, long enough for a "
                                                            "header and whatever comes behind it";
  refuse({});
  std::filesystem::remove("kept/gear.reduction");
  // For more than the bodies are kept for they are reduced again.
  turn("store_again", {"Reduced/residual flexibility reach=5", "Reduced/export=yes"});
  check("matrices for other programs",
        std::filesystem::exists("store_again/gear_stiffness.mtx") &&
          std::filesystem::exists("store_again/pinion_rows.csv") &&
          !std::filesystem::exists("store_slower/gear_stiffness.mtx"));
  check("more than is kept",
        has_text(read_text("store_again/run.log"), "the body is reduced again") &&
          read_text("kept/gear.reduction").size() > first.size());
}

/** Stopped in the middle of a mesh cycle, between two samples. */
void goes_on(Communicator &world)
{
  std::ofstream("goes_on.prm") << few_teeth_text();
  const std::vector<std::string> all = {"Operation/mesh cycles=3", "Reduced/store=few_bodies"};
  run_pair("goes_on.prm", "whole", world, all);
  run_pair("goes_on.prm",
           "parts",
           world,
           {"Operation/mesh cycles=3",
            "Reduced/store=few_bodies",
            "Dynamics/maximum number of steps=111"});
  check("stopped where it was asked to",
        read_columns("parts/history.csv").at("time").size() <
          read_columns("whole/history.csv").at("time").size() / 2);
  run_pair("goes_on.prm", "parts", world, all, true);
  for (const char *table : {"history.csv", "probes.csv", "rim.csv"})
    {
      const Columns whole = read_columns("whole/" + std::string(table)),
                    parts = read_columns("parts/" + std::string(table));
      check(std::string(table) + ": as many samples",
            whole.at("time") == parts.at("time") && whole.at("time").size() > 20);
      double worst = 0;
      for (const auto &[name, values] : whole)
        if (name != "energy error")
          {
            double difference = 0, largest = 1e-12;
            for (std::size_t i = 0; i < values.size(); ++i)
              {
                raise_to(difference, std::abs(values[i] - parts.at(name)[i]));
                largest = std::max(largest, std::abs(values[i]));
              }
            raise_to(worst, difference / largest);
          }
      check_below(std::string(table) + ": to round-off", worst, 1e-8);
    }
  const auto whole = read_json("whole/summary.json"), parts = read_json("parts/summary.json");
  check("parts of the transmission error in the summary",
        whole.at("transmission error") == parts.at("transmission error"));
  print_refusal([&]() {
    run_pair("goes_on.prm",
             "parts",
             world,
             {"Reduced/store=few_bodies", "Operation/torque=700 N m"},
             true);
  });
}

/** Strong dampers need 6 mesh cycles; the swing of this soft web may need more. A run that goes
 * on length by length is that of the last length, also where it was stopped before. */
void until_steady(Communicator &world)
{
  std::ofstream("steady.prm") << pair_text("reduced");
  const auto turn = [&](const std::string &folder, const std::string &meshes, bool goes_on) {
    std::vector<std::string> entries = {"Operation/mesh cycles=" + meshes,
                                        "Operation/maximum mesh cycles=14",
                                        "Reduced/cutoff frequency=9 kHz",
                                        "Reduced/store=bodies_to_9_kHz",
                                        "Dynamics/mass proportional damping=20000",
                                        "Dynamics/driven speed damping=20000"};
    if (folder == "steady_parts" && !goes_on)
      entries.emplace_back("Dynamics/maximum number of steps=150");
    run_pair("steady.prm", folder, world, entries, goes_on);
    return read_columns(folder + "/history.csv");
  };
  const Columns     steady = turn("steady", "until steady", false);
  const std::string log    = read_text("steady/run.log");
  check("still transient after 6 mesh cycles: the run continues to 9",
        has_text(log, "still transient after 6 mesh cycles: the run continues to 9"));
  const auto part      = read_json("steady/summary.json").at("steady part");
  const bool is_steady = part.at("found").get<bool>() && part.at("ripple").at("steady").get<bool>();
  check("ends where it is steady, or at the limit",
        is_steady == has_text(log, "the ripple is steady within") &&
          !is_steady == has_text(log, "the ripple is still transient after 14"));
  const auto meshes = static_cast<unsigned int>(std::lround((steady.at("time").size() - 1) / 98.));
  const Columns given = turn("given", std::to_string(meshes), false);
  turn("steady_parts", "until steady", false);
  const std::string ended = read_text("steady_parts/run.log");
  check("a limit of steps ends the run, which is not judged", !has_text(ended, "steady after"));
  check("damping is stated", has_text(ended, "damping 20000 1/s: ratio"));
  const Columns parts = turn("steady_parts", "until steady", true);
  for (const Columns *other : {&given, &parts})
    check_below("the same motion [arcsec]",
                largest_difference(steady.at("dte"), other->at("dte")),
                1e-7);
  const auto refuse = [&](const std::vector<std::string> &entries) {
    print_refusal([&] { run_pair("steady.prm", "refused", world, entries); });
  };
  refuse({"Operation/mesh cycles=until steady", "Output/checkpoint interval=0"});
  refuse({"Operation/mesh cycles=until steady",
          "Dynamics/mass proportional damping=0",
          "Dynamics/driven speed damping=0"});
  refuse({"Operation/mesh cycles=steady"});
}

void refusals(Communicator &world)
{
  const auto refuse = [&](const std::string &entry, const std::string &value) {
    std::ofstream("refused.prm") << few_teeth_text();
    print_refusal([&]() { run_pair("refused.prm", "refused", world, {entry + "=" + value}); });
  };
  refuse("Dynamics/start", "ramp");
  refuse("Dynamics/damping reference", "mean speed");
  refuse("Contact/friction coefficient", "0.1");
  refuse("Operation/driving member", "gear");
  refuse("Reduced/sweep", "up");
  refuse("Operation/speed", "20000 - 1e9*t");
  refuse("Reduced/cutof frequency", "3 kHz");
  // Of sweeps over speed.
  const std::vector<std::vector<std::string>> refused = {{"Fillets/teeth=in contact"},
                                                         {"Fillets/gauges=G"},
                                                         {"Reduced/settling decay times=3",
                                                          "Dynamics/mass proportional damping=0"}};
  for (std::vector<std::string> entries : refused)
    {
      entries.insert(entries.end(),
                     {"Reduced/sweep=up",
                      "Reduced/lowest speed=12000 rpm",
                      "Reduced/highest speed=20000 rpm"});
      print_refusal([&]() { run_pair("refused.prm", "refused", world, entries); });
    }
}

int main(int argc, char **argv)
{
  // Bodies are shared within the test alone.
  for (const char *folder : {"bodies", "few_bodies", "bodies_to_20_kHz", "bodies_to_9_kHz"})
    std::filesystem::remove_all(folder);
  run_parts(argc,
            argv,
            {beside_run, speeds, stresses, run_up, store, goes_on, until_steady, refusals});
  return 0;
}
