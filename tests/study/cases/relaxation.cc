// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// Static equilibrium by relaxation, adaptive and traditional (virtual damping), against
// conventional finite elements on the same mesh, which is read from a file. On one rank and on two.
#include "../../model_parts.h"
#include "../../tests.h"

#include <vfife/base/process/log.h>
#include <vfife/base/process/mpi_session.h>
#include <vfife/base/process/timers.h>
#include <vfife/dynamics/equilibrium/relaxation.h>
#include <vfife/dynamics/loop/explicit_solver.h>
#include <vfife/fem/statics/static_solver.h>
#include <vfife/mesh/files/mesh_import.h>

using namespace vfife;

/** A quarter of a plate with a hole, of steel, pulled by a nominal stress of 1 MPa. */
Model make_model()
{
  Model model =
    model_of(Body("plate", read_body(tree_folder() + "/meshes/plate_with_hole.msh"), Material()));
  const Body &plate = model.bodies.front();
  model.constraints = {hold(plate.node_set("symmetry x"), {{true, false, false}}),
                       hold(plate.node_set("symmetry y"), {{false, true, false}}),
                       hold(plate.node_set("bottom"), {{false, false, true}})};
  Load pull;
  pull.name   = "pull";
  pull.nodes  = plate.node_set("pulled");
  pull.vector = Vector3(40. * 4., 0., 0.); // area times 1 MPa
  pull.history.check("pull");
  model.loads.push_back(pull);
  return model;
}

/** The same load shared out by areas, as nodal forces. */
std::vector<Vector3> make_nodal_forces(const Model &model)
{
  const Load          &pull  = model.loads.front();
  const auto           areas = compute_nodal_areas(model.bodies.front(), pull.nodes);
  std::vector<Vector3> forces(model.n_nodes(), Vector3::Zero());
  for (std::size_t i = 0; i < areas.size(); ++i)
    forces[pull.nodes[i]] = areas[i] / (40. * 4.) * pull.vector;
  return forces;
}

/** Largest difference of the displacements over the largest one of the reference. */
double compare(const Model               &model,
               const State               &state,
               const std::vector<double> &reference,
               const Communicator        &communicator)
{
  double difference = 0, largest = 0;
  for (std::uint32_t i = 0; i < state.partition->n_local(); ++i)
    {
      const std::uint32_t             node = state.partition->global_node[i];
      const Eigen::Map<const Vector3> expected(reference.data() + 3 * node);
      raise_to(
        difference,
        (state.node_position(i) - model.bodies.front().node_positions()[node] - expected).norm());
      raise_to(largest, expected.norm());
    }
  return communicator.max(difference) / communicator.max(largest);
}

int main(int argc, char **argv)
{
  MpiSession          session(argc, argv);
  const Communicator &world = session.world();
  const Model         model = make_model();

  FemOptions conventional;
  conventional.linear_tolerance = 1e-12;
  StaticLoads loads;
  loads.part_of_loads = 0; // shared out here, not by the model's own routine
  loads.nodal_forces  = make_nodal_forces(model);
  const std::vector<double> reference =
    StaticSolver(model, {0}, conventional, world).solve(loads).displacements;

  std::ostringstream nothing;
  Log                log(nothing, world.is_root(), Verbosity::quiet);
  unsigned int       steps[2];
  for (const bool traditional : {false, true})
    {
      DynamicsOptions options;
      options.damping = options.mesh_damping = 0;
      options.relaxation.tolerance           = 1e-8;
      // Twice the lowest frequency of the plate's side, pi/2 c/L = 2e5 1/s.
      options.relaxation.virtual_damping = traditional ? 4e5 : 0;
      Timers         timers;
      ExplicitSolver solver(model, options, world, log, timers);
      solver.set_step(solver.stable_step());
      State state;
      solver.start(state);
      Relaxation             relaxation(model,
                            options.relaxation,
                            solver.vfife_operator(),
                            solver.contact(),
                            solver.walls(),
                            world,
                            log);
      const RelaxationReport report     = relaxation.solve(state, Relaxation::Loads());
      const double           difference = compare(model, state, reference, world);
      steps[traditional]                = report.steps;
      if (!world.is_root())
        continue;
      if (argc > 1)
        std::cout << (traditional ? "traditional " : "adaptive ") << report.steps
                  << " steps, residual " << report.residual << ", difference " << difference
                  << std::endl;
      const std::string name = traditional ? "traditional: " : "adaptive: ";
      check(name + "residual", report.residual < 1e-8);
      // Small displacements on one side: strains of 1.5e-5 are the difference's size.
      check_below(name + "displacements against conventional finite elements", difference, 5e-5);
      check(name + "some difference of second order is there", difference > 1e-8);
    }
  if (world.is_root())
    check("the adaptive form needs fewer steps", steps[0] < steps[1]);
  return 0;
}
