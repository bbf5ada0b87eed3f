// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// Which copy of node A a run of a gear pair records: that whose passage has its peak in the record,
// by the static curve of conventional finite elements; on any number of ranks; kept by a restart.
#include "../../read_files.h"
#include "../quick_pair.h"

#include <vfife/base/process/mpi_session.h>

#include <filesystem>

using namespace vfife;

constexpr double mesh_frequency = 20000. / 60 * 27; // [Hz]

void run(const std::string              &folder,
         const std::vector<std::string> &overrides,
         Communicator                   &communicator,
         const bool                      restart = false)
{
  if (!restart && communicator.is_root())
    std::filesystem::remove_all(folder);
  communicator.barrier();
  run_pair("passage.prm", folder, communicator, overrides, restart);
}

nlohmann::json read_probe(const std::string &folder, const std::string &probe)
{
  return read_json(folder + "/summary.json").at("probes").at(probe);
}

/** After the start [mesh cycles]. */
double passage(const std::string &folder, const std::string &probe)
{
  return value_of(read_probe(folder, probe), "time at the mean contact") * mesh_frequency;
}

/** Stresses of a probe of a table, by its times or places. */
std::map<double, double>
curve_of(const std::string &path, const std::string &probe, const std::string &abscissa)
{
  const Table              table = read_result_table(path);
  std::map<double, double> curve;
  for (std::size_t i = 0; i < table.n_rows(); ++i)
    if (table.column("probe").texts[i] == probe)
      curve[table.numbers(abscissa)[i]] = table.numbers("von mises")[i];
  return curve;
}

double largest_in(const std::map<double, double> &curve)
{
  double largest = 0;
  for (const auto &point : curve)
    raise_to(largest, point.second);
  return largest;
}

/** The value at the point of the curve that is nearest. */
double nearest(const std::map<double, double> &curve, const double place)
{
  double distance = 1e300, value = NAN;
  for (const auto &point : curve)
    if (std::abs(point.first - place) < distance)
      {
        distance = std::abs(point.first - place);
        value    = point.second;
      }
  return value;
}

void check_passage(const std::string &probe)
{
  const auto loaded =
    curve_of("passage_loaded/loaded_probes.csv", probe, "position after the mean contact");
  const auto   record = curve_of("passage_run/probes.csv", probe, "time");
  const auto   found  = read_probe("passage_run", probe);
  const double before = passage("passage_run", probe), largest = largest_in(loaded);
  check("a whole turn of the gear at two positions a mesh cycle", loaded.size() == 2 * 79);
  check("half of it before the mesh",
        loaded.begin()->first >= -39.5 && loaded.rbegin()->first < 39.5);

  // The operator and conventional elements differ by some parts in a thousand, the record swings.
  check_ratio(probe + ": stress at the start over the static one there",
              record.begin()->second / nearest(loaded, -before),
              0.01);
  check_ratio(probe + ": the static stress after four of six meshes over the largest of a turn",
              nearest(loaded, 4 - before) / largest,
              0.01);
  // Over the run the swing on the mesh is added, and what the record says is what it has.
  check_ratio(probe + ": the summary's largest of the record",
              value_of(found, "largest of the record") / largest_in(record),
              1e-9);
  check(probe + ": the record has the peak", found.at("the record has the peak").get<bool>());

  // After one step the copies are still in the equilibrium of the start; the peak is flat.
  const auto start = read_probe("passage_start", probe);
  check_ratio(probe + ": the summary's largest of a turn over the static one",
              value_of(start, "largest per revolution") / largest,
              0.01);
  check_ratio(probe + ": the static stress where the summary puts it",
              nearest(loaded, value_of(start, "position after the mean contact")) / largest,
              0.01);
  check(probe + ": one step has no peak", !start.at("the record has the peak").get<bool>());
}

void restart(Communicator &world)
{
  run("passage_parts", {"Operation/mesh cycles=3"}, world);
  const std::string before  = "passage_parts_probes.csv";
  const double      shorter = passage("passage_parts", "node A front");
  std::filesystem::copy_file("passage_parts/probes.csv",
                             before,
                             std::filesystem::copy_options::overwrite_existing);
  run("passage_parts", {"Operation/mesh cycles=6"}, world, true);
  check_close("restart: the probe stays where it was",
              passage("passage_parts", "node A front"),
              shorter,
              1e-12);
  check_close("restart: a whole run of that length has another one",
              passage("passage_run", "node A front") - shorter,
              2.,
              1e-9);
  const auto first = curve_of(before, "node A front", "time");
  const auto whole = curve_of("passage_parts/probes.csv", "node A front", "time");
  double     apart = 0, jump = 0;
  for (const auto &[time, stress] : first)
    raise_to(apart, std::abs(whole.at(time) - stress));
  check("restart: same rows, then more", apart == 0 && whole.size() > 1.9 * first.size());
  // Of another sector the next sample would be several per cent apart.
  const auto after = whole.upper_bound(first.rbegin()->first);
  jump             = std::abs(after->second / first.rbegin()->second - 1);
  check_below("restart: no jump", jump, 0.01);
}

void ramp(Communicator &world)
{
  run("passage_ramp", {"Dynamics/start=ramp", "Dynamics/maximum number of steps=1"}, world);
  for (const std::string probe : {"node A front", "node A back"})
    {
      // The tooth nearest to 75 % of six meshes; the node lies within a pitch of it.
      check_close(probe + ", ramp: passes the mesh at 75 % of the run",
                  passage("passage_ramp", probe),
                  5.,
                  1.);
      check(probe + ", ramp: one step shows no peak",
            !read_probe("passage_ramp", probe).at("the record has the peak").get<bool>());
    }
  check("ramp: the log says when",
        has_text(read_text("passage_ramp/run.log"), "node A back: passes the contact after"));
}

/** The same sectors on one rank and on two. */
void ranks(Communicator &world)
{
  const std::vector<std::string> short_run = {"Dynamics/maximum number of steps=1"};
  if (world.is_root())
    {
      Communicator alone(MPI_COMM_SELF);
      run("passage_one_rank", short_run, alone);
    }
  world.barrier();
  run("passage_two_ranks", short_run, world);
  world.barrier();
  if (!world.is_root())
    return;
  for (const std::string probe : {"node A front", "node A back"})
    check_close(probe + ": the same sector on two ranks",
                passage("passage_two_ranks", probe),
                passage("passage_one_rank", probe),
                1e-9);
}

int main(int argc, char **argv)
{
  MpiSession    session(argc, argv);
  Communicator &world = session.world();
  if (world.is_root())
    {
      std::string all =
        quick_pair("set body type = conical web\nset web inclination = 70 deg", coarse_web, "1e-5");
      const std::string one = "set mesh cycles = 1";
      all.replace(all.find(one), one.size(), "set mesh cycles = 6");
      std::ofstream("passage.prm") << all;
    }
  world.barrier();
  if (world.size() > 1)
    {
      ranks(world);
      return 0;
    }
  run("passage_loaded",
      {"Study/kind=loaded tooth contact analysis", "Loaded contact/positions=2"},
      world);
  run("passage_run", {}, world);
  run("passage_start", {"Dynamics/maximum number of steps=1"}, world);
  for (const std::string probe : {"node A front", "node A back"})
    check_passage(probe);
  restart(world);
  ramp(world);
  return 0;
}
