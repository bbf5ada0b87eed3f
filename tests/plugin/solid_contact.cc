// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// A bar hits an equal one that is refined in the middle. Their sides slide, so that waves are plane
// and the impact is that of the theory.
#include "../parts.h"
#include "../tests.h"
#include "solid_mesh.h"

#include <vfife/plugin/solid_contact.h>

using namespace vfife;

constexpr double       length = 50, gap = .01, speed = 2000;
constexpr unsigned int cells = 100;

void make_bar(const bool refined, SolidMesh &mesh)
{
  mesh.make_block(Vector3(length, 1, 1), {cells, 2, 2});
  if (refined)
    mesh.refine_where([](const auto &x) { return std::abs(x[0] - length / 2) < length / 10; });
  else
    dealii::GridTools::shift(dealii::Tensor<1, 3>({length + gap, 0, 0}), mesh.triangulation);
  mesh.setup({{2, 2}, {3, 2}, {4, 4}, {5, 4}});
}

double momentum_of(const ExplicitSolid &solid, const SolidMesh &mesh)
{
  double sum = 0;
  for (std::size_t i = 0; i < mesh.places.size(); ++i)
    if (mesh.component[i] == 0)
      sum += solid.lumped_masses()[i] * solid.velocity()[i];
  return sum;
}

void hit(const ContactTime time, const double energy_bound)
{
  SolidMesh meshes[2];
  make_bar(true, meshes[0]);
  make_bar(false, meshes[1]);
  ExplicitSolid flying(meshes[0].dofs, meshes[0].constraints, meshes[0].steel(), {}),
    resting(meshes[1].dofs, meshes[1].constraints, meshes[1].steel(), {});
  ContactOptions options;
  options.surface     = ContactSurfaceKind::flat_facets;
  options.edge_fading = 0; // the faces match
  options.time        = time;
  SolidContact contact(flying, 1, resting, 0, options);

  const Material material;
  const double   solids = std::min(flying.stable_step(), resting.stable_step()),
               dt       = contact.stable_step(solids);
  check("implicit contact allows the step of the solids, explicit contact does not",
        time == ContactTime::implicit ? dt == solids : dt < solids);
  flying.set_state(meshes[0].zero(),
                   meshes[0].interpolate([](const Vector3 &) { return Vector3(speed, 0, 0); }),
                   dt);
  resting.set_state(meshes[1].zero(), meshes[1].zero(), dt);

  const double c    = std::sqrt((material.lambda() + 2 * material.mu()) / material.density),
               mass = length * material.density, wave = 2 * length / c;
  double momentum = 0, balance = 0, energy = 0, impulse = 0, first_touch = -1, last_touch = 0;
  for (unsigned int n = 0; n * dt < gap / speed + 2 * wave; ++n)
    {
      const double          before = momentum_of(flying, meshes[0]);
      ExplicitSolid::Vector f = meshes[0].zero(), g = meshes[1].zero();
      contact.add_forces(f, g);
      const double force = contact.force()[0];
      flying.step(f);
      resting.step(g);
      const double first = momentum_of(flying, meshes[0]), second = momentum_of(resting, meshes[1]);
      raise_to(momentum, std::abs((first + second) / (mass * speed) - 1));
      raise_to(balance, std::abs(first - before - dt * force) / (mass * speed));
      raise_to(energy,
               std::abs((flying.kinetic_energy() + flying.strain_energy() +
                         resting.kinetic_energy() + resting.strain_energy() + contact.energy()) /
                          (.5 * mass * speed * speed) -
                        1));
      impulse -= dt * force;
      if (force < 0)
        {
          first_touch = first_touch < 0 ? n * dt : first_touch;
          last_touch  = n * dt;
        }
    }
  check_below("momentum of both bars over that at the start, less one", momentum, 1e-12);
  check_below("momentum of a bar less the impulse of contact", balance, 1e-12);
  check_below("energy over that at the start, less one", energy, energy_bound);
  // The wave runs forth and back; the mesh blurs its front.
  check_ratio("time of contact over 2 L/c", (last_touch - first_touch + dt) / wave, .02);
  check_ratio("impulse over the momentum at the start", impulse / (mass * speed), .01);
  check("contact has ended", contact.force().norm() == 0 && contact.energy() == 0);
}

/** At a face that does not move the bar turns back. */
void bounce()
{
  SolidMesh meshes[2];
  make_bar(true, meshes[0]);
  make_bar(false, meshes[1]);
  meshes[1].setup({{0, 1}, {2, 2}, {3, 2}, {4, 4}, {5, 4}});
  ExplicitSolid bar(meshes[0].dofs, meshes[0].constraints, meshes[0].steel(), {}),
    wall(meshes[1].dofs, meshes[1].constraints, meshes[1].steel(), {});
  SolidContact contact(bar, 1, wall, 0, ContactOptions());
  const double dt = contact.stable_step(bar.stable_step());
  bar.set_state(meshes[0].zero(),
                meshes[0].interpolate([](const Vector3 &) { return Vector3(speed, 0, 0); }),
                dt);
  wall.set_state(meshes[1].zero(), meshes[1].zero(), dt);
  const double at_start = momentum_of(bar, meshes[0]);
  double       energy   = 0;
  for (unsigned int n = 0; n * dt < 3e-5; ++n)
    {
      ExplicitSolid::Vector f = meshes[0].zero(), g = meshes[1].zero();
      contact.add_forces(f, g);
      bar.step(f);
      wall.step(g);
      const double sum = bar.kinetic_energy() + bar.strain_energy() + contact.energy();
      raise_to(energy, std::abs(sum / (.5 * at_start * speed) - 1));
    }
  check_below("energy of a bar at a wall over that at the start, less one", energy, 1e-9);
  check_close("momentum after the impact over that before",
              momentum_of(bar, meshes[0]) / at_start,
              -1.,
              .01);
  check_below("motion of the wall [mm]", wall.displacement().linfty_norm(), 1e-12);
}

void hit_implicitly()
{
  hit(ContactTime::implicit, 1e-9);
}

void hit_explicitly()
{
  hit(ContactTime::explicit_, .01);
}

int main(int argc, char **argv)
{
  return run_parts(argc, argv, {hit_implicitly, hit_explicitly, bounce});
}
