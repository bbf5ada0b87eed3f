// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// Two ranks find the loaded pair in bearings where one rank finds it.
#include "../ranks.h"
#include "pair_in_bearings.h"

using namespace vfife;

int main(int argc, char **argv)
{
  const TestRanks     ranks(argc, argv);
  const Communicator &world = ranks.world, &alone = ranks.alone;

  Matrix5 unlike   = bearing_stiffness(2e5, 3e5, 1e8);
  unlike(1, 1)     = 6e5;
  const auto law   = linear_bearing(unlike, 500. * Vector5::Unit(2));
  Model      model = make_held_pair(world);
  hang_in_bearings(model, {law, law, law, law}, 5e8);
  const auto find = [&model](const Communicator &communicator) {
    Compliance      compliance(model, lumped_masses(), true, communicator);
    PairEquilibrium equilibrium(model, compliance, {.1});
    return equilibrium.solve(.1, 1.);
  };
  const PairEquilibriumResult together = find(world), single = find(alone);
  check_ratio("turn at the first touch", together.touch_turn / single.touch_turn, 1e-7);
  check_ratio("turn", together.turn / single.turn, 1e-7);
  check("four bearings", together.bearings.size() == 4);
  double load = 0, displacement = 0;
  for (std::size_t b = 0; b < 4; ++b)
    {
      const SeatState &here = together.bearings[b], &there = single.bearings[b];
      raise_to(load, (here.load - there.load).norm() / there.load.norm());
      raise_to(displacement,
               (here.displacement - there.displacement).norm() / there.displacement.norm());
    }
  check_below("loads of bearings", load, 1e-7);
  check_below("their displacements", displacement, 1e-7);
  return 0;
}
