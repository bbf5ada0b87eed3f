// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// Kernels of an instruction set (generic, or the one that is named) against the dense Eigen
// reference; empty lanes; choice of the set.
#include "../instruction_sets.h"
#include "../internal_force.h"
#include "../refusal.h"
#include "../tests.h"
#include "samples.h"

#include <vfife/element/frame.h>

#include <cstdlib>

using namespace vfife;

/** Largest differences over the elements of a run, relative to the round-off scales. */
struct Differences
{
  double force    = 0.; ///< over |K| x largest coordinate
  double energy   = 0.; ///< over |K| x largest coordinate x largest displacement
  double jacobian = 0.; ///< of the corners' least one
};

/**
 * 21 elements on nodes of their own in three packs, the last one with three empty lanes; shared:
 * eight rotated copies a pack. Coordinates near 100 mm, sides of 1 to 3 mm, strains up to @p
 * strain.
 */
Differences
compare(const InstructionSet set, const FrameKind frame, const bool shared, const double strain)
{
  const unsigned int n_elements = 21, n_packs = 3;
  Samples            samples;
  const Material     material;
  SamplePacks        packs;
  packs.resize(n_packs, 8 * n_elements + 1);

  std::vector<HexahedronNodes> X(n_elements), x(n_elements);
  std::vector<Matrix24>        K(n_elements);
  double                       largest_coordinate = 0.;
  for (unsigned int e = 0; e < n_elements; ++e)
    {
      const unsigned int pack = e / n_lanes, lane = e % n_lanes;
      if (shared && lane > 0)
        X[e] = X[e - lane];
      else
        X[e] = samples.hexahedron({1., 2., 3.}, 0.15, {60., 60., 50.});
      const auto reduced =
        compute_reduced_stiffness(X[e], material, StiffnessKind::incompatible_modes);
      K[e] = compute_stiffness(X[e], material, StiffnessKind::incompatible_modes);
      if (!shared)
        packs.set_constants(pack, lane, reduced, material);
      else if (lane == 0)
        {
          packs.constants.resize((pack + 1) * n_element_constants);
          write_constants(reduced, material, &packs.constants[pack * n_element_constants]);
          packs.constants_row.push_back(pack);
        }
      x[e] = (samples.rotation() * (X[e] + samples.displacement(0.5 * strain))).colwise() +
             samples.vector();
      raise_to(largest_coordinate, x[e].cwiseAbs().maxCoeff());
      for (unsigned int a = 0; a < 8; ++a)
        {
          packs.set_node(pack, lane, a, 8 * e + a);
          packs.set_position(8 * e + a, x[e].col(a));
        }
    }
  for (unsigned int empty = n_elements; empty < n_packs * n_lanes; ++empty)
    for (unsigned int a = 0; a < 8; ++a)
      packs.set_node(n_packs - 1, empty % n_lanes, a, 8 * n_elements);
  packs.set_position(8 * n_elements, {50., 60., 70.});

  std::vector<double> forces(packs.positions.size(), 1.), again(forces),
    energies(n_packs * n_lanes, -1.), jacobians(energies);
  const ElementKernels &kernels = select_kernels(frame, set);
  kernels.measure_internal_forces(packs.view(),
                                  0,
                                  n_packs,
                                  packs.positions.data(),
                                  forces.data(),
                                  energies.data(),
                                  jacobians.data());
  kernels.add_internal_forces(packs.view(), 0, 1, packs.positions.data(), again.data());
  kernels.add_internal_forces(packs.view(), 1, n_packs, packs.positions.data(), again.data());

  Differences differences;
  bool        finite = true;
  for (const double force : forces)
    finite = finite && std::isfinite(force);
  for (const double energy : energies)
    finite = finite && std::isfinite(energy);
  if (!finite || again != forces || forces[3] != 1.)
    differences.force = std::numeric_limits<double>::infinity();
  for (unsigned int e = 0; e < n_elements; ++e)
    {
      const HexahedronNodes expected = compute_internal_forces(K[e], X[e], x[e], frame);
      const double          scale    = K[e].cwiseAbs().maxCoeff() * largest_coordinate;
      for (unsigned int a = 0; a < 8; ++a)
        raise_to(differences.force,
                 (SamplePacks::at(forces, 8 * e + a) - Vector3::Ones() - expected.col(a))
                     .cwiseAbs()
                     .maxCoeff() /
                   scale);
      double least = std::numeric_limits<double>::infinity();
      for (unsigned int a = 0; a < 8; ++a)
        least = std::min(least, compute_jacobian(x[e], reference_corner(a)).determinant());
      raise_to(differences.jacobian, std::abs(jacobians[e] / least - 1.));
      raise_to(differences.energy,
               std::abs(energies[e] - compute_strain_energy(K[e], X[e], x[e], frame)) /
                 (scale * strain));
    }
  return differences;
}

/** Two lanes of a pack that are the same element on the same nodes: forces must add up. */
double shared_nodes(const InstructionSet set)
{
  Samples               samples;
  const Material        material;
  const HexahedronNodes X = samples.hexahedron({1., 2., 3.}, 0.15);
  const HexahedronNodes x = X + samples.displacement(1e-3);
  SamplePacks           packs;
  packs.resize(1, 8);
  for (unsigned int lane = 0; lane < n_lanes; ++lane)
    {
      packs.set_constants(0,
                          lane,
                          compute_reduced_stiffness(X, material, StiffnessKind::full),
                          material);
      for (unsigned int a = 0; a < 8; ++a)
        packs.set_node(0, lane, a, a);
    }
  for (unsigned int a = 0; a < 8; ++a)
    packs.set_position(a, x.col(a));
  std::vector<double> forces(32, 0.);
  select_kernels(FrameKind::polar, set)
    .add_internal_forces(packs.view(), 0, 1, packs.positions.data(), forces.data());
  const Matrix24        K          = compute_stiffness(X, material, StiffnessKind::full);
  const HexahedronNodes f          = compute_internal_forces(K, X, x, FrameKind::polar);
  double                difference = 0.;
  for (unsigned int a = 0; a < 8; ++a)
    raise_to(difference, (SamplePacks::at(forces, a) - 8. * f.col(a)).cwiseAbs().maxCoeff());
  return difference / f.cwiseAbs().maxCoeff();
}

bool choice_refused(const char *word)
{
  setenv("VFIFE_INSTRUCTION_SET", word, 1);
  const bool refused = refuses([] { best_instruction_set(); });
  unsetenv("VFIFE_INSTRUCTION_SET");
  return refused;
}

/** With @p verbose the numbers themselves. */
void compare_all(const InstructionSet set, const bool verbose)
{
  for (const auto &choice : frame_choices())
    {
      const FrameKind frame = choice.second;
      Differences     worst;
      double          large_strain = 0.;
      for (const bool shared : {false, true})
        {
          const Differences d = compare(set, frame, shared, 1e-3);
          raise_to(worst.force, d.force);
          raise_to(worst.energy, d.energy);
          raise_to(worst.jacobian, d.jacobian);
          raise_to(large_strain, compare(set, frame, shared, 2e-2).force);
        }
      const double      repeated = shared_nodes(set);
      const std::string name = std::string(name_of(set)) + ", " + word_of(frame, frame_choices());
      if (verbose)
        std::cout << name << ' ' << worst.force << ' ' << worst.energy << ' ' << worst.jacobian
                  << ' ' << large_strain << ' ' << repeated << std::endl;
      // Round-off: coordinates carry 1e-16 of their size, and some ten of them meet in a force.
      check_below("forces of " + name, worst.force, 1e-15);
      check_below("energies of " + name, worst.energy, 1e-15);
      // Edges of 1 mm between coordinates of 100 mm, three of them in a product.
      check_below("least Jacobians of the corners of " + name, worst.jacobian, 1e-13);
      check_below("forces at strains of a few percent of " + name, large_strain, 2e-15);
      check_below("lanes that share nodes of " + name, repeated, 1e-10);
    }
}

int main(int argc, char **argv)
{
  if (argc > 1)
    return run_instruction_set(argv[1],
                               [argc](const InstructionSet set) { compare_all(set, argc > 2); });
  compare_all(InstructionSet::generic, false);
  check("a nonsense instruction set is refused", choice_refused("mmx"));
  check("generic can be asked for", !choice_refused("generic"));
  return 0;
}
