// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// Modes on distributed meshes: equal to those of the direct solver on the same mesh; a free body
// has six rigid motions.
#include "../composite.h"
#include "../ranks.h"
#include "../tests.h"

#include <vfife/fem/distributed/distributed_modes.h>

using namespace vfife;

Model make_plate(const bool is_held)
{
  Model model = model_of(Body("plate", make_block(Vector3(40., 25., 6.), {{4, 3, 1}}), {}));
  if (is_held)
    model.constraints.push_back({"clamp", ConstraintKind::held, 0, model.bodies[0].node_set("x-")});
  return model;
}

void compare(const std::string &name,
             const Model       &model,
             const FemElement   element,
             const MassKind     mass,
             const TestRanks   &ranks)
{
  FemOptions options;
  options.distributed       = true;
  options.element           = element;
  options.mass              = mass;
  options.local_refinement  = {"x- 1"};
  options.eigen_tolerance   = 1e-8;
  options.n_modes           = model.constraints.empty() ? 9 : 4;
  const ModesAtSpeed found  = DistributedModes(model, 0, options, ranks.world).find_modes();
  options.eigen_tolerance   = 1e-10;
  const ModesAtSpeed direct = RotatingBody(model, 0, options, ranks.alone).find_modes(0.);
  check(name + ": rigid motions", found.n_rigid == direct.n_rigid);
  check(name + ": not counted", !found.counted && direct.counted);
  double frequency = 0, effective = 0, axial = 0, whole = 0;
  for (unsigned int k = 0; k < options.n_modes; ++k)
    {
      const RotatingMode &one = found.modes[k], &two = direct.modes[k];
      if (two.frequency == 0)
        {
          check(name + ": a rigid motion", one.frequency == 0);
          continue;
        }
      raise_to(frequency, std::abs(one.frequency / two.frequency - 1.));
      raise_to(axial, std::abs(one.description.axial - two.description.axial));
      for (unsigned int r = 0; r < 3; ++r)
        {
          raise_to(effective, std::abs(one.effective_mass[r] - two.effective_mass[r]));
          whole = std::max(whole, two.effective_mass[r]);
        }
    }
  check_below(name + ": frequencies", frequency, 1e-8);
  check_below(name + ": axial share", axial, 1e-4);
  if (!model.constraints.empty())
    check_below(name + ": effective masses", effective / whole, 1e-5);
}

int main(int argc, char **argv)
{
  const TestRanks ranks(argc, argv);
  for (const FemElement element : {FemElement::full, FemElement::quadratic, FemElement::cubic})
    for (const MassKind mass : {MassKind::consistent, MassKind::lumped})
      compare(word_of(element, fem_element_choices()) + ", " + word_of(mass, mass_choices()),
              make_plate(true),
              element,
              mass,
              ranks);
  compare("free", make_plate(false), FemElement::quadratic, MassKind::consistent, ranks);
  return 0;
}
