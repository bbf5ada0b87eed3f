// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// What bodies do under forces by one of their sectors, beside the factors of the whole bodies.
#include "../ranks.h"
#include "../reduced/whole_body.h"
#include "../refusal.h"
#include "pair_in_bearings.h"

#include <vfife/fem/cyclic/cyclic_body.h>
#include <vfife/fem/statics/compliance.h>

using namespace vfife;

using Field = std::vector<double>;

/** Forces that have nothing to do with sectors. */
Field some_forces(const std::size_t n)
{
  Field forces;
  for (std::size_t i = 0; i < n; ++i)
    forces.push_back(std::sin(1.7 * i) + (i % 11 == 0 ? 5. : 0.));
  return forces;
}

/** Both ways: state of spin, answer to the torque, to forces everywhere and to unit forces at
 * nodes of some sectors. */
void compare(const std::string  &name,
             const Model        &model,
             const Communicator &communicator,
             const FemElement    element    = FemElement::incompatible_modes,
             const std::string  &refinement = "",
             const double        tolerance  = 1e-8)
{
  const bool spins = model.bodies[0].rate != 0;
  FemOptions options;
  options.element = element;
  if (!refinement.empty())
    options.local_refinement = {refinement};
  Compliance sectors(model, options, spins, communicator),
    bodies(model, options, spins, communicator, Factorized::bodies);
  check(name + ": by sectors", sectors.by_sectors() && !bodies.by_sectors());
  check(name + ": unknowns", sectors.n_unknowns() == bodies.n_unknowns());
  // Found by Newton's method to 1e-7.
  if (spins || model.bodies[0].has_initial_strains())
    check_below(name + ": state of spin",
                relative_difference(bodies.spun(), sectors.spun()),
                tolerance);
  check_below(name + ": torque",
              relative_difference(bodies.twisted(), sectors.twisted()),
              tolerance);
  const Field forces = some_forces(bodies.spun().size());
  check_below(name + ": forces",
              relative_difference(bodies.solve(forces), sectors.solve(forces)),
              tolerance);

  const unsigned int n          = model.bodies[0].n_nodes(),
                     per_sector = n / model.bodies[0].mesh().structure.n_sectors();
  std::vector<unsigned int> nodes;
  for (const unsigned int sector : {0u, 1u, 4u, model.bodies[0].mesh().structure.n_sectors() - 1})
    for (unsigned int i = 0; i < per_sector; i += 1 + per_sector / 9)
      nodes.push_back(sector * per_sector + i);
  const std::vector<unsigned int> rows  = numbers_below(3 * nodes.size());
  double                          worst = 0, largest = 0;
  for (Compliance *compliance : {&sectors, &bodies})
    {
      compliance->watch(nodes);
      compliance->prepare(rows);
    }
  for (const unsigned int row : rows)
    {
      raise_to(worst, (sectors.column(row) - bodies.column(row)).cwiseAbs().maxCoeff());
      raise_to(largest, bodies.column(row).cwiseAbs().maxCoeff());
    }
  check_below(name + ": unit forces", worst / largest, tolerance);
}

/** The loaded pair both ways. */
void pair(const std::string  &name,
          const Model        &model,
          const Communicator &communicator,
          const FemOptions   &options   = lumped_masses(),
          const double        tolerance = 1e-8)
{
  const auto find = [&](const Factorized factorized) {
    Compliance compliance(model, options, true, communicator, factorized);
    check(name + ": sectors or bodies",
          compliance.by_sectors() == (factorized == Factorized::sectors));
    PairEquilibrium equilibrium(model, compliance, {.1});
    return equilibrium.solve(.1, 1.);
  };
  const PairEquilibriumResult sectors = find(Factorized::sectors),
                              bodies  = find(Factorized::bodies);
  check(name + ": teeth", sectors.teeth.size() == bodies.teeth.size());
  check_ratio(name + ": first touch", sectors.touch_turn / bodies.touch_turn, tolerance);
  check_ratio(name + ": turn", sectors.turn / bodies.turn, tolerance);
  check_ratio(name + ": slope", sectors.turn_slope / bodies.turn_slope, tolerance);
  check_below(name + ": displacements",
              relative_difference(bodies.displacements, sectors.displacements),
              tolerance);
}

int main(int argc, char **argv)
{
  const TestRanks     ranks(argc, argv);
  const Communicator &world = ranks.world;

  for (const double rate : {0., 3000.})
    for (const auto &[name, hub] : {std::pair("led wheel", ConstraintKind::prescribed_rotation),
                                    std::pair("free wheel", ConstraintKind::free_rotation),
                                    std::pair("wheel on a rigid hub", ConstraintKind::rigid_hub)})
      compare(std::string(name) + (rate > 0 ? " in spin" : ""), make_wheel(hub, rate), world);
  for (const FemElement element : {FemElement::quadratic, FemElement::cubic})
    for (const double rate : {0., 3000.})
      compare("wheel of degree " + std::to_string(degree_of(element)),
              make_wheel(ConstraintKind::free_rotation, rate, {{2, 12, 1}}),
              world,
              element);
  // Two divided elements touch the border between sectors, and one above does not.
  for (const FemElement element : {FemElement::incompatible_modes, FemElement::quadratic})
    for (const double rate : {0., 3000.})
      compare("refined wheel of degree " + std::to_string(degree_of(element)),
              make_wheel(ConstraintKind::free_rotation, rate, {{2, 12, 1}}),
              world,
              element,
              "outer 1");
  compare("quadratic pinion",
          make_pinion(ConstraintKind::prescribed_rotation, 0., world),
          world,
          FemElement::quadratic);
  compare("pinion", make_pinion(ConstraintKind::prescribed_rotation, 2000., world), world);
  compare("free pinion", make_pinion(ConstraintKind::free_rotation, 2000., world), world);

  // Bearings: at rest of any kind, in spin alike across the axis, as a driver and as a driven body.
  for (const double rate : {0., 3000.})
    for (const double coupling : {0., 1e8})
      for (const FemElement element : {FemElement::incompatible_modes, FemElement::quadratic})
        {
          const std::array<unsigned int, 3> cells = element == FemElement::quadratic
                                                      ? std::array<unsigned int, 3>{{2, 12, 1}}
                                                      : std::array<unsigned int, 3>{{6, 12, 4}};
          Model                             wheel = hang_in_bearings(
            make_wheel(std::nullopt, rate, cells), "inner", 2e5, rate > 0 ? 1. : 1.7, coupling);
          if (coupling > 0)
            wheel.transmissions.clear();
          compare(std::string(coupling > 0 ? "driving" : "driven") + " wheel in bearings, degree " +
                    std::to_string(degree_of(element)) + (rate > 0 ? ", in spin" : ""),
                  wheel,
                  world,
                  element);
        }

  Model held = make_held_pair(world), hung = make_held_pair(world);
  hang_in_bearings(hung,
                   {linear_bearing(soft_front),
                    linear_bearing(soft_back),
                    linear_bearing(soft_front),
                    linear_bearing(soft_back)},
                   5e8);
  for (Body &body : hung.bodies)
    body.floats = true;
  // Whole bodies are factorized near their state of spin (1e-5 of its displacements), and their pin
  // leaves a turn of that order to whoever asks for it.
  compare("bodies of a pair in bearings", hung, world, FemElement::incompatible_modes, "", 1e-6);
  pair("pair in bearings", hung, world, lumped_masses(), 1e-6);
  pair("pair", held, world);
  for (Constraint &constraint : held.constraints)
    if (constraint.kind == ConstraintKind::rigid_hub)
      constraint.kind = ConstraintKind::free_rotation;
  pair("pair that turns freely", held, world);
  FemOptions divided       = lumped_masses();
  divided.local_refinement = {"concave 1"};
  pair("pair with divided flanks", held, world, divided);

  // What is not alike in all sectors is left to the whole body.
  Model pushed = make_wheel(ConstraintKind::prescribed_rotation, 0.);
  Load  push;
  push.name   = "push";
  push.nodes  = {0};
  push.vector = Vector3(1., 0., 0.);
  pushed.loads.push_back(push);
  check("a pushed wheel", !Compliance(pushed, {}, false, world).by_sectors());
  Model half = make_wheel(ConstraintKind::prescribed_rotation, 0.);
  half.constraints[0].nodes.resize(half.constraints[0].nodes.size() / 2);
  check("a wheel half held", !Compliance(half, {}, false, world).by_sectors());
  // A temperature acts at rest too.
  for (const double rate : {0., 3000.})
    {
      Model               warm      = make_wheel(ConstraintKind::prescribed_rotation, rate);
      const BodyStructure structure = warm.bodies[0].structure();
      std::vector<double> strains;
      for (unsigned int e = 0; e < warm.bodies[0].n_elements(); ++e)
        // Temperatures at the centres of elements differ by round-off between sectors.
        strains.push_back(1e-4 * (1. + structure.first_copy_of_element(e) % 3) +
                          1e-20 * structure.sector_of_element(e));
      warm.bodies[0].add_initial_strains(strains);
      check("a warm wheel has equal sectors", has_equal_sectors(warm, 0, {}));
      compare("warm wheel", warm, world);
      compare("quadratic warm wheel", warm, world, FemElement::quadratic);
      strains.assign(strains.size(), 0.);
      strains[0] = 1e-4;
      warm.bodies[0].add_initial_strains(strains);
      check("not one with a warm element", !has_equal_sectors(warm, 0, {}));
      check("which has a compliance", !Compliance(warm, {}, false, world).by_sectors());
    }
  const Model fast = make_wheel(ConstraintKind::prescribed_rotation, 3e5);
  print_refusal<NumericalError>([&] { Compliance(fast, {}, true, world); });
  return 0;
}
