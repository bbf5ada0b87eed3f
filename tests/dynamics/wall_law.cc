// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// A block thrown at a rigid wall whose contact law is not one of the program's.
#include "../contact/exponential_law.h"
#include "../tests.h"
#include "one_solver.h"

#include <vfife/base/process/mpi_session.h>
#include <vfife/mesh/body_mesh.h>

using namespace vfife;

int main(int argc, char **argv)
{
  MpiSession   session(argc, argv);
  const double width = 2, speed = 1000, penalty = 200; // [mm], [mm/s], [N/mm^3]
  Model        model;
  Body         block("block", make_block(Vector3(width, width, width), {{1, 1, 1}}), Material());
  block.velocity[0] = -speed;
  RigidWall wall;
  wall.name           = "wall";
  wall.nodes          = block.node_set("x-");
  wall.point[0]       = -1e-3;
  wall.penalty.value  = penalty;
  wall.penalty.law    = &make_contact_law<ExponentialLaw>;
  const double energy = 0.5 * block.mass() * speed * speed;
  model.add_body(std::move(block));
  model.walls.push_back(wall);

  OneSolver run(model, undamped());
  double    force_error = 0, largest_force = 0, deepest = 0, residual = 0;
  auto      observers = watch(1, [&](const State &state) {
    const ExponentialLaw      law(wall.penalty);
    std::vector<PressedPoint> points;
    for (std::uint32_t i = 0; i < state.partition->n_local(); ++i)
      {
        const double depth = wall.point[0] - state.node_position(i)[0];
        if (depth > 0)
          points.push_back({depth, penalty * width * width / 4});
        raise_to(deepest, depth);
      }
    law.evaluate(points);
    double force = 0;
    for (const PressedPoint &point : points)
      force += point.pressure;
    raise_to(force_error, std::abs(state.measured.contact_force - force));
    raise_to(largest_force, force);
    raise_to(residual, std::abs(state.measured.energy.residual()));
  });
  run.solver.run(run.state, 1.5e-4, observers);

  check("the block goes beyond the exponential part of the law", deepest > ExponentialLaw::depth);
  // The pressure is the mean over a step, of which some hundred are in contact.
  check_below("force of the wall against the law at the nodes", force_error / largest_force, 2e-3);
  check_below("energy residual over that of flight", residual / energy, 1e-6);
  check_ratio("the block flies back: velocity over the first one",
              run.state.node_velocity(0)[0] / speed,
              0.01);
  check("contact has ended", run.state.measured.contact_force == 0);

  // At rest at a depth d within the exponential part: the energy of the law at four nodes.
  const double depth = 0.5 * ExponentialLaw::depth;
  for (const std::uint32_t i : run.state.partition->nodes())
    {
      Vector3 place = model.bodies[0].node_positions()[run.state.partition->global_node[i]];
      place[0] += wall.point[0] - depth;
      run.state.position.set(i, place);
    }
  run.solver.measure_at_rest(run.state);
  std::vector<PressedPoint> corners(4, {depth, penalty * width * width / 4});
  ExponentialLaw(wall.penalty).evaluate(corners);
  check_ratio("at rest: energy of the contact over that of the law",
              run.state.measured.energy.contact / (4 * corners[0].energy),
              1e-9);
  return 0;
}
