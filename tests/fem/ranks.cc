// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// Several ranks give what one rank gives: statics, modes at speed, one sector.
#include "../ranks.h"
#include "../tests.h"

#include <vfife/fem/modes/rotating_body.h>
#include <vfife/fem/statics/static_solver.h>
#include <vfife/mesh/primitives/primitives.h>

using namespace vfife;

int main(int argc, char **argv)
{
  const TestRanks     ranks(argc, argv);
  const Communicator &world = ranks.world, &alone = ranks.alone;

  Model model;
  model.add_body(Body("wheel", make_ring(20., 40., 6., {{6, 16, 3}}), {}));
  Body &wheel = model.bodies[0];
  wheel.rate  = 3000.;
  model.constraints.push_back({"hub", ConstraintKind::rigid_hub, 0, wheel.node_set("inner")});

  FemOptions options;
  options.n_modes = 8;
  for (const bool cyclic : {false, true})
    {
      options.cyclic_symmetry       = cyclic;
      options.largest_diameter      = 3;
      options.coriolis              = cyclic;
      const ModesAtSpeed together   = RotatingBody(model, 0, options, world).find_modes(wheel.rate);
      const ModesAtSpeed single     = RotatingBody(model, 0, options, alone).find_modes(wheel.rate);
      double             difference = 0;
      for (unsigned int k = 0; k < options.n_modes; ++k)
        raise_to(difference,
                 std::abs(together.modes[k].frequency - single.modes[k].frequency) /
                   single.modes.back().frequency);
      // The first one is the rotation, zero to the square root of round-off.
      check_below(cyclic ? "frequencies, one sector" : "frequencies, body", difference, 1e-6);
    }

  model.constraints[0].kind = ConstraintKind::held;
  StaticLoads loads;
  loads.centrifugal = true;
  for (const LinearSolverKind kind : {LinearSolverKind::multigrid, LinearSolverKind::direct})
    {
      options.linear_solver       = kind;
      const StaticResult together = StaticSolver(model, {0}, options, world).solve(loads);
      const StaticResult single   = StaticSolver(model, {0}, options, alone).solve(loads);
      // Multigrid solves to 1e-10 of the load.
      check_below("displacements",
                  relative_difference(single.displacements, together.displacements),
                  1e-7);
    }
  return 0;
}
