// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// A body reduced on two ranks is that of one.
#include "../parts.h"
#include "../refusal.h"
#include "whole_body.h"

#include <vfife/reduced/body_reduction.h>

using namespace vfife;

void share(const Communicator &world)
{
  const Model        model = make_wheel(ConstraintKind::rigid_hub, 3000.);
  const auto         nodes = first_sector(model.bodies[0]);
  const Communicator alone(MPI_COMM_SELF);
  const ReducedBody  one = reduce_body(model, 0, {nodes, {}, {}, 3000., 4e5, 3}, alone),
                    two  = reduce_body(model, 0, {nodes, {}, {}, 3000., 4e5, 3}, world);
  bool same = one.harmonics.size() == two.harmonics.size() && one.n_unknowns == two.n_unknowns &&
              one.memory == two.memory && one.torque_residual == two.torque_residual &&
              one.turn_coriolis == two.turn_coriolis && one.spin == two.spin;
  for (std::size_t i = 0; same && i < one.harmonics.size(); ++i)
    same = one.harmonics[i].number == two.harmonics[i].number &&
           one.harmonics[i].eigenvalues == two.harmonics[i].eigenvalues &&
           one.harmonics[i].coriolis == two.harmonics[i].coriolis &&
           one.harmonics[i].spin_stiffness == two.harmonics[i].spin_stiffness &&
           one.harmonics[i].shapes == two.harmonics[i].shapes &&
           one.harmonics[i].torque == two.harmonics[i].torque;
  same         = world.all(same);
  double worst = 0;
  bool   equal = true;
  for (std::size_t d = 0; d < one.residual.size(); ++d)
    {
      raise_to(worst, (one.residual[d] - two.residual[d]).norm() / one.residual[3].norm());
      // All ranks have the same bytes.
      double sum = two.residual[d].sum();
      equal      = equal && world.max(sum) == sum;
    }
  worst = world.max(worst);
  equal = world.all(equal && world.max(two.residual_left) == two.residual_left);
  // Harmonics of one of the ranks have too many modes.
  const std::string message = message_of([&] {
    reduce_body(model, 0, {nodes, {}, {}, 3000., 4.7e6, 3}, world);
  });
  const bool        refused = world.all(!message.empty());
  if (world.is_root())
    {
      check("modes of two ranks", same);
      // Sums over the harmonics have another order.
      check_below("residuals of two ranks", worst, 1e-13);
      check("all ranks have the same", equal);
      check("all ranks refuse", refused);
    }
}

int main(int argc, char **argv)
{
  return run_parts(argc, argv, {share});
}
