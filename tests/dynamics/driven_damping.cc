// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// Damping is relative to the motion that constraints prescribe: a body that is pushed or turned at
// a constant rate has no drag once its vibrations are gone.
#include "../tests.h"
#include "one_solver.h"

#include <vfife/base/process/mpi_session.h>
#include <vfife/mesh/body_mesh.h>

#include <deal.II/base/parameter_handler.h>

using namespace vfife;

constexpr double length = 20, height = 6, end = 1e-3, zeta = 4e4; // [mm], [mm], [s], [1/s]

/** A bar along x, whose left end is moved at a constant rate from time zero on. */
Model make_model(const bool turns)
{
  Model    model;
  Material steel;
  steel.poissons_ratio = 0;
  Body bar("bar",
           make_block(Vector3(length, height, height), {{10, 3, 3}}, Vector3(0, -height / 2, 0)),
           steel);
  bar.turns_on_axis = turns;
  model.add_body(std::move(bar));
  Constraint driven;
  driven.name  = "driven";
  driven.nodes = model.bodies[0].node_set("x-");
  dealii::ParameterHandler prm;
  driven.history.declare(prm);
  prm.set("history", "t");
  driven.history.check("driven");
  if (turns)
    {
      driven.kind  = ConstraintKind::prescribed_rotation;
      driven.angle = 1000.; // [rad/s]
    }
  else
    {
      driven.kind         = ConstraintKind::directions;
      driven.prescribed   = {{true, true, true}};
      driven.displacement = Vector3(1000., 0., 0.); // [mm/s]
    }
  model.constraints.push_back(driven);
  return model;
}

/** Displacement of the right end from where the left end takes it, along x and y of the bar [mm].
 */
Vector3 find_lag(const Model &model, const double angle, const double way)
{
  DynamicsOptions options = undamped();
  options.damping         = zeta;
  OneSolver run(model, options);
  auto      none = watch(1000, [](const State &) {});
  run.solver.run(run.state, end, none);
  const Matrix3 turned = rotation_about(Vector3::UnitZ(), angle * run.state.time);
  Vector3       lag    = Vector3::Zero();
  const Body   &bar    = model.bodies[0];
  for (const unsigned int node : bar.node_set("x+"))
    lag += turned.transpose() * (run.state.node_position(run.state.partition->local_node[node]) -
                                 Vector3(way * run.state.time, 0, 0)) -
           bar.node_positions()[node];
  return lag / bar.node_set("x+").size();
}

int main(int argc, char **argv)
{
  MpiSession     session(argc, argv);
  const Material steel;
  // With a drag of zeta rho v per volume the end would stay behind by zeta rho v L^2/(2 E), and of
  // a turning bar by 11 zeta rho A Omega L^5/(120 E I).
  const double drag = zeta * steel.density * 1000 * length * length / (2 * steel.youngs_modulus),
               bend = 11 * zeta * steel.density * 1000 * std::pow(length, 5) * 12 /
                      (120 * steel.youngs_modulus * height * height);
  // Vibrations fall to exp(-zeta t/2) = 2e-9 of v L/c = 4e-3 mm, that of bending somewhat slower.
  check_below("pushed bar: lag over that of a drag",
              find_lag(make_model(false), 0., 1000.)[0] / drag,
              1e-5);
  const Vector3 lag = find_lag(make_model(true), 1000., 0.);
  check_below("turned bar: lag over that of a drag", lag[1] / bend, 1e-5);
  // Centrifugal force, rho Omega^2 L^3/(3 E).
  check_ratio("turned bar: extension",
              lag[0] / (steel.density * 1e6 * std::pow(length, 3) / (3 * steel.youngs_modulus)),
              0.02);
  return 0;
}
