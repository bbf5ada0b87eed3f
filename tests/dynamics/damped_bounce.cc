// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// A block of one cell bounces off a held plate on a soft, damped penalty: the closed form of a mass
// on a spring and a damper that cannot pull; and the penalty of bodies of unequal density.
#include "../parts.h"
#include "../tests.h"
#include "one_solver.h"

#include <vfife/mesh/body_mesh.h>

using namespace vfife;

constexpr double side = 2, gap = 1e-3, speed = 500; // [mm], [mm], [mm/s]

Material material_of(const double density)
{
  Material material;
  material.density = density;
  return material;
}

/** A block over the middle of a plate that is held and three times as wide. */
Model make_model(const double block_density, const double plate_density, const ContactPair &pair)
{
  Model model;
  Body  block("block", make_block({side, side, side}, {{1, 1, 1}}), material_of(block_density));
  block.placement.translation = Vector3(side, side, gap);
  block.axis.point            = block.placement.translation;
  block.velocity[2]           = -speed;
  model.add_body(std::move(block));
  Body plate("plate",
             make_block({3 * side, 3 * side, side}, {{3, 3, 1}}, Vector3(0, 0, -side)),
             material_of(plate_density));
  model.add_body(std::move(plate));
  model.constraints.push_back({"plate", ConstraintKind::held, 1, all_nodes(model.bodies[1])});
  model.contacts.push_back(pair);
  return model;
}

/** By the closed form with omega^2 = omega0^2 - beta^2 while beta < omega0/sqrt(2): contact ends
 * when the force is zero, before the spring has opened (Schwager and Poeschel 2007). */
void bounce(const double ratio, const double plate_density)
{
  const double density = 7.85e-9, penalty = 2;
  ContactPair  pair          = contact_of("landing", "z-", "z+", ContactSurfaceKind::flat_facets);
  pair.options.penalty.value = penalty;
  pair.options.damping_ratio = ratio;
  const Model model          = make_model(density, plate_density, pair);
  OneSolver   run(model, undamped());

  // c = 2 ratio sqrt(eps m/A), m/A the lesser of both surfaces' nodes; the whole block's is twice
  // that of its lower nodes.
  const double mass = model.bodies[0].mass(), area = side * side;
  const double node_mass = std::min(density, plate_density) * side / 2;
  const double damping   = 2 * ratio * std::sqrt(penalty * node_mass);
  const double omega0 = std::sqrt(penalty * area / mass), beta = 0.5 * damping * area / mass,
               omega = std::sqrt(omega0 * omega0 - beta * beta);
  const double duration =
    (pi - std::atan(2 * beta * omega / (omega * omega - beta * beta))) / omega;
  const double restitution = std::exp(-beta * duration), energy = 0.5 * mass * speed * speed;

  double      velocity = 0, first = -1, last = -1, jump = 0, loss = 0, residual = 0;
  const auto &masses    = run.solver.vfife_operator().masses();
  auto        observers = watch(1, [&](const State &state) {
    if (state.measured.contact_force > 0)
      {
        if (first < 0)
          jump = state.measured.contact_force;
        first = first < 0 ? state.time : first;
        last  = state.time;
      }
    velocity = 0;
    for (std::uint32_t i = 0; i < state.partition->first_local_node[1]; ++i)
      velocity += masses[i] * state.node_velocity(i)[2] / mass;
    loss = state.measured.energy.contact_loss;
    raise_to(residual, std::abs(state.measured.energy.residual()) / energy);
  });
  // Until the spring, which the block leaves pressed, has opened.
  run.solver.run(run.state, 3 * duration + gap / speed, observers);

  std::ostringstream name;
  name << "ratio " << ratio << ", " << (plate_density < density ? "light" : "heavy") << " plate: ";
  // Velocities of the damper are those half a step before: some beta dt = 2e-3 of it; and one
  // step of the touch.
  check_ratio(name.str() + "velocity afterwards over that before",
              velocity / speed / restitution,
              5e-3);
  check_ratio(name.str() + "duration over the closed form", (last - first) / duration, 5e-3);
  if (ratio > 0)
    {
      check_ratio(name.str() + "force at the first touch over c v A",
                  jump / (damping * speed * area),
                  0.02);
      check_ratio(name.str() + "lost energy over that of the closed form",
                  loss / (energy * (1 - restitution * restitution)),
                  5e-3);
    }
  else
    check_close(name.str() + "no loss", loss, 0., 0.);
  check_below(name.str() + "energy residual over that of flight", residual, 5e-3);
}

void all()
{
  bounce(0., 15e-9);
  bounce(0.4, 15e-9);
  bounce(0.8, 15e-9);
  bounce(0.8, 2.7e-9);
}

int main(int argc, char **argv)
{
  return run_parts(argc, argv, {all});
}
