// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// A solid on a deal.II program's mesh moves as in a run; hanging nodes keep energy, masses, linear
// fields and the bound of the step.
#include "../dynamics/one_solver.h"
#include "../parts.h"
#include "../tests.h"
#include "solid_mesh.h"

#include <vfife/mesh/body_mesh.h>

#include <limits>

using namespace vfife;

using Vector = SolidMesh::Vector;

/** Smooth in no direction, so that all modes of a mesh move. */
Vector3 rough_field(const Vector3 &x)
{
  return Vector3(std::sin(7 * x[0] + 3 * x[1] - 5 * x[2]),
                 std::cos(4 * x[0] - 9 * x[1] + 2 * x[2]),
                 std::sin(x[0] + 6 * x[1] + 8 * x[2]));
}

/** A block that turns and vibrates, free or sliding on one side. */
void compare_to_run(const bool slides, const double bound)
{
  Body block("block", vfife::make_block(Vector3(12, 8, 6), {{6, 4, 3}}), Material());
  for (const Vector3 &X : block.node_positions())
    {
      block.initial_velocity.push_back(4e4 * rough_field(X) + 200. * Vector3(0, -X[2], X[1]));
      if (slides && X[0] == 0)
        block.initial_velocity.back()[0] = 0;
    }
  Model model = model_of(std::move(block));
  if (slides)
    model.constraints.push_back(hold(model.bodies[0].node_set("x-"), {{true, false, false}}));
  DynamicsOptions options = undamped();
  options.step_bound      = StepBound::element;
  OneSolver   run(model, options);
  const Body &body = model.bodies[0];

  // On the same triangulation, by DoFs of another order.
  dealii::FESystem<3>   element(dealii::FE_Q<3>(1), 3);
  dealii::DoFHandler<3> dofs(body.mesh().triangulation);
  dofs.distribute_dofs(element);
  std::vector<dealii::types::global_dof_index> of_vertex(3 * body.n_nodes());
  for (const auto &cell : dofs.active_cell_iterators())
    for (unsigned int v = 0; v < 8; ++v)
      for (unsigned int c = 0; c < 3; ++c)
        of_vertex[3 * cell->vertex_index(v) + c] = cell->vertex_dof_index(v, c);
  dealii::AffineConstraints<double> constraints;
  if (slides)
    for (const unsigned int node : body.node_set("x-"))
      constraints.add_line(of_vertex[3 * node]);
  constraints.close();
  ExplicitSolid solid(dofs, constraints, {{0, Material()}}, {});
  check_ratio("step over that of the run", solid.stable_step() / run.state.dt, 1e-14);

  Vector v(dofs.n_dofs());
  for (unsigned int i = 0; i < v.size(); ++i)
    v[of_vertex[i]] = body.initial_velocity[i / 3][i % 3];
  const Vector none(dofs.n_dofs());
  solid.set_state(none, v, run.state.dt);
  const unsigned int n_steps   = 500;
  double             energy    = 0;
  auto               observers = watch(n_steps, [&](const State &state) {
    energy = state.measured.energy.kinetic + state.measured.energy.strain;
  });
  run.solver.run(run.state, n_steps * run.state.dt, observers);
  for (unsigned int n = 0; n < n_steps; ++n)
    solid.step(none);

  double largest = 0, fastest = 0, place = 0, velocity = 0;
  for (unsigned int i = 0; i < v.size(); ++i)
    {
      const std::uint32_t local = run.state.partition->local_node[i / 3];
      const double        u     = solid.displacement()[of_vertex[i]],
                   x = run.state.node_position(local)[i % 3], w = solid.velocity()[of_vertex[i]];
      raise_to(largest, std::abs(u));
      raise_to(fastest, std::abs(w));
      raise_to(place, std::abs(body.node_positions()[i / 3][i % 3] + u - x));
      raise_to(velocity, std::abs(w - run.state.node_velocity(local)[i % 3]));
    }
  check("the block has moved", largest > .1);
  check_below("places less those of the run, over the largest displacement",
              place / largest,
              bound);
  // Each step rounds some ten times, 500 * 10 * 2.2e-16 = 1.1e-12, in an order that depends on
  // the instruction set; velocities have a larger part of the highest frequencies than places.
  check_below("velocities less those of the run, over the largest", velocity / fastest, 5 * bound);
  check_close("time in steps", solid.time() / run.state.dt, n_steps, 1e-9);
  solid.step(none); // the energies are those of the run's last instant
  check_ratio("energy over that of the run",
              (solid.kinetic_energy() + solid.strain_energy()) / energy,
              1e-12);
}

void same_as_run()
{
  compare_to_run(false, 0.); // the same operations
  compare_to_run(true, 1e-12);
}

/** A plane wave turns no element, so that the forces are linear and the energy of central
 * differences is constant. It passes from coarse to fine cells; the sides slide. */
void energy_of_plane_wave()
{
  const double length = 40;
  SolidMesh    mesh;
  mesh.make_block(Vector3(length, 2, 2), {40, 2, 2});
  mesh.refine_where([&](const auto &x) { return x[0] > length / 2; });
  mesh.setup({{2, 2}, {3, 2}, {4, 4}, {5, 4}});
  ExplicitSolid solid(mesh.dofs, mesh.constraints, mesh.steel(), {});
  const Vector  v = mesh.interpolate([&](const Vector3 &x) {
    const double s = x[0] / (length / 2);
    return Vector3(s < 1 ? 1e5 * std::pow(std::sin(pi * s), 2) : 0., 0, 0);
  });
  solid.set_state(mesh.zero(), v, solid.stable_step());
  double least = std::numeric_limits<double>::infinity(), most = 0, sideways = 0, strain = 0;
  for (unsigned int n = 0; n < 3000; ++n)
    {
      solid.step(mesh.zero());
      const double energy = solid.kinetic_energy() + solid.strain_energy();
      least               = std::min(least, energy);
      raise_to(most, energy);
      raise_to(strain, solid.strain_energy() / energy);
      for (std::size_t i = 0; i < mesh.places.size(); ++i)
        if (mesh.component[i] != 0)
          raise_to(sideways, std::abs(solid.displacement()[i]));
    }
  check("the wave has strain energy", strain > .3);
  check_below("energy: largest over least, less one", most / least - 1, 1e-12);
  check_below("displacement across the wave [mm]", sideways, 1e-12);
}

/** Rough motion with hanging nodes also at a plane of symmetry, and a line with one master of
 * another sign and size: the internal forces do the work that the lumped masses have. */
void work_of_forces()
{
  SolidMesh mesh;
  mesh.make_block(Vector3(6, 6, 6), {3, 3, 3});
  mesh.refine_where([](const auto &x) { return x[0] < 2 && x[1] < 2; });
  mesh.setup({{0, 1}});
  dealii::AffineConstraints<double> lines;
  dealii::types::global_dof_index   tied = 0, master = 0;
  for (std::size_t i = 0; i < mesh.places.size(); ++i)
    if (mesh.component[i] == 1 && mesh.places[i] == Vector3(6, 6, 6))
      tied = i;
    else if (mesh.component[i] == 2 && mesh.places[i] == Vector3(6, 0, 6))
      master = i;
  lines.merge(mesh.constraints);
  lines.add_line(tied);
  lines.add_entry(tied, master, -2.);
  lines.close();
  ExplicitSolid solid(mesh.dofs, lines, mesh.steel(), {});
  check_close("mass of a master of weight -2, in masses of the other corner",
              solid.lumped_masses()[master] / Material().density,
              5.,
              1e-12);
  const double dt = solid.stable_step();
  solid.set_state(mesh.zero(),
                  mesh.interpolate([](const Vector3 &x) {
                    return Vector3(2e4 * rough_field(x).array() *
                                   Eigen::Array3d(x[0] > 0 ? 1 : 0, 1, 1));
                  }),
                  dt);
  const auto kinetic = [&] {
    double sum = 0;
    for (std::size_t i = 0; i < mesh.places.size(); ++i)
      sum += .5 * solid.lumped_masses()[i] * std::pow(solid.velocity()[i], 2);
    return sum;
  };
  const double at_start = kinetic();
  double       work = 0, error = 0, change = 0, at_symmetry = 0, tie = 0, hanging = 0;
  for (unsigned int n = 0; n < 500; ++n)
    {
      Vector force = mesh.zero(), v = solid.velocity();
      solid.internal_forces(solid.displacement(), force);
      solid.step(mesh.zero());
      v += solid.velocity();
      work += .5 * dt * (force * v);
      raise_to(error, std::abs(kinetic() - at_start - work) / at_start);
      raise_to(change, std::abs(work) / at_start);
      Vector distributed = solid.displacement();
      lines.distribute(distributed);
      distributed -= solid.displacement();
      raise_to(hanging, distributed.linfty_norm());
      raise_to(tie, std::abs(solid.displacement()[tied] + 2 * solid.displacement()[master]));
      for (std::size_t i = 0; i < mesh.places.size(); ++i)
        if (mesh.component[i] == 0 && mesh.places[i][0] == 0)
          raise_to(at_symmetry, std::abs(solid.displacement()[i]));
    }
  check("the forces do work", change > .3);
  check_below("kinetic energy less the work, over that at the start", error, 1e-12);
  check_below("displacements less those of the lines [mm]", hanging, 1e-15);
  check_below("displacement at the symmetry [mm]", at_symmetry, 0.);
  check_below("displacement of the tie less that of its master [mm]", tie, 1e-15);
}

/** Largest force inside over the largest on the boundary, under a linear field. */
double patch_error(SolidMesh &mesh)
{
  mesh.setup();
  check("the mesh has hanging nodes", mesh.constraints.n_constraints() > 100);
  ExplicitSolid solid(mesh.dofs, mesh.constraints, mesh.steel(), {});
  Matrix3       H;
  H << .02, -.01, .03, .04, -.02, .01, -.03, .02, .01;
  // Of the places of the solid: hanging vertices lie at the mean of their masters.
  Vector u = mesh.interpolate([&](const Vector3 &x) { return Vector3(H * x); });
  mesh.constraints.distribute(u);
  Vector force = mesh.zero();
  solid.internal_forces(u, force);
  mesh.constraints.condense(force);
  const dealii::IndexSet outside = dealii::DoFTools::extract_boundary_dofs(mesh.dofs);
  double                 inside = 0, boundary = 0;
  for (std::size_t i = 0; i < mesh.places.size(); ++i)
    {
      double &largest = outside.is_element(i) ? boundary : inside;
      raise_to(largest, std::abs(force[i]));
    }
  return inside / boundary;
}

void patch_tests()
{
  const auto low = [](const auto &x) { return x[0] < .5 && x[2] < .6; };
  SolidMesh  cube;
  cube.make_block(Vector3(1, 1, 1), {4, 4, 4});
  dealii::GridTools::distort_random(.3, cube.triangulation, true);
  cube.refine_where(low);
  cube.refine_where([](const auto &x) { return x[0] < .2 && x[2] < .3; });
  SolidMesh ball;
  dealii::GridGenerator::hyper_ball(ball.triangulation);
  ball.triangulation.refine_global(1);
  ball.refine_where(low);
  const double of_cube = patch_error(cube), of_ball = patch_error(ball);
  check_below("patch test, distorted cube", of_cube, 1e-12);
  // The manifold curves coarse faces with hanging vertices.
  check_below("patch test, ball", of_ball, 1e-12);
}

/** The largest frequency by power iterations is below that of the true one, and below the bound;
 * mass and first moment of a mesh with hanging nodes are those of the body. */
void step_and_masses()
{
  SolidMesh mesh;
  mesh.make_block(Vector3(8, 8, 8), {4, 4, 4});
  mesh.refine_where([](const auto &x) { return x[0] < 4; });
  mesh.setup();
  ExplicitSolid solid(mesh.dofs, mesh.constraints, mesh.steel(), {});
  double        mass   = 0;
  Vector3       moment = Vector3::Zero();
  for (std::size_t i = 0; i < mesh.places.size(); ++i)
    if (mesh.component[i] == 0)
      {
        mass += solid.lumped_masses()[i];
        moment += solid.lumped_masses()[i] * mesh.places[i];
      }
  check_ratio("mass over that of the block", mass / (512 * Material().density), 1e-14);
  check_below("centre of mass [mm]", (moment / mass - Vector3(4, 4, 4)).norm(), 1e-13);

  Vector q = mesh.interpolate(rough_field), force = mesh.zero();
  double square = 0; // of the frequency
  for (unsigned int n = 0; n < 400; ++n)
    {
      q *= 1e-6 / q.linfty_norm(); // small: linear forces
      mesh.constraints.distribute(q);
      solid.internal_forces(q, force);
      mesh.constraints.condense(force);
      double energy = 0;
      for (std::size_t i = 0; i < q.size(); ++i)
        energy += solid.lumped_masses()[i] * q[i] * q[i];
      square = -(q * force) / energy;
      for (std::size_t i = 0; i < q.size(); ++i)
        q[i] = solid.lumped_masses()[i] > 0 ? force[i] / solid.lumped_masses()[i] : 0.;
    }
  const double ratio = 2 / std::sqrt(square) / (solid.stable_step() / .9);
  check("the bound of the elements is below the critical step", ratio > 1);
  check("and above half of it", ratio < 2);
}

/** Values that change between steps lead their DoFs; mass-proportional damping slows a body. */
void prescribed_values_and_damping()
{
  SolidMesh mesh;
  mesh.make_block(Vector3(4, 2, 2), {4, 2, 2});
  mesh.setup({{0, 1}});
  ExplicitSolid solid(mesh.dofs, mesh.constraints, mesh.steel(), {});
  const double  dt = solid.stable_step();
  solid.set_state(mesh.zero(), mesh.zero(), dt);
  const auto lead  = [](const double t) { return 1e8 * t * t; };
  double     place = 0, velocity = 0;
  for (unsigned int n = 0; n < 100; ++n)
    {
      for (std::size_t i = 0; i < mesh.places.size(); ++i)
        if (mesh.constraints.is_constrained(i))
          mesh.constraints.set_inhomogeneity(i, lead((n + 1) * dt));
      solid.step(mesh.zero());
      for (std::size_t i = 0; i < mesh.places.size(); ++i)
        if (mesh.constraints.is_constrained(i))
          {
            raise_to(place, std::abs(solid.displacement()[i] - lead(solid.time())));
            raise_to(velocity,
                     std::abs(solid.velocity()[i] - (lead((n + 1) * dt) - lead(n * dt)) / dt));
          }
    }
  check_below("displacement less the prescribed one [mm]", place, 1e-15);
  check_below("velocity less that of the prescribed way, over the last",
              velocity / (2e8 * solid.time()),
              1e-10);

  mesh.setup();
  ExplicitSolid::Options options;
  options.damping = 1e4;
  ExplicitSolid damped(mesh.dofs, mesh.constraints, mesh.steel(), options);
  damped.set_state(mesh.zero(),
                   mesh.interpolate([](const Vector3 &) { return Vector3(3, 0, 0); }),
                   dt);
  Vector load = damped.lumped_masses();
  load *= 2e5; // an acceleration of all DoFs
  for (unsigned int n = 0; n < 200; ++n)
    damped.step(load);
  const double a = .5e4 * dt, rest = std::pow((1 - a) / (1 + a), 200);
  double       error = 0;
  for (std::size_t i = 0; i < mesh.places.size(); ++i)
    raise_to(error,
             std::abs(damped.velocity()[i] - 20 * (1 - rest) -
                      (mesh.component[i] == 0 ? 3 * rest : 0.)));
  // Places have digits of 1e-15 mm, which steps of 1e-7 s make velocities of 1e-8 mm/s.
  check_below("velocity under constant acceleration and damping [mm/s]", error, 1e-7);
}

int main(int argc, char **argv)
{
  return run_parts(argc,
                   argv,
                   {same_as_run,
                    energy_of_plane_wave,
                    work_of_forces,
                    patch_tests,
                    step_and_masses,
                    prescribed_values_and_damping});
}
