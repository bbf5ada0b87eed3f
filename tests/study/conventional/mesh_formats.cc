// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// A loaded block from a file of each format that deal.II reads, against the same block from a
// format with a reader of its own; and from a triangulation.
#include "../../model_sections.h"
#include "../../refusal.h"
#include "../cases/region_meshes.h"
#include "../quick_pair.h"

#include <vfife/base/process/mpi_session.h>
#include <vfife/mesh/files/mesh_import.h>

#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/grid_out.h>

using namespace vfife;

using Columns = std::map<std::string, std::vector<double>>;

const region_meshes::Box box = {
  3, "column", Vector3(1, 2, 3), Vector3(6, 5, 20), {{2, 3, 4}}, 11, 12};

/** The nodes of both ends by names, or by places where a format has no ids. */
struct Ends
{
  std::string bottom = "boundary 11", top = "boundary 12";
};

/** Held at the bottom, pushed aside at the top. */
Columns solve(const std::string &file, const Ends &ends, Communicator &world)
{
  using model_text::section;
  return run_text(
    "formats",
    section("Study", "set kind = linear static\n") +
      section("Model",
              "set bodies = column\nset constraints = foot\nset loads = push\n"
              "set probes = corner\n" +
                section("Body column", "set mesh = file\nset file = " + file + "\n") +
                section("Constraint foot", "set kind = fixed\nset nodes = " + ends.bottom + "\n") +
                section("Load push",
                        "set kind = force\nset force = 300, -200, 500 N\nset nodes = " + ends.top +
                          "\n") +
                model_text::probe("corner", "7, 7, 23 mm")) +
      section("Fem", "set linear solver = direct\n") + quiet_output(1),
    world);
}

/** A file "column.vtu" of deal.II's from which the triangulation can be read again. */
template <int dim>
void write_vtu_of_dealii(const dealii::Triangulation<dim> &grid)
{
  dealii::GridOut           out;
  dealii::GridOutFlags::Vtu flags;
  flags.serialize_triangulation = true;
  out.set_flags(flags);
  std::ofstream file("column.vtu");
  out.write_vtu(grid, file);
}

/** The column with ids. */
void make_column(dealii::Triangulation<3> &grid, const std::vector<unsigned int> &cells)
{
  dealii::GridGenerator::subdivided_hyper_rectangle(grid, cells, {1, 2, 3}, {7, 7, 23});
  for (const auto &cell : grid.active_cell_iterators())
    {
      cell->set_material_id(3);
      for (const unsigned int f : {4u, 5u})
        if (cell->face(f)->at_boundary())
          cell->face(f)->set_boundary_id(f + 7);
    }
}

int main(int argc, char **argv)
{
  MpiSession    session(argc, argv);
  Communicator &world = session.world();
  region_meshes::write("column.vtk", region_meshes::make({box}));
  const Columns reference = solve("column.vtk", {}, world);
  const auto    compare   = [&](const std::string &file, const Ends &ends) {
    const Columns found   = solve(file, ends, world);
    double        largest = 0, error = 0;
    for (const char *column : {"corner displacement x",
                               "corner displacement y",
                               "corner displacement z",
                               "strain energy",
                               "foot reaction moment x"})
      {
        const double value = reference.at(column).back();
        raise_to(largest, std::abs(value));
        raise_to(error, std::abs(found.at(column).back() / value - 1.));
      }
    check(file + ": moved", largest > 0.01);
    // Other orders of nodes and elements: round-off of the direct solver.
    check_below(file + ": against column.vtk", error, 1e-10);
  };
  dealii::Triangulation<3> column, coarse;
  make_column(column, {2, 3, 4});
  write_vtu_of_dealii(column);
  for (const char *file : {"column.msh", "column.ucd", "column.unv", "column.xda"})
    region_meshes::write(file, region_meshes::make({box}));
  compare("column.msh", {"column bottom", "column top"});
  for (const char *file : {"column.ucd", "column.unv", "column.vtu"})
    compare(file, {});
  compare("column.xda", {"all\nset where = z < 3.1", "all\nset where = z > 22.9"});

  // Active cells count: a coarse mesh that was refined everywhere.
  make_column(coarse, {1, 3, 2});
  coarse.refine_global(1);
  write_vtu_of_dealii(coarse);
  const auto refined = read_body("column.vtu");
  check("refined everywhere", refined->triangulation.n_active_cells() == 48);
  check("ids of cells and faces as names",
        refined->regions.size() == 1 && refined->regions.at(1) == "region 3" &&
          refined->surfaces.size() == 2 && refined->surfaces.at("boundary 11").facets.size() == 12);

  dealii::Triangulation<3> grid;
  print_refusal([&] { make_body("grid", grid); });
  dealii::GridGenerator::hyper_cube(grid);
  check("a triangulation", make_body("grid", grid)->triangulation.n_active_cells() == 1);
  grid.refine_global(1);
  grid.begin_active()->set_refine_flag();
  grid.execute_coarsening_and_refinement();
  print_refusal([&] { make_body("grid", grid); });
  dealii::Triangulation<3> simplices;
  dealii::GridGenerator::subdivided_hyper_cube_with_simplices(simplices, 1);
  print_refusal([&] { make_body("grid", simplices); });
  dealii::Triangulation<3> inverted;
  dealii::GridGenerator::hyper_cube(inverted);
  inverted.begin_active()->vertex(7) = dealii::Point<3>(-.5, -.5, -.5);
  print_refusal([&] { make_body("grid", inverted); });
  dealii::Triangulation<2> plane;
  dealii::GridGenerator::hyper_cube(plane);
  plane.refine_global(1);
  write_vtu_of_dealii(plane);
  print_refusal([&] { read_body("column.vtu"); });
  return 0;
}
