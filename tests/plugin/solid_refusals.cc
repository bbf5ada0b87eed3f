// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// Each exception of the plugin by its text.
#include "../parts.h"
#include "../tests.h"
#include "solid_mesh.h"

#include <vfife/plugin/solid_contact.h>

#include <deal.II/distributed/shared_tria.h>

using namespace vfife;

using Vector = SolidMesh::Vector;

void print_refusal(const std::function<void()> &act)
{
  try
    {
      act();
      check("accepted", false);
    }
  catch (const dealii::ExceptionBase &error)
    {
      error.print_info(std::cout);
    }
}

/** What a DoFHandler and its constraints are refused for. */
void print_refusal(const dealii::DoFHandler<3>                          &dofs,
                   const dealii::AffineConstraints<double>              &constraints,
                   const std::map<dealii::types::material_id, Material> &materials)
{
  print_refusal([&] { ExplicitSolid(dofs, constraints, materials, {}); });
}

void of_meshes()
{
  SolidMesh mesh;
  mesh.make_block(Vector3(2, 2, 2), {2, 2, 2});
  mesh.setup();
  print_refusal(mesh.dofs, mesh.constraints, {{7, Material()}});

  dealii::FESystem<3>   quadratic(dealii::FE_Q<3>(2), 3);
  dealii::DoFHandler<3> other(mesh.triangulation);
  print_refusal(other, mesh.constraints, mesh.steel());
  other.distribute_dofs(quadratic);
  print_refusal(other, mesh.constraints, mesh.steel());

  dealii::parallel::shared::Triangulation<3> parallel(MPI_COMM_WORLD);
  dealii::GridGenerator::hyper_cube(parallel);
  dealii::DoFHandler<3> shared(parallel);
  shared.distribute_dofs(mesh.element);
  print_refusal(shared, mesh.constraints, mesh.steel());

  mesh.triangulation.last_active()->vertex(0)[0] += 1.5;
  print_refusal(mesh.dofs, mesh.constraints, mesh.steel());
}

void of_constraints()
{
  SolidMesh mesh;
  mesh.make_block(Vector3(2, 2, 2), {2, 2, 2});
  mesh.setup();
  dealii::AffineConstraints<double> lines;
  lines.add_line(4);
  print_refusal(mesh.dofs, lines, mesh.steel());
  lines.add_entry(4, 10, 2.);
  lines.add_entry(4, 13, -1.);
  lines.close();
  print_refusal(mesh.dofs, lines, mesh.steel());
  lines.clear();
  lines.add_line(4);
  lines.add_entry(4, 10, .75);
  lines.add_entry(4, 13, .5);
  lines.close();
  print_refusal(mesh.dofs, lines, mesh.steel());

  mesh.refine_where([](const auto &x) { return x[0] < 1; });
  mesh.setup();
  lines.clear();
  lines.close();
  print_refusal(mesh.dofs, lines, mesh.steel());
}

void of_steps()
{
  SolidMesh mesh;
  mesh.make_block(Vector3(2, 2, 2), {2, 2, 2});
  mesh.setup({{0, 1}});
  ExplicitSolid solid(mesh.dofs, mesh.constraints, mesh.steel(), {});
  const double  dt = 1.11 * solid.stable_step();
  print_refusal([&] { solid.step(mesh.zero()); });
  print_refusal([&] { solid.set_state(mesh.zero(), mesh.zero(), 1.2 * dt); });
  print_refusal([&] { solid.set_state(mesh.zero(), Vector(3), dt); });
  solid.set_state(mesh.zero(), mesh.zero(), dt);
  print_refusal([&] { solid.step(Vector(5)); });

  Vector force                  = mesh.zero();
  force[mesh.dofs.n_dofs() - 1] = -1e7;
  print_refusal([&] {
    for (unsigned int n = 0; n < 100; ++n)
      solid.step(force);
  });
  solid.set_state(mesh.zero(), mesh.zero(), dt);
  force[mesh.dofs.n_dofs() - 1] = not_known;
  print_refusal([&] {
    for (unsigned int n = 0; n < 2; ++n)
      solid.step(force);
  });
  solid.set_state(mesh.zero(), mesh.zero(), dt);
  mesh.constraints.clear();
  mesh.constraints.close();
  print_refusal([&] { solid.step(mesh.zero()); });
}

void of_contact()
{
  SolidMesh fine, coarse;
  fine.make_block(Vector3(2, 2, 2), {2, 2, 2});
  fine.refine_where([](const auto &x) { return x[1] < 1; });
  fine.setup();
  coarse.make_block(Vector3(2, 2, 2), {2, 2, 2});
  dealii::GridTools::shift(dealii::Tensor<1, 3>({2, 0, 0}), coarse.triangulation);
  coarse.setup();
  ExplicitSolid slave(fine.dofs, fine.constraints, fine.steel(), {}),
    master(coarse.dofs, coarse.constraints, coarse.steel(), {});
  print_refusal([&] { SolidContact(slave, 1, master, 0, ContactOptions()); });
  print_refusal([&] { SolidContact(master, 0, slave, 17, ContactOptions()); });

  // The faces of the slave with y = 0 have no hanging nodes.
  SolidContact contact(slave, 2, master, 0, ContactOptions());
  const double dt = slave.stable_step();
  slave.set_state(fine.zero(), fine.zero(), dt);
  master.set_state(coarse.zero(), coarse.zero(), .5 * dt);
  Vector f = fine.zero(), g = coarse.zero(), too_short(7);
  print_refusal([&] { contact.add_forces(f, g); });
  master.set_state(coarse.zero(), coarse.zero(), dt);
  print_refusal([&] { contact.add_forces(f, too_short); });

  // Beyond a fifth of half a facet.
  SolidMesh other;
  other.make_block(Vector3(2, 2, 2), {2, 2, 2});
  other.setup();
  ExplicitSolid still(other.dofs, other.constraints, other.steel(), {});
  SolidContact  deep(master, 0, still, 1, ContactOptions());
  still.set_state(other.zero(), other.zero(), dt);
  master.set_state(coarse.interpolate([](const Vector3 &) { return Vector3(-.2, 0, 0); }),
                   coarse.zero(),
                   dt);
  Vector h = other.zero();
  print_refusal([&] { deep.add_forces(g, h); });
}

int main(int argc, char **argv)
{
  return run_parts(argc, argv, {of_meshes, of_constraints, of_steps, of_contact});
}
