// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// history.csv and probes.csv of made-up measurements whose numbers all differ, read back: each
// stands in its column, in the unit of the header.
#include "../model_parts.h"
#include "../tests.h"

#include <vfife/base/process/communicator.h>
#include <vfife/base/process/mpi_session.h>
#include <vfife/mesh/primitives/primitives.h>
#include <vfife/model/model.h>
#include <vfife/model/state.h>
#include <vfife/output/files/output_folder.h>
#include <vfife/output/files/table_reader.h>
#include <vfife/output/observers/history_writer.h>
#include <vfife/output/observers/probe_writer.h>

#include <filesystem>
#include <map>

using namespace vfife;

const std::string folder_name = "history_values_results";

struct Value
{
  double      number;
  std::string unit;
};
using Values = std::map<std::string, Value>;

State make_state()
{
  State state;
  state.time                   = .25e-3;
  Measurements &m              = state.measured;
  m.driver_angle               = pi / 4;
  m.rate_factor                = 1.5;
  m.driven_angle               = pi / 10;
  m.rim_angle                  = pi / 11;
  m.transmission_error         = pi / 180 / 100;
  m.rim_transmission_error     = -pi / 180 / 200;
  m.contact_force              = 8918;
  m.contact_torque             = 801e3;
  m.drive_torque               = 7e5;
  m.teeth_in_contact           = 3;
  m.largest_penetration        = .0015;
  m.energy.kinetic             = 101;
  m.energy.kinetic_relative    = 102;
  m.energy.strain              = 103;
  m.energy.contact             = 104;
  m.energy.drive_work          = 205;
  m.energy.torque_work         = -56;
  m.energy.damping_loss        = 7;
  m.energy.mesh_damping_uptake = 8;
  m.energy.contact_loss        = 9;
  m.energy.start               = 110;
  m.energy.scale               = 200;
  m.energy.friction_loss       = 4;
  for (unsigned int i = 0; i < 2; ++i)
    {
      const double up = 1000. * i;
      m.contact_forces.emplace_back(up + 11, up + 12, up + 13);
      ProbeValue probe;
      probe.displacement = Vector3(up + .021, up + .022, up + .023);
      probe.stress       = {{up + 31, up + 32, up + 33, up + 34, up + 35, up + 36}};
      probe.von_mises    = up + 41;
      m.probes.push_back(probe);
      Reaction reaction;
      reaction.force  = Vector3(up + 51, up + 52, up + 53);
      reaction.moment = Vector3(up + 61, up + 62, up + 63);
      m.reactions.push_back(reaction);
    }
  m.momentum         = Vector3(71, 72, 73);
  m.angular_momentum = Vector3(81, 82, 83);
  return state;
}

Values energies(const std::string &work)
{
  return {{"kinetic energy", {101, "mJ"}},
          {"relative kinetic energy", {102, "mJ"}},
          {"strain energy", {103, "mJ"}},
          {"contact energy", {104, "mJ"}},
          {"work of the drive", {205, "mJ"}},
          {work, {-56, "mJ"}},
          {"damping loss", {7, "mJ"}},
          {"removed by the driven speed damping", {8, "mJ"}},
          {"contact loss", {9, "mJ"}},
          // 308 are there, 110 were, 149 came, 24 were lost
          {"energy error", {73. / 200, "-"}}};
}

void check_table(const std::string &name, const Table &table, const Values &expected)
{
  check(name + ": as many columns", table.columns().size() == expected.size());
  for (const Table::Column &column : table.columns())
    {
      const auto found = expected.find(column.name);
      check(name + ": unit of " + column.name,
            found != expected.end() && column.unit == found->second.unit);
      if (found != expected.end())
        check_close(name + ": " + column.name,
                    column.numbers.at(0),
                    found->second.number,
                    1e-14 * std::abs(found->second.number));
    }
}

Table write_history(const OutputFolder &folder, const Model &model)
{
  ContactImpulse impulse;
  impulse.add(1e-3, 1000, 90e3);
  impulse.add(1e-3, 3000, 270e3);
  HistoryWriter writer(folder, model, 1, [impulse] { return impulse; });
  const State   state = make_state();
  writer.observe(model, state);
  writer.finish(model, state);
  return read_result_table(folder.file("history.csv"));
}

Body cube(const std::string &name)
{
  return {name, make_block({1, 1, 1}, {{1, 1, 1}}), Material()};
}

void gear_pair(const OutputFolder &folder)
{
  Model model = model_of(cube("pinion"));
  model.add_body(cube("gear"));
  model.transmissions.emplace_back();
  model.transmissions.front().driver_rate  = 200 * pi; // 6000 rpm
  model.transmissions.front().driver_teeth = 27;
  Values expected                          = energies("work of the torques");
  expected.merge(Values({{"time", {.25e-3, "s"}},
                         {"pinion angle", {45, "deg"}},
                         {"gear angle", {18, "deg"}},
                         {"speed", {9000, "rpm"}},
                         {"mesh frequency", {4050, "Hz"}},
                         {"dte", {36, "arcsec"}},
                         {"rim dte", {-18, "arcsec"}},
                         {"contact force total", {8918, "N"}},
                         {"contact torque on the gear", {801, "N m"}},
                         {"teeth in contact", {3, "-"}},
                         {"impulse of contact force total", {2, "N s"}},
                         {"impulse of contact torque on the gear", {.18, "N m s"}},
                         {"largest penetration", {1.5, "um"}}}));
  check_table("pair", write_history(folder, model), expected);
}

void general_model(const OutputFolder &folder)
{
  Model model = model_of(cube("block"));
  model.contacts.emplace_back();
  model.contacts[0].side = "joint";
  model.walls.emplace_back();
  model.walls[0].name = "floor";
  model.probes.push_back({"tip", 0, 0, true});
  model.probes.push_back({"end", 0, 1, false});
  Constraint foot;
  foot.name = "foot";
  model.constraints.push_back(foot);
  Load pull, spring;
  pull.name   = "pull";
  spring.name = "bed";
  spring.kind = LoadKind::spring;
  model.loads.push_back(pull);
  model.loads.push_back(spring);

  Values expected = energies("work of the loads");
  expected.merge(Values({{"time", {.25e-3, "s"}},
                         {"contact force total", {8918, "N"}},
                         {"largest penetration", {1.5, "um"}}}));
  const std::string xyz[] = {"x", "y", "z"}, cylindrical[] = {"r", "theta", "z"};
  const auto add = [&expected](const std::string &name, const double number, const char *unit) {
    expected[name] = {number, unit};
  };
  // Contacts come first, then walls; constraints, then springs.
  for (unsigned int i = 0; i < 2; ++i)
    {
      const double       up      = 1000. * i;
      const std::string *axes    = i == 0 ? xyz : cylindrical;
      const std::string  contact = i == 0 ? "joint" : "floor", probe = i == 0 ? "tip" : "end",
                        support = i == 0 ? "foot" : "bed";
      for (unsigned int c = 0; c < 3; ++c)
        {
          add(contact + " contact force " + xyz[c], up + 11 + c, "N");
          add(support + " reaction force " + xyz[c], up + 51 + c, "N");
          add(support + " reaction moment " + xyz[c], up + 61 + c, "N mm");
          add(probe + " displacement " + axes[c], up + .021 + .001 * c, "mm");
          add(probe + " stress " + axes[c], up + 31 + c, "MPa");
          add(probe + " stress " + axes[c] + " " + axes[(c + 1) % 3], up + 34 + c, "MPa");
        }
      add(probe + " von mises", up + 41, "MPa");
    }
  for (unsigned int c = 0; c < 3; ++c)
    {
      add("momentum " + xyz[c], 71 + c, "N s");
      add("angular momentum " + xyz[c], 81 + c, "N mm s");
    }
  check_table("general", write_history(folder, model), expected);
}

void probes(const OutputFolder &folder)
{
  Model model = model_of(cube("block"));
  model.probes.push_back({"node A", 0, 0});
  model.probes.push_back({"node B", 0, 1});
  ProbeWriter writer(folder, 1);
  const State state = make_state();
  writer.observe(model, state);
  writer.finish(model, state);
  const Table       table  = read_result_table(folder.file("probes.csv"));
  const std::string axes[] = {"r", "theta", "z"};
  check("probes: a row each",
        table.column("probe").texts == std::vector<std::string>({"node A", "node B"}));
  for (unsigned int i = 0; i < 2; ++i)
    {
      const double up = 1000. * i;
      const auto   close =
        [&](const std::string &name, const std::string &unit, const double expected) {
          check_close("probes: " + name, table.numbers(name).at(i), expected, 1e-9);
          check("probes: unit of " + name, table.column(name).unit == unit);
        };
      for (unsigned int c = 0; c < 3; ++c)
        {
          close("displacement " + axes[c], "um", 1e3 * (up + .021 + .001 * c));
          close("stress " + axes[c], "MPa", up + 31 + c);
          close("stress " + axes[c] + " " + axes[(c + 1) % 3], "MPa", up + 34 + c);
        }
      close("von mises", "MPa", up + 41);
    }
}

int main(int argc, char **argv)
{
  MpiSession session(argc, argv);
  std::filesystem::remove_all(folder_name);
  const OutputFolder folder(folder_name, session.world());
  gear_pair(folder);
  general_model(folder);
  probes(folder);
  return 0;
}
