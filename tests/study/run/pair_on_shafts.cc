// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// A pair on shafts: the equilibrium before a slow run beside the loaded tooth contact analysis,
// forces of the bearings in balance, runs that go on where they were interrupted, what a housing
// adds; shafts and bearings that cannot be.
#include "../../parts.h"
#include "../../refusal.h"
#include "../child_program.h"
#include "../shaft_pair.h"

#include <Eigen/Core>

using namespace vfife;
using namespace shaft_pair;

void check_balance(const std::string &name, const std::string &folder, const double tolerance)
{
  Vector3 sum     = Vector3::Zero();
  double  largest = 0;
  for (const auto &[bearing, row] : first_bearings(folder))
    {
      sum += force_of(bearing, row);
      largest = std::max(largest, force_of(bearing, row).norm());
    }
  check(name + ": five bearings", first_bearings(folder).size() == 5);
  // Flanks push both members alike, the coupling and the load have moments only.
  check_below(name + ": sum of all bearings' forces over the largest",
              sum.norm() / largest,
              tolerance);
}

/** The equilibrium of the loaded analysis of a pair, and that before a run of the same file, at a
 * speed at which nothing but the load bends it. */
void slow(const std::string &name, const std::string &entries, Communicator &world)
{
  const std::string pair     = pair_on_shafts(entries) + operation("60 rpm"),
                    analysis = name + "_loaded", of_run = name + "_run";
  run_pair(write(analysis,
                 study("loaded tooth contact analysis") + pair +
                   "subsection Loaded contact\nset positions = 1\nset centrifugal = no\nend\n"),
           analysis,
           world);
  check_balance(name + ": loaded analysis", analysis, 1e-6);
  run_pair(write(of_run,
                 study("run") + pair +
                   "subsection Dynamics\nset maximum number of steps = 20\nend\n"),
           of_run,
           world);
  const double error = read_columns(analysis + "/loaded_contact.csv").at("transmission error")[0];
  check_ratio(name + ": transmission error of the start over that of the analysis",
              read_columns(of_run + "/history.csv").at("dte")[0] / error,
              0.01);
  check(name + ": shafts let the gear lag more than twice as far", error < -150.);
  const auto run = first_bearings(of_run), loaded = first_bearings(analysis);
  double     forces = 0, ways = 0, scale = 0, way_scale = 0;
  for (const auto &[bearing, row] : loaded)
    {
      const auto &other = run.at(bearing);
      raise_to(forces, (force_of(bearing, row) - force_of(bearing, other)).norm());
      scale = std::max(scale, force_of(bearing, row).norm());
      for (const char *c : {"displacement x", "displacement y", "displacement z"})
        {
          raise_to(ways, std::abs(row.at(c) - other.at(c)));
          way_scale = std::max(way_scale, std::abs(row.at(c)));
        }
    }
  check_below(name + ": forces of the bearings, run less analysis, over the largest",
              forces / scale,
              0.01);
  check_below(name + ": their displacements alike", ways / way_scale, 0.01);
  const auto misalignment = read_columns(of_run + "/misalignment.csv"),
             of_analysis  = read_columns(analysis + "/misalignment.csv");
  double largest = 0, difference = 0;
  for (const char *c : {"offset", "pinion axial shift", "gear axial shift"})
    {
      largest = std::max(largest, std::abs(of_analysis.at(c)[0]));
      raise_to(difference, std::abs(of_analysis.at(c)[0] - misalignment.at(c)[0]));
    }
  check_below(name + ": misalignment, run less analysis, over its largest",
              difference / largest,
              0.01);
  check_ratio(name + ": shaft angle, run over analysis",
              misalignment.at("shaft angle error")[0] / of_analysis.at("shaft angle error")[0],
              0.01);
}

/** Rows of a comparison of both, all of the short run taken as its steady part. */
void compare(const std::string &name, Communicator &world)
{
  const std::string of_run  = name + "_run";
  auto              summary = nlohmann::ordered_json::parse(read_text(of_run + "/summary.json"));
  summary["steady part"]["found"] = true;
  summary["steady part"]["start"] = {{"value", 0.}, {"unit", "s"}};
  std::ofstream(of_run + "/summary.json") << summary;
  run_case(write(name + "_compare",
                 study("compare") +
                   "subsection Compare\nset cases = run, loaded\nset report = no\n"
                   "subsection Case run\nset results = " +
                   of_run + "\nend\nsubsection Case loaded\nset results = " + name +
                   "_loaded\nend\nend\n"),
           name + "_compare",
           world);
  const Table table = read_result_table(name + "_compare/comparison.csv");
  for (const char *start : {"bearing ", "misalignment", "dte at the start"})
    {
      unsigned int n = 0, agree = 0;
      for (std::size_t i = 0; i < table.n_rows(); ++i)
        if (table.column("quantity").texts[i].rfind(start, 0) == 0)
          {
            ++n;
            agree += table.column("verdict").texts[i] == "agrees";
            // Numbers that are none would agree with nothing.
            if (table.column("verdict").texts[i] != "agrees")
              std::cout << table.column("quantity").texts[i] << ": " << table.numbers("value")[i]
                        << ", " << table.numbers("reference")[i] << std::endl;
          }
      check(name + ": " + std::to_string(n) + " rows of the comparison agree: " + start,
            n > 0 && agree == n);
    }
}

void rigid_housing(Communicator &world)
{
  slow("rigid_housing", "", world);
  compare("rigid_housing", world);
}

void housing(Communicator &world)
{
  // Springs of each seat to the ground, and one of all of them: the box stands on a soft foot.
  std::ofstream file("housing.mtx");
  file << "%%MatrixMarket matrix array real general\n30 30\n";
  Eigen::MatrixXd K = Eigen::MatrixXd::Zero(30, 30);
  for (unsigned int s = 0; s < 5; ++s)
    {
      K.block<3, 3>(6 * s, 6 * s)         = 4e5 * Matrix3::Identity();
      K.block<3, 3>(6 * s + 3, 6 * s + 3) = 1e9 * Matrix3::Identity();
      for (unsigned int t = 0; t < 5; ++t)
        K.block<3, 3>(6 * s, 6 * t) -= 6e4 * Matrix3::Identity();
    }
  for (unsigned int i = 0; i < 900; ++i)
    file << K(i % 30, i / 30) << "\n";
  file.close();
  slow("housing", "subsection Housing\nset stiffness = housing.mtx\nend\n", world);
  const auto ways = [](const std::string &name) {
    double sum = 0;
    for (const auto &bearing : first_bearings(name + "_loaded"))
      sum += bearing.second.at("radial displacement");
    return sum;
  };
  check("a housing lets the shafts move further", ways("housing") > 3 * ways("rigid_housing"));
}

/** Where shafts, bodies, bearings and the coupling are rigid, the contact alone gives way: as on
 * ideal bores. What winds up the coupling is no error, but turns the pinion on to another place
 * of its mesh cycle. */
void stiff_limit(Communicator &world)
{
  // A million times steel, on penalty springs that stay what they are.
  const std::string rest = operation("60 rpm") + study("loaded tooth contact analysis") +
                           "subsection Material steel\nset Young's modulus = 2.06e11\nend\n"
                           "subsection Contact\nset penalty = 6e5\nend\n"
                           "subsection Loaded contact\nset positions = 2\n"
                           "set centrifugal = no\nend\n";
  const std::string rigid = "set kind = bearing\nset radial stiffness = 1e12\n"
                            "set axial stiffness = 1e12\nset tilting stiffness = 1e15\n";
  run_pair(write("ideal_bores", few_teeth("set body type = conical web", coarse_web) + rest),
           "ideal_bores",
           world);
  run_pair(write("stiff_shafts", pair_on_shafts("", {rigid, rigid, rigid, rigid}) + rest),
           "stiff_shafts",
           world,
           {"Gear pair/Pinion/Shaft/End/torsional stiffness=1e15"});
  const auto ideal  = read_columns("ideal_bores/loaded_contact.csv"),
             shafts = read_columns("stiff_shafts/loaded_contact.csv");
  for (const char *column :
       {"transmission error", "contact force total", "largest pressure", "tangent stiffness"})
    {
      double apart = 0;
      for (unsigned int i = 0; i < 2; ++i)
        raise_to(apart, std::abs(shafts.at(column)[i] / ideal.at(column)[i] - 1));
      check_below(std::string("stiff limit: ") + column, apart, 1e-4);
    }
  double moved = 0;
  for (const char *column : {"offset", "pinion axial shift", "gear axial shift"})
    raise_to(moved, std::abs(read_columns("stiff_shafts/misalignment.csv").at(column)[0]));
  check_below("stiff limit: misalignment [um]", moved, 1e-3);
}

/** A run that is interrupted in the start's state and in the middle has the same digits. */
void goes_on(Communicator &world)
{
  const std::string steps = "Dynamics/maximum number of steps=";
  const std::string file =
    write("goes_on", study("run") + pair_on_shafts() + operation("20000 rpm"));
  std::filesystem::remove_all("whole");
  std::filesystem::remove_all("parts");
  run_pair(file, "whole", world, {steps + "120"});
  run_pair(file, "parts", world, {steps + "50"});
  run_pair(file, "parts", world, {steps + "120"}, true);
  for (const char *name : {"history.csv", "bearings.csv", "misalignment.csv"})
    {
      const std::string whole = read_text("whole/" + std::string(name));
      check(std::string(name) + ": same digits",
            whole.size() > 100 && whole == read_text("parts/" + std::string(name)));
    }
  const auto whole = nlohmann::ordered_json::parse(read_text("whole/summary.json")),
             parts = nlohmann::ordered_json::parse(read_text("parts/summary.json"));
  for (const char *section : {"transmission error", "misalignment"})
    check(std::string(section) + " in the summary: the same",
          whole.contains(section) && whole.at(section) == parts.at(section));
  // Of the first sample the bearings have the equilibrium of the whole pair, its inertia
  // included.
  check_balance("run at full speed, first sample", "whole", 0.01);
  const auto history = read_columns("whole/history.csv");
  check_below("energy error of the run", largest_size(history.at("energy error")), 1e-3);
}

/** Each member by itself in spin: the driven one turns freely, and nothing holds its turn. */
void spin(Communicator &world)
{
  run_pair(write("spin", study("linear static") + pair_on_shafts() + operation("20000 rpm")),
           "spin",
           world);
  const Table                    table = read_result_table("spin/reactions.csv");
  const std::vector<std::string> names = table.columns().front().texts;
  const auto                     at    = [&](const std::string &name, const std::string &column) {
    return table.numbers(column).at(std::find(names.begin(), names.end(), name) - names.begin());
  };
  // Preloads of both rows hold each other, and what spin shortens of the shaft changes both
  // alike.
  const double front = at("pinion front", "force x"), rear = at("pinion rear", "force x");
  check("in spin: the tapered rows are preloaded against each other", front * rear < 0.);
  check_below("in spin: and in balance", (front + rear) / front, 1e-6);
  check_below("in spin: no thrust on the gear", at("gear thrust", "force z") / front, 1e-6);

  // In a housing the rows press it, which gives way.
  run_pair("spin.prm", "spin_housing", world, {"Gear pair/Housing/stiffness=housing.mtx"});
  const Table  housed       = read_result_table("spin_housing/reactions.csv");
  const double front_housed = housed.numbers(
                 "force x")[std::find(names.begin(), names.end(), "pinion front") - names.begin()],
               rear_housed = housed.numbers(
                 "force x")[std::find(names.begin(), names.end(), "pinion rear") - names.begin()];
  check_below("in spin, in a housing: in balance", (front_housed + rear_housed) / front, 1e-6);
  check("in spin, in a housing: less preload is left",
        front_housed / front > .05 && front_housed / front < .95);
}

void refused(const std::string &entry, Communicator &world)
{
  print_refusal([&] { run_pair("refused.prm", "refused", world, {entry}); });
}

void refusals(Communicator &world)
{
  write("refused", study("run") + pair_on_shafts() + operation("20000 rpm"));
  const std::string shaft = "Gear pair/Pinion/Shaft/", front = shaft + "Bearing front/";
  refused(front + "from=20", world);
  refused(front + "to=200", world);
  refused(front + "to=120", world);
  refused(front + "from=120", world);
  refused(shaft + "End/to=230", world);
  refused(shaft + "sections=", world);
  refused(shaft + "sections=98 160 40 20, 140 220 36 20", world);
  refused(shaft + "sections=98 160 40 20, 160 220 36", world);
  refused(front + "pitch diameter=6", world);
  // Rows of unequal length in what a flank's errors are read from, in the whole pair.
  std::ofstream("ragged.csv") << "# tip above\n1, 2, 3\n4, 5\n";
  refused("Gear pair/Errors/Gear/Convex flank/topography=ragged.csv", world);
  refused("Gear pair/Gear/Shaft/Bearing inner/clearance=-0.5", world);
  refused("Gear pair/Gear/Shaft/Bearing thrust/axial stiffness=0", world);
  std::ofstream("short.mtx") << "%%MatrixMarket matrix array real general\n1 1\n5\n";
  refused("Gear pair/Housing/stiffness=short.mtx", world);
  refused("Gear pair/Housing/stiffness=nowhere.mtx", world);
  std::ofstream("words.mtx") << "%%MatrixMarket matrix array real general\n30 30\n1\nstiff\n";
  refused("Gear pair/Housing/stiffness=words.mtx", world);
  std::ofstream("ended.mtx") << "%%MatrixMarket matrix array real general\n30 30\n1\n2\n";
  refused("Gear pair/Housing/stiffness=ended.mtx", world);
  std::ofstream askew("askew.mtx");
  askew << "%%MatrixMarket matrix array real general\n30 30\n";
  for (unsigned int i = 0; i < 900; ++i)
    askew << (i % 30 == i / 30 ? 1e6 : i == 1 ? 1e5 : 0.) << "\n";
  askew.close();
  write("refused", study("linear static") + pair_on_shafts() + operation("60 rpm"));
  refused("Gear pair/Housing/stiffness=askew.mtx", world);
  write("refused",
        study("run") + coarse_pair("set body type = rim only", "set elements through rim = 2") +
          operation("20000 rpm"));
  refused("Gear pair/Housing/stiffness=short.mtx", world);
  write("refused",
        study("run") + coarse_pair("set body type = rim only", "set elements through rim = 2") +
          "subsection Gear pair\nsubsection Gear\nsubsection Shaft\n"
          "set bearings = one\nend\nend\nend\n" +
          operation("20000 rpm"));
  refused("Gear pair/Gear/Shaft/Bearing one/radial stiffness=1", world);
  write("refused",
        study("run") + coarse_pair("set body type = conical web\n", coarse_web) +
          "subsection Gear pair\nsubsection Gear\nsubsection Shaft\n"
          "set sections = -10 120 100 60\nend\nend\nend\n" +
          operation("20000 rpm"));
  refused("Gear pair/Gear/Shaft/axial element size=20", world);
}

int main(int argc, char **argv)
{
  run_parts<Communicator>(argc,
                          argv,
                          {&rigid_housing, &housing, &stiff_limit, &goes_on, &spin, &refusals});
  return 0;
}
