// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// Natural vibrations: annular plate with each element, free block, both eigenvalue solvers.
#include "../model_parts.h"
#include "../refusal.h"
#include "../tests.h"

#include <vfife/base/process/communicator.h>
#include <vfife/base/process/mpi_session.h>
#include <vfife/fem/modes/modal_solver.h>
#include <vfife/fem/modes/mode_description.h>
#include <vfife/fem/system/rigid_motions.h>
#include <vfife/mesh/primitives/primitives.h>

using namespace vfife;

/** Of a body at rest. */
ModalResult solve(const Model &model, const FemOptions &options, const Communicator &communicator)
{
  const FemSpace          d(model, {0}, options.element);
  FemConstraints::Options constraints;
  constraints.padded = ModalSolver::needs_padding(options);
  const FemSystem   system(d, constraints, communicator);
  const ModalSolver solver(system, options);
  return solver.solve(solver.matrices().stiffness(constant_rate(0.)),
                      solver.matrices().mass(),
                      0.,
                      find_free_motions(d, d.parts()[0]));
}

Model make_plate(const std::array<unsigned int, 3> &counts)
{
  Material steel;
  steel.poissons_ratio = .3;
  Model model          = model_of(Body("plate", make_ring(50., 100., 1., counts), steel));
  model.constraints.push_back(
    {"clamp", ConstraintKind::held, 0, model.bodies[0].node_set("inner")});
  return model;
}

/** lambda^2 of the thin plate for n = 0..4 nodal diameters (Vogel & Skinner 1965). */
const std::array<double, 5> references = {{13.0243, 13.2898, 14.7038, 18.5620, 25.5958}};

void annular_plate(const Communicator &communicator)
{
  for (const auto &choice : fem_element_choices())
    {
      const std::array<unsigned int, 3> cells[] = {{{12, 72, 1}}, {{6, 48, 1}}, {{4, 32, 1}}};
      const Model                       model   = make_plate(cells[degree_of(choice.second) - 1]);
      FemOptions                        options;
      options.element           = choice.second;
      options.n_modes           = 9;
      const ModalResult result  = solve(model, options, communicator);
      const Material   &m       = model.bodies[0].materials().front();
      const double      bending = m.youngs_modulus / (12. * (1. - .09)); // thickness 1
      const double      scale   = std::sqrt(bending / m.density) / (2. * pi * 100. * 100.);
      check("modes are counted", result.counted);
      const FemSpace      d(model, {0}, options.element);
      const ModeDescriber describer(d, d.parts()[0]);
      for (unsigned int k = 0; k < 9; ++k)
        {
          const ModeDescription description = describer.describe(result.modes[k].shape);
          const unsigned int    n           = (k + 1) / 2;
          const double          ratio       = result.modes[k].frequency() / scale / references[n];
          if (choice.second == FemElement::full)
            // It locks: cells of 4 mm in a plate of 1 mm.
            check("full: too stiff", ratio > 1.3);
          else
            {
              check("nodal diameters",
                    description.nodal_diameter == int(n) && description.share > .999);
              check("nodal circles", description.nodal_circles == 0);
              // Measured 2.6 % at four diameters, falling with the square of the cells
              // (doc/verification/element.md).
              check_ratio(choice.first + ", frequency over reference", ratio, 3e-2);
            }
        }
    }
}

/** The plate as a file may bring it: nodes and cells in any order, nothing said of sectors. */
Model make_shuffled_plate(const Model &plate)
{
  const Body        &body = plate.bodies[0];
  const unsigned int n    = body.n_nodes();
  // 7 does not divide the number of nodes: a permutation.
  const auto           moved = [n](const unsigned int i) { return (7 * i + 5) % n; };
  std::vector<Vector3> nodes(n);
  for (unsigned int i = 0; i < n; ++i)
    nodes[moved(i)] = body.node_positions()[i];
  std::vector<CellNodes> cells;
  for (auto element = body.elements().rbegin(); element != body.elements().rend(); ++element)
    {
      cells.push_back(*element);
      for (unsigned int &node : cells.back())
        node = moved(node);
    }
  auto mesh = std::make_unique<BodyMesh>();
  create_triangulation(*mesh, nodes, cells);
  std::vector<unsigned int> inner;
  for (const unsigned int i : body.node_set("inner"))
    inner.push_back(moved(i));
  std::sort(inner.begin(), inner.end());
  Model model = model_of(Body("plate", std::move(mesh), body.materials().front()));
  model.constraints.push_back({"clamp", ConstraintKind::held, 0, inner});
  return model;
}

void shuffled_plate(const Communicator &communicator)
{
  const Model plate = make_plate({{4, 30, 1}});
  FemOptions  options;
  options.n_modes            = 9;
  const Model         model  = make_shuffled_plate(plate);
  const ModalResult   result = solve(model, options, communicator);
  const FemSpace      d(model, {0}, options.element);
  const ModeDescriber describer(d, d.parts()[0]);
  for (unsigned int k = 0; k < 9; ++k)
    {
      const ModeDescription description = describer.describe(result.modes[k].shape);
      check("nodes in any order: nodal diameters",
            description.nodal_diameter == static_cast<int>((k + 1) / 2) &&
              description.share > .999);
    }
  // One node out of its place, and no part of a revolution does it any more.
  std::vector<Vector3> places = plate.bodies[0].node_positions();
  check("sectors of the plate", find_cyclic_copies(places, Vector3::UnitZ()).n_sectors == 30);
  places[17] *= 1.01;
  check("no sectors", find_cyclic_copies(places, Vector3::UnitZ()).n_sectors == 0);
  // Points on the axis belong to no sector; a quarter turn is a sector.
  CyclicCopies cross = find_cyclic_copies({Vector3(0., 0., 1.),
                                           Vector3(2., 0., 0.),
                                           Vector3(0., 2., 0.),
                                           Vector3(-2., 0., 0.),
                                           Vector3(0., -2., 0.)},
                                          Vector3::UnitZ());
  check("points on the axis",
        cross.n_sectors == 4 && cross.points == std::vector<unsigned int>({1, 2, 3, 4}));
}

/**
 * NAFEMS FV52, solid square plate 10 x 10 x 1 m whose four lower edges keep their height: here by
 * springs of a thousand times the largest diagonal entry.
 */
void nafems_plate(const FemElement                   element,
                  const std::array<unsigned int, 3> &counts,
                  const std::array<double, 7>       &tolerances,
                  const Communicator                &communicator)
{
  Material steel;
  steel.youngs_modulus = 200000.;
  steel.poissons_ratio = .3;
  steel.density        = 8e-9;
  Model      model     = model_of(Body("plate", make_block(Vector3(1e4, 1e4, 1e3), counts), steel));
  FemOptions options;
  options.element = element;
  options.n_modes = 10;
  const FemSpace    d(model, {0}, element);
  const FemSystem   system(d, {}, communicator);
  const ModalSolver solver(system, options);
  FemMatrix         K        = solver.matrices().stiffness(constant_rate(0.));
  const OwnedVector diagonal = K.diagonal();
  const double      spring   = 1e3 * *std::max_element(diagonal.begin(), diagonal.end());
  std::vector<std::pair<unsigned int, Matrix3>> springs;
  for (unsigned int p = 0; p < d.n_points(); ++p)
    {
      const Vector3 x       = d.points()[p];
      const bool    on_edge = std::min({x[0], x[1], 1e4 - x[0], 1e4 - x[1]}) < 1e-6;
      if (x[2] < 1e-6 && on_edge)
        springs.emplace_back(p, spring * Vector3::UnitZ() * Vector3::UnitZ().transpose());
    }
  K = add_scaled(std::move(K), 1., system.point_matrix(springs));
  // The springs hold one translation and two rotations.
  const auto        rigid = make_rigid_motions(d, d.parts()[0], Vector3(5e3, 5e3, 0.));
  const ModalResult result =
    solver.solve(K, solver.matrices().mass(), 0., {rigid[0], rigid[1], rigid[5]});
  check("NAFEMS FV52: three rigid motions", result.n_rigid == 3);
  const std::array<double, 7> references = {
    {45.897, 109.44, 109.44, 167.89, 193.59, 206.19, 206.19}};
  for (unsigned int k = 0; k < 7; ++k)
    check_ratio("NAFEMS FV52, " + word_of(element, fem_element_choices()) + ", over reference",
                result.modes[k + 3].frequency() / references[k],
                tolerances[k]);
}

void free_block(const Communicator &communicator)
{
  Model model = model_of(Body("block", make_block(Vector3(60., 10., 8.), {{12, 3, 3}}), {}));
  std::vector<double> reference;
  for (const EigenSolverKind kind : {EigenSolverKind::shift_invert, EigenSolverKind::lobpcg})
    for (const MassKind mass : {MassKind::consistent, MassKind::lumped})
      {
        FemOptions options;
        options.n_modes          = 10;
        options.eigen_solver     = kind;
        options.mass             = mass;
        options.eigen_tolerance  = 1e-8;
        const ModalResult result = solve(model, options, communicator);
        check("six rigid motions", result.n_rigid == 6);
        // Only rigid motions move mass on the whole, as the body is free.
        double total = 0, elastic = 0;
        for (unsigned int k = 0; k < 10; ++k)
          (k < 6 ? total : elastic) += result.modes[k].effective_mass[0] / model.bodies[0].mass();
        check_ratio("effective mass of the rigid motions", total, 1e-9);
        check_below("effective mass of the others", elastic, 1e-9);
        for (unsigned int k = 6; k < 10; ++k)
          {
            if (kind == EigenSolverKind::shift_invert)
              reference.push_back(result.modes[k].frequency());
            else
              // Eigenvalues are as exact as the square of the residual.
              check_ratio("LOBPCG against shift-invert",
                          result.modes[k].frequency() /
                            reference[(mass == MassKind::lumped) * 4 + k - 6],
                          1e-7);
          }
      }
  // First bending across the thin side of a free beam (Timoshenko's shear and inertia lower the
  // slender 4.7300^2 by some percent at 60:8).
  const Material &m = model.bodies[0].materials().front();
  const double    slender =
    22.3733 / (2. * pi) * std::sqrt(m.youngs_modulus * 64. / (12. * m.density)) / 3600.;
  check_close("first bending over the slender beam", reference[0] / slender, .95, .03);
}

void messages(const Communicator &communicator)
{
  Model model = model_of(Body("block", make_block(Vector3(1., 1., 1.), {{1, 1, 1}}), {}));
  print_refusal([&] { solve(model, {}, communicator); });
}

int main(int argc, char **argv)
{
  MpiSession          session(argc, argv);
  const Communicator &communicator = session.world();
  annular_plate(communicator);
  shuffled_plate(communicator);
  // What these meshes give; a line support has no limit under refinement
  // (doc/verification/element.md).
  nafems_plate(FemElement::incompatible_modes,
               {{8, 8, 3}},
               {{.02, .05, .05, .04, .02, .02, .02}},
               communicator);
  nafems_plate(FemElement::quadratic,
               {{4, 4, 2}},
               {{.04, .01, .01, .03, .002, .003, .003}},
               communicator);
  free_block(communicator);
  messages(communicator);
  return 0;
}
