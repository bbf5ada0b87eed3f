// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// Velocities at the start belong half a step before the places: chords of the turn, and a ring in
// equilibrium under its centrifugal force that keeps its radius.
#include "../parts.h"
#include "../tests.h"
#include "relaxed.h"

#include <vfife/mesh/body_mesh.h>

using namespace vfife;

Model make_ring_model(const double rate)
{
  Model model;
  Body  ring("ring", make_ring(20, 24, 4, {{2, 36, 1}}), Material());
  place_on_axis(ring, Vector3(10, -4, 3), Vector3(1, 2, 2));
  ring.rate = rate;
  model.add_body(std::move(ring));
  return model;
}

/** x(0) - dt v(-dt/2) is where a rigid turn had the node a step ago. */
void chords()
{
  Model         model = make_ring_model(-3000);
  Body         &ring  = model.bodies[0];
  const Vector3 flight(100, -200, 300);
  ring.velocity = flight;
  for (const Vector3 &X : ring.node_positions())
    ring.initial_velocity.push_back(Vector3(X[1], X[2], X[0]));
  OneSolver     run(model, undamped());
  const double  dt    = run.state.dt;
  const Matrix3 back  = rotation_about(ring.axis.direction, 3000 * dt);
  double        wrong = 0;
  for (unsigned int i = 0; i < ring.n_nodes(); ++i)
    {
      const std::uint32_t local  = run.state.partition->local_node[i];
      const Vector3       x      = run.state.node_position(local);
      const Vector3       own    = flight + ring.initial_velocity[i];
      const Vector3       before = ring.axis.point + back * (x - ring.axis.point) - dt * own;
      raise_to(wrong, (x - dt * run.state.node_velocity(local) - before).norm());
    }
  // Of coordinates of 30 mm; half a step would be omega^2 r dt^2/2.
  check_below("place a step before the start [mm]", wrong, 1e-14);
  check("half a step is far more", 0.5 * std::pow(3000 * dt, 2) * 20 > 1e-10);
}

void ring_keeps_its_radius()
{
  constexpr double rate        = 2000;
  const Model      model       = make_ring_model(rate);
  const Body      &ring        = model.bodies[0];
  DynamicsOptions  options     = undamped();
  options.relaxation.tolerance = 1e-9;
  OneSolver run(model, options);
  relax(model, run);
  run.solver.set_initial_velocities(run.state);
  const unsigned int node   = ring.node_set("inner").front();
  const auto         radius = [&](const State &state) {
    const Vector3 r = state.node_position(state.partition->local_node[node]) - ring.axis.point;
    return (r - ring.axis.direction.dot(r) * ring.axis.direction).norm();
  };
  // Thin ring: it grows by rho omega^2 r^3/E and breathes with sqrt(E/rho)/r.
  const double middle = 22, rho = ring.materials().front().density,
               E         = ring.materials().front().youngs_modulus;
  const double growth    = rho * rate * rate * std::pow(middle, 3) / E;
  const double breathing = std::sqrt(E / rho) / middle, start = radius(run.state);
  check_ratio("growth of the inner radius over that of a thin ring", (start - 20) / growth, 0.15);
  double swing = 0;
  auto   observers =
    watch(1, [&](const State &state) { raise_to(swing, std::abs(radius(state) - start)); });
  run.solver.run(run.state, 3 * 2 * pi / breathing, observers);
  // Velocities of omega x r would be those of the middle of no step: omega^2 r dt/2 outwards, a
  // breathing of omega_b dt/2 of the growth.
  const double half_step = 0.5 * breathing * run.state.dt;
  check("half a step would show", half_step > 5e-3);
  check_below("radius of a turning ring over its growth, over what half a step makes",
              swing / growth / half_step,
              0.05);
}

int main(int argc, char **argv)
{
  return run_parts(argc, argv, {chords, ring_keeps_its_radius});
}
