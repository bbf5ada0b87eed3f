// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_tests_plugin_solid_mesh_h
#define vfife_tests_plugin_solid_mesh_h

#include <vfife/base/types.h>
#include <vfife/plugin/explicit_solid.h>

#include <deal.II/dofs/dof_accessor.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/grid_tools.h>
#include <deal.II/grid/tria.h>
#include <deal.II/numerics/vector_tools_boundary.h>

#include <functional>
#include <vector>

/** A deal.II program's mesh, DoFs and constraints. */
struct SolidMesh
{
  using Vector = vfife::ExplicitSolid::Vector;

  dealii::Triangulation<3>          triangulation;
  dealii::FESystem<3>               element{dealii::FE_Q<3>(1), 3};
  dealii::DoFHandler<3>             dofs;
  dealii::AffineConstraints<double> constraints;
  std::vector<vfife::Vector3>       places; ///< vertex of each DoF
  std::vector<unsigned int>         component;

  /** The block [0, size] of equal cells, with boundary ids 0 to 5. */
  void make_block(const vfife::Vector3 &size, const std::vector<unsigned int> &counts)
  {
    dealii::GridGenerator::subdivided_hyper_rectangle(
      triangulation, counts, dealii::Point<3>(), {size[0], size[1], size[2]}, true);
    for (const auto &cell : triangulation.active_cell_iterators())
      cell->set_material_id(0); // instead of those of the octants
  }

  void refine_where(const std::function<bool(const dealii::Point<3> &)> &takes)
  {
    for (const auto &cell : triangulation.active_cell_iterators())
      if (takes(cell->center()))
        cell->set_refine_flag();
    triangulation.execute_coarsening_and_refinement();
  }

  /** Hanging nodes, and components that are zero on boundaries: bits 1, 2, 4 of x, y, z by boundary
   * id. */
  void setup(const std::map<unsigned int, unsigned int> &held = {})
  {
    dofs.reinit(triangulation);
    dofs.distribute_dofs(element);
    constraints.clear();
    dealii::DoFTools::make_hanging_node_constraints(dofs, constraints);
    for (const auto &[boundary, bits] : held)
      dealii::VectorTools::interpolate_boundary_values(
        dofs,
        boundary,
        dealii::Functions::ZeroFunction<3>(3),
        constraints,
        dealii::ComponentMask({(bits & 1u) != 0, (bits & 2u) != 0, (bits & 4u) != 0}));
    constraints.close();
    places.resize(dofs.n_dofs());
    component.resize(dofs.n_dofs());
    for (const auto &cell : dofs.active_cell_iterators())
      for (unsigned int v = 0; v < 8; ++v)
        for (unsigned int c = 0; c < 3; ++c)
          {
            const auto &x                           = cell->vertex(v);
            places[cell->vertex_dof_index(v, c)]    = vfife::Vector3(x[0], x[1], x[2]);
            component[cell->vertex_dof_index(v, c)] = c;
          }
  }

  /** Values of a vector field at the vertices. */
  Vector interpolate(const std::function<vfife::Vector3(const vfife::Vector3 &)> &field) const
  {
    Vector vector(dofs.n_dofs());
    for (std::size_t i = 0; i < places.size(); ++i)
      vector[i] = field(places[i])[component[i]];
    return vector;
  }

  Vector zero() const
  {
    return Vector(dofs.n_dofs());
  }

  /** With one material of all cells. */
  std::map<dealii::types::material_id, vfife::Material> steel() const
  {
    return {{0, vfife::Material()}};
  }
};

#endif
