// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// What is measured at probes of a ring that is widened evenly, about an axis askew: displacements
// and stresses in r, theta, z, or along x, y, z, against Hooke's law.
#include "../parts.h"
#include "../tests.h"
#include "one_solver.h"

using namespace vfife;

constexpr double strain = 1e-5;

void measure()
{
  Model model;
  Body  ring("ring", make_ring(20., 30., 6., {{2, 24, 2}}), Material());
  ring.placement.rotation    = rotation_about(Vector3(1., 2., 2.) / 3., 1.3);
  ring.placement.translation = Vector3(50., -20., 10.);
  ring.axis                  = {ring.placement(Vector3::Zero()), ring.placement.rotation.col(2)};
  ring.turns_on_axis         = true;
  model.add_body(std::move(ring));
  const Body &body = model.bodies[0];
  // A node outside, 75 degrees from x, on the top: elements on two sides of it.
  unsigned int node = 0;
  while ((body.node_positions()[node] -
          Vector3(30. * std::cos(5 * pi / 12), 30. * std::sin(5 * pi / 12), 6.))
           .norm() > 1e-9)
    ++node;
  model.probes.push_back({"turned", 0, node});
  model.probes.push_back({"fixed", 0, node, true});

  OneSolver run(model, undamped());
  for (const std::uint32_t i : run.state.partition->nodes(0))
    {
      Vector3 X = body.node_positions()[run.state.partition->global_node[i]];
      X.head<2>() *= 1. + strain;
      run.state.position.set(i, body.placement(X));
    }
  run.solver.measure_at_rest(run.state);
  const ProbeValue &turned = run.state.measured.probes.at(0),
                   &fixed  = run.state.measured.probes.at(1);
  const Material &m        = body.materials().front();
  const double    plane = 2. * (m.lambda() + m.mu()) * strain, axial = 2. * m.lambda() * strain;
  check_below("displacement along r, theta, z less 30 strain along r [mm]",
              (turned.displacement - Vector3(30. * strain, 0., 0.)).norm(),
              1e-11);
  const Vector3 radial(std::cos(5 * pi / 12), std::sin(5 * pi / 12), 0.);
  check_below("displacement along x, y, z of the fixed frame [mm]",
              (fixed.displacement - 30. * strain * (body.placement.rotation * radial)).norm(),
              1e-11);
  double error = 0.;
  for (const ProbeValue *value : {&turned, &fixed})
    for (unsigned int c = 0; c < 6; ++c)
      raise_to(error, std::abs(value->stress[c] - (c < 2 ? plane : c == 2 ? axial : 0.)));
  // Squares of the strain are left out.
  check_below("stresses over the larger one, less those of Hooke's law", error / plane, 1e-4);
  check_ratio("von Mises stress over 2 mu times the strain",
              turned.von_mises / (2. * m.mu() * strain),
              1e-4);
}

int main(int argc, char **argv)
{
  return run_parts(argc, argv, {measure});
}
