// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// A slave whose facets are ten times and more as wide as those of its master: the step bears the
// points that fall on the master's small nodes, and a relaxation finds its equilibrium.
#include "../parts.h"
#include "../tests.h"
#include "relaxed.h"

#include <vfife/mesh/body_mesh.h>

using namespace vfife;

/** A block of 5 mm over a floor, both of steel; cells across. */
Model make_model(const unsigned int cells, const unsigned int floor_cells, const double gap)
{
  Model model = model_of(
    Body("floor",
         make_block(Vector3(6, 6, 1), {{floor_cells, floor_cells, 4}}, Vector3(-0.5, -0.5, -1)),
         Material()));
  Body block("block", make_block(Vector3(5, 5, 5), {{cells, cells, cells}}), Material());
  block.placement.translation[2] = gap;
  block.axis.point               = block.placement.translation;
  model.add_body(std::move(block));
  model.constraints.push_back({"ground", ConstraintKind::held, 0, model.bodies[0].node_set("z-")});
  ContactPair pair     = contact_of("face", {1, "z-"}, {0, "z+"});
  pair.options.surface = ContactSurfaceKind::flat_facets;
  pair.options.time    = ContactTime::explicit_; // springs that the step has to bear
  model.contacts.push_back(pair);
  return model;
}

void landing()
{
  Model model                 = make_model(2, 24, 1e-4);
  model.bodies[1].velocity[2] = -200;
  OneSolver run(model, undamped());
  double    error = 0, force = 0;
  auto      observers = watch(1, [&](const State &state) {
    raise_to(error, std::abs(state.measured.energy.error()));
    raise_to(force, state.measured.contact_force);
  });
  run.solver.run(run.state, 20e-6, observers);
  // rho c v A of a one-dimensional wave, steel against steel through a thin floor: the size.
  check("lands: contact force within a factor of 2 of the wave's",
        force > 0.5 * 200 * 25 * 7.85e-9 * 5.1e6 && force < 2 * 200 * 25 * 7.85e-9 * 6e6);
  check_below("lands: largest energy error", error, 5e-3);
}

/** Surfaces that match have what the nodes' own areas allow. */
void matching()
{
  DynamicsOptions options = undamped();
  options.safety          = 0.9;
  const Model     model   = make_model(5, 6, 0.);
  OneSolver       run(model, options);
  const Material &steel  = model.bodies[0].materials().front();
  const double    nu     = steel.poissons_ratio;
  const double    eps    = 5. * steel.youngs_modulus / (2. * (1. - nu * nu)); // facets of 1 mm
  const double    m_by_A = steel.density * 0.25 / 2;
  check_ratio("matching surfaces: penalty", run.solver.contact().penalties()[0] / eps, 1e-12);
  check_ratio("step",
              1. / std::pow(run.state.dt, 2) /
                (1. / std::pow(options.safety * run.solver.element_step(), 2) + 0.5 * eps / m_by_A),
              1e-12);
}

void relaxing()
{
  Model model = make_model(1, 60, 0.);
  Load  press;
  press.name   = "press";
  press.body   = 1;
  press.nodes  = model.bodies[1].node_set("z+");
  press.vector = Vector3(0, 0, -1000);
  press.history.check("press");
  model.loads.push_back(press);
  // Off the lines of the floor's nodes, on which a point would rest on an edge.
  model.bodies[1].placement.translation += Vector3(0.03, 0.04, 0);
  model.constraints.push_back(hold(model.bodies[1].node_set("z+"), {{true, true, false}}));
  model.constraints.back().body = 1;

  OneSolver  run(model, undamped());
  State     &state  = run.state;
  const auto report = relax(model, run);
  check("relaxes in less than 10,000 steps", report.steps < 10000);
  run.solver.measure_at_rest(state);
  check_ratio("contact force over the load", state.measured.contact_force / 1000., 1e-4);
}

int main(int argc, char **argv)
{
  return run_parts(argc, argv, {landing, matching, relaxing});
}
