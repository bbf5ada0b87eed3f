// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// Stress in the fillets of a stepped bar against Peterson's factors, over a family of meshes,
// beside mean values of the elements' stresses at the nodes.
#include "shoulder_bar.h"
#include "../parts.h"
#include "../tests.h"

#include <vfife/base/process/communicator.h>
#include <vfife/stress/surface_stress.h>

#include <iomanip>

using namespace vfife;

struct Factors
{
  double surface = 0; ///< of the facets
  double nodes   = 0; ///< of stresses averaged at the nodes
};

Factors find_factors(const unsigned int n,
                     const bool         bending,
                     const FemElement   element,
                     Communicator      &world)
{
  ShoulderBar  bar(n);
  StaticLoads  loads;
  const Model &model = bar.load(bending, loads.nodal_forces);
  FemOptions   options;
  options.element       = element;
  options.linear_solver = LinearSolverKind::direct;
  const StaticSolver        solver(model, {0}, options, world);
  const StaticResult        result = solver.solve(loads);
  const std::vector<Stress> nodal  = compute_node_stresses(solver.space(), result.displacements);
  Factors                   factors;
  for (const auto &facet : bar.fillet_facets())
    {
      FacetCorners X, u;
      for (unsigned int k = 0; k < 4; ++k)
        {
          X.col(k)        = model.bodies[0].node_positions()[facet[k]];
          u.col(k)        = Eigen::Map<const Vector3>(result.displacements.data() + 3 * facet[k]);
          const Stress &s = nodal[facet[k]];
          raise_to(factors.nodes,
                   compute_principal_stresses(SurfaceTensor(s[0], s[1], s[3])).first);
        }
      const SurfaceTensor stress = compute_surface_stress(FacetStrain(X).of_displacements(u),
                                                          model.bodies[0].materials().front());
      raise_to(factors.surface, compute_principal_stresses(stress).first);
    }
  return factors;
}

/** Of flat bars with shoulder fillets, step h over radius r between 0.1 and 2 (Pilkey & Pilkey,
 * Peterson's Stress Concentration Factors, charts 3.1 and 3.8). */
double peterson(const bool bending)
{
  const double h = .5 * (ShoulderBar::wide - ShoulderBar::narrow), ratio = h / ShoulderBar::radius,
               root = std::sqrt(ratio), d = 2. * h / ShoulderBar::wide;
  if (bending)
    return 1.006 + .967 * root + .013 * ratio + d * (-.270 - 2.372 * root + .708 * ratio) +
           d * d * (.662 + 1.157 * root - .908 * ratio) +
           d * d * d * (-.405 + .249 * root - .200 * ratio);
  return 1.006 + 1.008 * root - .044 * ratio + d * (-.115 - .584 * root + .315 * ratio) +
         d * d * (.245 - 1.006 * root - .257 * ratio) +
         d * d * d * (-.135 + .582 * root - .017 * ratio);
}

void family(Communicator &world)
{
  for (const bool bending : {false, true})
    {
      std::cout << (bending ? "bending" : "tension") << ": Peterson " << std::fixed
                << std::setprecision(3) << peterson(bending) << std::endl;
      std::vector<double> surface;
      for (const unsigned int n : {2u, 4u, 8u, 16u, 32u})
        {
          const Factors f = find_factors(n, bending, FemElement::incompatible_modes, world);
          std::cout << "  " << n << " facets: surface " << f.surface << ", nodes " << f.nodes;
          if (n <= 8)
            std::cout << "; quadratic elements: surface "
                      << find_factors(n, bending, FemElement::quadratic, world).surface;
          std::cout << std::endl;
          surface.push_back(f.surface);
        }
      // The charts are of photoelastic tests: a few parts in a hundred.
      check_ratio("  finest mesh over Peterson", surface.back() / peterson(bending), .05);
      // The meshes' own limit by Richardson's extrapolation of second order of the last two.
      const double limit = surface[4] + (surface[4] - surface[3]) / 3.;
      check("  half the size, less than half the error",
            std::abs(surface[3] - limit) < .5 * std::abs(surface[2] - limit) &&
              std::abs(surface[2] - limit) < .5 * std::abs(surface[1] - limit));
      std::cout << "  limit " << limit << ", 8 facets " << std::setprecision(1)
                << 100. * (surface[2] / limit - 1.) << " %" << std::endl;
    }
}

int main(int argc, char **argv)
{
  run_parts<Communicator>(argc, argv, {family});
  return 0;
}
