// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// A steel bar at 2 m/s hits an equal one at rest. Units mm, s, t, N, MPa.
#include <vfife/plugin/solid_contact.h>

#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/grid/grid_generator.h>
#include <deal.II/numerics/data_out.h>
#include <deal.II/numerics/vector_tools_boundary.h>
#include <deal.II/numerics/vector_tools_interpolate.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iostream>
#include <map>
#include <memory>
#include <string>

using namespace dealii;
using vfife::ExplicitSolid;

constexpr double      length = 50, gap = .01, speed = 2000;
const vfife::Material steel;

struct Bar
{
  Triangulation<3>               triangulation;
  FESystem<3>                    fe{FE_Q<3>(1), 3};
  DoFHandler<3>                  dof_handler{triangulation};
  AffineConstraints<double>      constraints;
  std::unique_ptr<ExplicitSolid> solid;
  Vector<double>                 forces;

  /** Along x from @p start; cells are divided in the middle where asked for. */
  void make_grid(const double start, const bool refined)
  {
    GridGenerator::subdivided_hyper_rectangle(
      triangulation, {100, 2, 2}, Point<3>(start, 0, 0), Point<3>(start + length, 1, 1), true);
    for (const auto &cell : triangulation.active_cell_iterators())
      {
        cell->set_material_id(0);
        if (refined && std::abs(cell->center()[0] - start - length / 2) < length / 10)
          cell->set_refine_flag();
      }
    triangulation.execute_coarsening_and_refinement();
  }

  /** Hanging nodes, sides y and z that slide, and the solid. */
  void setup_system()
  {
    dof_handler.distribute_dofs(fe);
    DoFTools::make_hanging_node_constraints(dof_handler, constraints);
    for (const unsigned int side : {2, 3, 4, 5})
      VectorTools::interpolate_boundary_values(dof_handler,
                                               side,
                                               Functions::ZeroFunction<3>(3),
                                               constraints,
                                               ComponentMask({false, side <= 3, side >= 4}));
    constraints.close();
    solid =
      std::make_unique<ExplicitSolid>(dof_handler,
                                      constraints,
                                      std::map<types::material_id, vfife::Material>{{0, steel}},
                                      ExplicitSolid::Options());
    forces.reinit(dof_handler.n_dofs());
  }

  /** Velocity v along x at time 0. */
  void start(const double v, const double dt)
  {
    Vector<double> velocity(dof_handler.n_dofs());
    VectorTools::interpolate(dof_handler,
                             Functions::ConstantFunction<3>(std::vector<double>{v, 0, 0}),
                             velocity);
    solid->set_state(forces, velocity, dt); // the forces are zero, as the displacements are
  }

  /** Along x [N s]. */
  double momentum() const
  {
    double         sum = 0;
    const IndexSet along_x =
      DoFTools::extract_dofs(dof_handler, fe.component_mask(FEValuesExtractors::Scalar(0)));
    for (const auto i : along_x)
      sum += solid->lumped_masses()[i] * solid->velocity()[i];
    return sum;
  }

  void output_results(const std::string &name) const
  {
    DataOut<3> data_out;
    data_out.attach_dof_handler(dof_handler);
    for (const auto &[field, label] : {std::make_pair(&solid->displacement(), "displacement"),
                                       std::make_pair(&solid->velocity(), "velocity")})
      data_out.add_data_vector(
        *field,
        std::vector<std::string>(3, label),
        DataOut<3>::type_dof_data,
        std::vector<DataComponentInterpretation::DataComponentInterpretation>(
          3, DataComponentInterpretation::component_is_part_of_vector));
    data_out.build_patches();
    std::ofstream file(name + ".vtu");
    data_out.write_vtu(file);
  }
};

int main()
{
  Bar flying, resting;
  flying.make_grid(0, true);
  resting.make_grid(length + gap, false);
  flying.setup_system();
  resting.setup_system();

  vfife::ContactOptions options;
  options.edge_fading = 0; // both faces end at the same edges
  vfife::SolidContact contact(*flying.solid, 1, *resting.solid, 0, options);
  const double        dt =
    contact.stable_step(std::min(flying.solid->stable_step(), resting.solid->stable_step()));
  flying.start(speed, dt);
  resting.start(0, dt);

  const double c    = std::sqrt((steel.lambda() + 2 * steel.mu()) / steel.density),
               wave = 2 * length / c, momentum = flying.momentum(), mass = momentum / speed,
               energy_at_start = .5 * momentum * speed;
  double contact_time = 0, energy = 0;
  for (unsigned int n = 0; n * dt < gap / speed + 1.5 * wave; ++n)
    {
      flying.forces  = 0;
      resting.forces = 0;
      contact.add_forces(flying.forces, resting.forces);
      flying.solid->step(flying.forces);
      resting.solid->step(resting.forces);
      energy = flying.solid->kinetic_energy() + flying.solid->strain_energy() +
               resting.solid->kinetic_energy() + resting.solid->strain_energy() + contact.energy();
      contact_time += contact.force().norm() > 0 ? dt : 0;
      if (n % 100 == 0)
        std::cout << "time " << 1e6 * n * dt << " us, velocities " << flying.momentum() / mass
                  << " and " << resting.momentum() / mass << " mm/s, contact force "
                  << contact.force().norm() << " N" << std::endl;
    }
  std::cout << "contact time over 2 L/c: " << contact_time / wave
            << "\nvelocities over the first one: " << flying.momentum() / momentum << ' '
            << resting.momentum() / momentum << "\nmomentum, energy over those at the start: "
            << (flying.momentum() + resting.momentum()) / momentum << ' '
            << energy / energy_at_start << std::endl;
  flying.output_results("flying");
  resting.output_results("resting");
}
