// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// Speed and torque that change with time: a driver that runs up goes by the integral of its speed,
// a hub under a torque over time by that of the torque, and driven speed damping follows the
// present speed.
#include "../history_of.h"
#include "../parts.h"
#include "../tests.h"
#include "one_solver.h"

#include <vfife/base/types.h>
#include <vfife/mesh/body_mesh.h>

#include <fstream>

using namespace vfife;

constexpr double first_rate = 200, end_time = 4e-4;

Body make_member(const std::string &name, const Vector3 &point, const double rate)
{
  Body body(name, make_ring(20, 30, 6, {{2, 36, 1}}), Material());
  body.axis                  = {point, Vector3::UnitZ()};
  body.placement.translation = point;
  body.turns_on_axis         = true;
  body.rate                  = rate;
  return body;
}

/** A driver with its speed over time and a hub that turns freely. */
Model make_pair(const ParameterHistory &speed)
{
  Model        model;
  Transmission t;
  t.driver_teeth = t.driven_teeth = 30;
  t.driver_rate                   = first_rate;
  t.rate_history                  = speed;
  t.driver      = model.add_body(make_member("driver", Vector3(0, 70, 0), first_rate));
  t.driven      = model.add_body(make_member("driven", Vector3::Zero(), -first_rate));
  t.driven_bore = model.bodies[t.driven].node_set("inner");
  t.driven_rim  = model.bodies[t.driven].node_set("outer");
  for (Body &body : model.bodies)
    body.rate_history = speed;
  model.constraints.push_back({"driver bore",
                               ConstraintKind::prescribed_rotation,
                               t.driver,
                               model.bodies[t.driver].node_set("inner")});
  model.constraints.push_back({"hub", ConstraintKind::rigid_hub, t.driven, t.driven_bore});
  model.transmissions = {t};
  return model;
}

/** Angle about its axis from the place at time zero, within a turn [rad]. */
double turned_angle(const Body &body, const unsigned int node, const State &state)
{
  const Vector3 start = body.node_positions()[node],
                now   = state.node_position(state.partition->local_node[body.first_node + node]) -
                      body.axis.point;
  return std::atan2(start[0] * now[1] - start[1] * now[0], start.head<2>().dot(now.head<2>()));
}

/** Speed 200 (1 + 500 t + ...) by a formula and by a table: the angle is the integral. */
void driver(const std::string                   &name,
            const std::string                   &text,
            const std::function<double(double)> &turn)
{
  const QuantityOverTime speed = history_of(text, "rad/s");
  const Model            model = make_pair(speed.factor);
  OneSolver              run(model, undamped());
  double                 of_node = 0, of_angle = 0, of_factor = 0;
  unsigned int           n         = 0;
  Observers              observers = watch(7, [&](const State &state) {
    const double exact = turn(state.time);
    raise_to(of_node,
             std::abs(
               turned_angle(model.bodies[0], model.bodies[0].node_set("inner")[n % 36], state) -
               exact));
    raise_to(of_angle, std::abs(state.measured.driver_angle - exact));
    raise_to(of_factor, std::abs(state.measured.rate_factor - speed.factor.value(state.time)));
    ++n;
  });
  run.solver.run(run.state, end_time, observers);
  check(name + ": seen often", n > 50);
  check_below(name + ": angle of the bore's nodes [rad]", of_node, 1e-14);
  check_below(name + ": measured angle [rad]", of_angle, 1e-15);
  check_below(name + ": factor of the speed", of_factor, 1e-15);
  check_close(name + ": mesh cycles",
              model.only_transmission()->meshes(end_time),
              30 * turn(end_time) / (2 * pi),
              1e-14);
}

void drivers()
{
  driver("formula", "200 + 1e5*t + 3e8*t^2", [](const double t) {
    return 200 * t + 5e4 * t * t + 1e8 * t * t * t;
  });
  std::ofstream("run_up.csv") << "time [ms],speed [rad/s]\n0.1,200\n0.3,260\n";
  driver("table", "run_up.csv", [](const double t) {
    const double ramp = std::min(std::max(t - 1e-4, 0.), 2e-4), after = std::max(t - 3e-4, 0.);
    return 200 * t + 60 * (ramp * ramp / 4e-4 + after);
  });
}

/**
 * The driven body, left alone by the driver's teeth, is drawn after the kinematic speed 200 + a t
 * by the driven speed damping alone: e = omega - omega_k has e' = -a - zeta e. With zeta^n the
 * share of a step, e_n = -(a/zeta) (1 - (1 - zeta dt)^n) exactly.
 */
void mesh_damping()
{
  constexpr double zeta = 2000, a = 1e5;
  const Model      model   = make_pair(history_of("200 + 1e5*t", "rad/s").factor);
  DynamicsOptions  options = undamped();
  options.mesh_damping     = zeta;
  OneSolver run(model, options);
  Observers none;
  run.solver.run(run.state, end_time, none);
  // The momentum's rate is that half a step before the state.
  const double dt = run.state.dt, n = static_cast<double>(run.state.step),
               kinematic = first_rate + a * (run.state.time - .5 * dt),
               found     = -run.state.measured.body_rates[1] - kinematic;
  check_ratio("driven speed damping: lag behind the present kinematic speed",
              found / (a / zeta * (std::pow(1 - zeta * dt, n) - 1)),
              2e-3);
}

/** A hub under a torque T (1 + t/t_1): I omega = I omega_0 + T (t + t^2/(2 t_1)). */
void torque()
{
  Model                  model = make_pair({});
  const QuantityOverTime given = history_of("3 + 3e4*t", "N m");
  model.torques.push_back(torque_on(model, "inner", given.start, 1));
  model.torques.back().history = given.factor;
  OneSolver run(model, undamped());
  Observers none;
  run.solver.run(run.state, end_time, none);
  const double t = run.state.time, inertia = model.bodies[1].axial_inertia(),
               gained = given.start * (t + .5e4 * t * t) / inertia;
  // v- has the torques of the steps before: dt sum T_n, n from 0 to N - 1. The ring grows by
  // 1e-7 of its inertia.
  const double dt = run.state.dt, n = static_cast<double>(run.state.step),
               steps = given.start * (n * dt + 1e4 * dt * dt * n * (n - 1) / 2) / inertia;
  check_ratio("torque over time: gain of speed over that of the steps",
              (run.state.measured.body_rates[1] + first_rate) / steps,
              1e-5);
  check_ratio("torque over time: work over the integral of T omega",
              run.state.measured.energy.torque_work /
                (inertia / 2 * (std::pow(first_rate - gained, 2) - first_rate * first_rate)),
              1e-3);
}

int main(int argc, char **argv)
{
  return run_parts(argc, argv, {drivers, mesh_damping, torque});
}
