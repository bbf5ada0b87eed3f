// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// Statics on distributed meshes: equal to the direct solver on the same mesh, with hanging nodes,
// on curved elements and under supports along skew directions; uniaxial stress; equal on all ranks.
#include "../composite.h"
#include "../ranks.h"
#include "../tests.h"

#include <vfife/fem/distributed/distributed_statics.h>

using namespace vfife;

Load make_load(const LoadKind kind, const std::vector<unsigned int> &nodes, const Vector3 &vector)
{
  Load load;
  load.name   = "load";
  load.kind   = kind;
  load.nodes  = nodes;
  load.vector = vector;
  return load;
}

/** Each kind of load on a block whose inner nodes are moved, one side held, one led. */
Model make_loaded_block()
{
  auto mesh = make_block(Vector3(20., 15., 10.), {{3, 3, 3}});
  for (const auto &cell : mesh->triangulation.active_cell_iterators())
    for (unsigned int v = 0; v < 8; ++v)
      if (auto &x = cell->vertex(v);
          x[0] > 1. && x[0] < 19. && x[1] > 1. && x[1] < 14. && x[2] > 1. && x[2] < 9.)
        x[v % 3] += .2;
  Model model                = model_of(Body("block", std::move(mesh), {}));
  Body &body                 = model.bodies[0];
  body.placement.rotation    = rotation_about(Vector3(1., 2., 3.).normalized(), .7);
  body.placement.translation = Vector3(3., -2., 1.);
  model.constraints.push_back({"foot", ConstraintKind::held, 0, body.node_set("x-")});
  model.constraints.push_back(hold(body.node_set("x+"), {{false, true, false}}));
  model.constraints.back().displacement[1] = 1e-3;
  model.loads = {make_load(LoadKind::force, body.node_set("x+"), Vector3(100., -200., 50.)),
                 make_load(LoadKind::moment, body.node_set("x+"), Vector3(300., 100., -200.)),
                 pressure_on(body.node_set("y+"), 5.),
                 make_load(LoadKind::acceleration, all_nodes(body), Vector3(0., 0., -1e7)),
                 make_load(LoadKind::acceleration, body.node_set("y-"), Vector3(1e7, 0., 0.)),
                 make_load(LoadKind::force, {body.node_set("x+").front()}, Vector3(0., 9., 0.))};
  return model;
}

/** A cylinder that is twisted at the top, held along the radius outside, under a torque. */
Model make_twisted_rod()
{
  Model       model = model_of(Body("rod", make_cylinder(10., 8., {{2, 2, 2}}), {}));
  const Body &body  = model.bodies[0];
  model.constraints = {hold(body.node_set("bottom"), {{true, true, true}}),
                       hold(body.node_set("top"), {{false, true, false}}, true),
                       hold(body.node_set("outer"), {{true, false, false}}, true)};
  model.constraints[1].displacement[1] = 1e-3;
  model.loads                          = {pressure_on(body.node_set("top"), 10.)};
  model.torques.push_back(torque_on(model, "outer", 1e4));
  return model;
}

FemOptions make_options(const FemElement                element,
                        const FemGeometry               geometry,
                        const std::vector<std::string> &refinement)
{
  FemOptions options;
  options.distributed      = true;
  options.element          = element;
  options.geometry         = geometry;
  options.local_refinement = refinement;
  options.linear_tolerance = 1e-12;
  return options;
}

std::vector<double> list_stresses(const NodalSolution &solution)
{
  std::vector<double> list;
  for (const Stress &stress : solution.stresses)
    list.insert(list.end(), stress.data(), stress.data() + 6);
  return list;
}

std::vector<double> list_forces(const NodalSolution &solution, const bool moments)
{
  std::vector<double> list;
  for (const Reaction &reaction : solution.reactions)
    {
      const Vector3 &vector = moments ? reaction.moment : reaction.force;
      list.insert(list.end(), vector.data(), vector.data() + 3);
    }
  return list;
}

void compare(const std::string &name,
             const Model       &model,
             FemOptions         options,
             const TestRanks   &ranks)
{
  const NodalSolution found = DistributedStatics(model, 0, options, ranks.world).solve({});
  // All ranks have the whole solution of the direct solver.
  options.linear_solver = LinearSolverKind::direct;
  const StaticSolver  solver(model, {0}, options, ranks.alone);
  const NodalSolution direct = make_nodal_solution(solver, solver.solve({}));
  check(name + ": number of displacements", found.n_displacements == direct.n_displacements);
  check_ratio(name + ": strain energy", found.strain_energy / direct.strain_energy, 1e-9);
  check_ratio(name + ": largest displacement",
              found.largest_displacement / direct.largest_displacement,
              1e-9);
  check_below(name + ": displacements",
              relative_difference(direct.displacements, found.displacements),
              1e-9);
  check_below(name + ": stresses",
              relative_difference(list_stresses(direct), list_stresses(found)),
              1e-8);
  for (const bool moments : {false, true})
    check_below(name + (moments ? ": moments" : ": forces") + " of the supports",
                relative_difference(list_forces(direct, moments), list_forces(found, moments)),
                1e-8);
  check(name + ": less than 60 iterations", found.n_iterations > 0 && found.n_iterations < 60);
}

/** A block between two planes that is pulled: its stress is the same everywhere. */
void stretch(const FemElement element, const TestRanks &ranks)
{
  constexpr double strain = 1e-3;
  Model       model = model_of(Body("block", make_block(Vector3(2., 1.5, 1.), {{3, 3, 3}}), {}));
  const Body &body  = model.bodies[0];
  model.constraints = {hold(body.node_set("x-"), {{true, false, false}}),
                       hold(body.node_set("x+"), {{true, false, false}}),
                       hold(body.node_set("y-"), {{false, true, false}}),
                       hold(body.node_set("z-"), {{false, false, true}})};
  model.constraints[1].displacement[0] = 2. * strain;
  FemOptions options       = make_options(element, FemGeometry::straight, {"y- 1", "x+ 2"});
  options.linear_tolerance = 1e-14;
  DistributedStatics solver(model, 0, options, ranks.world);
  solver.solve({});
  const double back  = -body.materials().front().poissons_ratio * strain;
  double       worst = 0;
  solver.for_points([&](const Vector3 &x, const Vector3 &u) {
    raise_to(worst, (u - x.cwiseProduct(Vector3(strain, back, back))).norm());
  });
  check_below("stretched block, " + word_of(element, fem_element_choices()),
              ranks.world.max(worst) / strain,
              1e-12);
}

void same_on_all_ranks(const TestRanks &ranks)
{
  const Model      model   = make_twisted_rod();
  const FemOptions options = make_options(FemElement::quadratic, FemGeometry::curved, {"all 1"});
  const double alone = DistributedStatics(model, 0, options, ranks.alone).solve({}).strain_energy;
  const double together =
    DistributedStatics(model, 0, options, ranks.world).solve({}).strain_energy;
  check_ratio("strain energy of all ranks over that of one", together / alone, 1e-10);
}

int main(int argc, char **argv)
{
  const TestRanks ranks(argc, argv);
  for (const FemElement element : {FemElement::full, FemElement::quadratic, FemElement::cubic})
    {
      const std::string word     = word_of(element, fem_element_choices());
      const bool        is_cubic = element == FemElement::cubic;
      const FemGeometry geometry =
        element == FemElement::full ? FemGeometry::straight : FemGeometry::curved;
      if (!is_cubic)
        compare(word + ", block",
                make_loaded_block(),
                make_options(element, FemGeometry::straight, {}),
                ranks);
      compare(word + ", refined block",
              make_loaded_block(),
              make_options(element, FemGeometry::straight, {is_cubic ? "x- 1" : "x- 2"}),
              ranks);
      compare(word + ", refined rod",
              make_twisted_rod(),
              make_options(element, geometry, {"top 1"}),
              ranks);
      stretch(element, ranks);
    }
  same_on_all_ranks(ranks);
  return 0;
}
