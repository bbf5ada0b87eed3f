// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// A coarse pair without web on a rigid hub whose torque grows from nothing: flanks that just touch,
// the balance of angular momentum, and a run that ends after a number of steps.
#include "../../dynamics/one_solver.h"
#include "../../read_files.h"
#include "../quick_pair.h"

#include <vfife/base/parameters/parameter_file.h>
#include <vfife/base/process/mpi_session.h>
#include <vfife/base/types.h>
#include <vfife/study/cases/gear/gear_case.h>
#include <vfife/study/run/run_start.h>
#include <vfife/study/run/start_kinds.h>
#include <vfife/study/run/stepped_solver.h>

#include <deal.II/base/parameter_handler.h>

#include <filesystem>

using namespace vfife;

double figure(const nlohmann::json &summary, const std::string &name)
{
  return summary.at("figures").at(name).at("value").get<double>();
}

/** Of the driven body about its axis, in the drive direction, velocities half a step back
 * [t mm^2/s]. */
double angular_momentum(const Model &model, const State &state)
{
  const unsigned int driven  = model.only_transmission()->driven;
  const Body        &body    = model.bodies[driven];
  double             inertia = 0;
  for (unsigned int i = 0; i < body.n_nodes(); ++i)
    {
      const Vector3 r =
        state.node_position(state.partition->local_node[body.first_node + i]) - body.axis.point;
      inertia += body.node_masses()[i] * body.axis.direction.cross(r).squaredNorm();
    }
  return model.only_transmission()->driven_sense * inertia * state.measured.body_rates[driven];
}

/** Over two thirds of a mesh, on the ramp and behind it, step by step: what the contact's torque
 * is more than the load is what the gear gains of angular momentum. */
void balance_of_momentum(Communicator &world)
{
  const ParameterFile      file("ramp.prm");
  GearCase                 gear_case;
  DynamicsOptions          dynamics;
  dealii::ParameterHandler prm;
  gear_case.declare(prm, file);
  dynamics.declare(prm);
  file.read_known(prm);
  std::ostringstream nothing;
  Log                log(nothing, true, Verbosity::quiet);
  Model              model        = gear_case.make_model(log);
  model.torques.front().ramp_time = gear_case.ramp_time();
  SteppedSolver stepped(model, dynamics, world, log, [&](const double stable_step) {
    return gear_case.choose_step(stable_step, 98);
  });
  State         state;
  stepped.solver.start(state);
  make_start({model, dynamics, stepped.solver, nullptr, world, log})->prepare(state);

  const double mesh = 1. / gear_case.mesh_frequency(), end = 2. / 3 * mesh;
  double       impulse = 0, before = 0, first = 0, last = 0, load = 0;
  auto         observers = watch(1, [&](const State &now) {
    // Forces of a step change the momentum that is seen at the next.
    impulse += before;
    last   = angular_momentum(model, now);
    first  = now.step == 0 ? last : first;
    load   = 800e3 * std::min(1., now.time / (0.5 * mesh));
    before = now.dt * (now.measured.contact_torque - load);
  });
  stepped.solver.run(state, end, observers);
  // Constraints of the hub push along and across the axis only.
  check_ratio("angular momentum over the impulse", (last - first) / impulse, 1e-4);
  check("the load slows the gear down", impulse < -0.01 * 800e3 * end);
  check_close("all of the load [N mm]", load, 800e3, 1e-6);
}

int main(int argc, char **argv)
{
  MpiSession session(argc, argv);
  std::filesystem::remove_all("ramp_results");
  std::ofstream("ramp.prm")
    << quick_pair("set body type = rim only", "set elements through rim = 2", "1e-5") +
         "subsection Operation\n  set bore rotation = rigid\n"
         "  set ramp = 0.5\nend\n"
         "subsection Dynamics\n  set start = ramp\n"
         "  set mass proportional damping = 0\n  set driven speed damping = 0\nend\n";
  run_pair("ramp.prm", "ramp_results", session.world());

  auto        columns = read_columns("ramp_results/history.csv");
  const auto &time = columns["time"], &angle = columns["gear angle"],
             &torque       = columns["contact torque on the gear"];
  const auto   summary     = read_json("ramp_results/summary.json");
  const double mesh_period = 1. / figure(summary, "mesh frequency");
  // A thousandth of 800 N m, found to 1e-5 of all forces: the centrifugal ones are some 10^2 of the
  // contact's at full load.
  check_close("contact torque at the start [N m]", torque.front(), 0.8, 0.8);
  // The work of a torque that grows in proportion to time, over the angles of the hub that takes
  // it.
  const auto &work     = columns["work of the torques"];
  double      expected = 0, wrong = 0;
  for (std::size_t i = 1; i < time.size(); ++i)
    {
      const double middle = 0.5 * (time[i] + time[i - 1]);
      const double load   = 800e3 * std::min(1., middle / (0.5 * mesh_period)); // [N mm]
      expected -= load * (angle[i] - angle[i - 1]) * pi / 180;
      raise_to(wrong, std::abs(work[i] - expected));
    }
  // Between two samples the gear's rate changes by 1e-4.
  check_below("work of the torque against the drive over that of its ramp",
              wrong / std::abs(expected),
              1e-5);
  check("the swing's stiffness is that of the pair: some 10^6 N m/rad",
        figure(summary, "torsional stiffness") > 1e6 &&
          figure(summary, "torsional stiffness") < 1e7);

  balance_of_momentum(session.world());

  std::filesystem::remove_all("part_results");
  std::ofstream("part.prm") << "include ramp.prm\nsubsection Dynamics\n"
                               "  set maximum number of steps = 100\nend\n";
  run_pair("part.prm", "part_results", session.world());
  const auto part = read_json("part_results/summary.json");
  check("a part of the run is a finished run",
        part.at("status") == "finished" && part.at("run").at("steps") == 100);
  check("too short for a steady part", !part.at("steady part").at("found").get<bool>());
  auto part_columns = read_columns("part_results/history.csv");
  bool same         = true;
  for (std::size_t i = 0; i < part_columns["dte"].size(); ++i)
    same = same && part_columns["dte"][i] == columns["dte"][i];
  check("the part has the same digits", same && part_columns["dte"].size() >= 5);
  return 0;
}
