// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// A pair of reduced bodies on shafts in rolling bearings: at rest beside whole bodies, in motion
// its energy, the balance of its bearings and their order.
#include "../parts.h"
#include "../study/gear_model.h"
#include "../study/shaft_pair.h"
#include "pair_of_bodies.h"

#include <vfife/output/measures/pair_mounting.h>
#include <vfife/reduced/body_rings.h>

using namespace vfife;
using namespace pair_of_bodies;

Model make_model(const std::string      &name,
                 const std::string      &speed,
                 const shaft_pair::Laws &laws,
                 const Communicator     &world)
{
  return make_gear_model(name + ".prm",
                         shaft_pair::pair_on_shafts("", laws, shaft_pair::many_teeth(), "12") +
                           "subsection Operation\nset speed = " + speed +
                           "\nset torque = 800 N m\nset end time = 1 ms\nend\n" + given_penalty,
                         world);
}

/** Turns of some 1e-4 that are displacements of whole bodies and turns of reduced ones, or the
 * other way round. */
constexpr double straight = 1e-4;

/** So slow that the pair is at rest: rolling bearings with preloads, some half out of contact,
 * which linear laws are far from. */
void at_rest(Communicator &world)
{
  const Model model = make_model("shafts_at_rest", "6 rpm", {}, world);
  FemOptions  fem;
  fem.mass = MassKind::lumped;
  Compliance                  compliance(model, fem, false, world);
  PairEquilibrium             whole(model, compliance, {0.});
  const PairEquilibriumResult at = whole.solve(0., 1.);
  const double                te = error_of(model, compliance, at);
  for (const double cutoff : {15e3, 40e3})
    {
      ReducedPair pair = make_pair(model, reduce(model, cutoff, 39, world), {1e-6, 2000., 2000.});
      pair.start();
      const State state = measure(pair);
      check_ratio("transmission error over that of whole bodies",
                  state.measured.transmission_error / te,
                  straight);
      double forces = 0, ways = 0, force = 0, way = 0;
      for (std::size_t i = 0; i < at.bearings.size(); ++i)
        {
          const SeatState &a = state.measured.bearings[i], &b = at.bearings[i];
          raise_to(forces, (a.load - b.load).head<3>().norm());
          raise_to(ways, (a.displacement - b.displacement).head<3>().norm());
          force = std::max(force, b.load.head<3>().norm());
          way   = std::max(way, b.displacement.head<3>().norm());
        }
      check_below("forces of bearings, over the largest", forces / force, straight);
      check_below("displacements in bearings, over the largest", ways / way, straight);
      const Mounting mounting =
        PairMounting(model).measure([&](const unsigned int b, const BodyRing &) {
          return pair.reader().read_ring(b, ring::bore);
        });
      check("bores stand apart by more than bearings alone let them",
            std::abs(mounting.offset) > 2. * way);
    }
}

/** Means over mesh cycles after some for settling, and the energy error. */
struct Means
{
  std::vector<double> errors; ///< of transmission, in steps of a tenth of a mesh [arcsec]
  Vector3             sum     = Vector3::Zero(); ///< of all bearings' forces, fixed frame [N]
  double              largest = 0, energy_error = 0;
};

Means move(const Model                    &model,
           const std::vector<ReducedBody> &bodies,
           const unsigned int              steps,
           const unsigned int              n_meshes)
{
  const double mesh = 1. / model.only_transmission()->mesh_frequency();
  ReducedPair  pair = make_pair(model, bodies, {2. * mesh / steps, 2000., 2000.});
  // As sweeps do it.
  pair.set_speed(model.only_transmission()->driver_rate, mesh / steps);
  pair.start();
  Means means;
  for (unsigned int i = 1; i <= n_meshes * steps; ++i)
    {
      pair.step();
      if (i % (steps / 10) != 0)
        continue;
      const State state = measure(pair);
      means.errors.push_back(state.measured.transmission_error / arcsecond);
      raise_to(means.energy_error, std::abs(state.measured.energy.error()));
      Vector3 sum = Vector3::Zero();
      for (std::size_t b = 0; b < model.bearings.size(); ++b)
        {
          const Vector3 force = model.bearings[b].axes * state.measured.bearings[b].load.head<3>();
          sum += force;
          means.largest = std::max(means.largest, force.norm());
        }
      means.sum += sum / (10. * n_meshes);
    }
  return means;
}

/** Cages roll; dampers of this number [N s/mm]. */
shaft_pair::Laws damped_laws(const std::string &damping)
{
  shaft_pair::Laws laws;
  for (std::string *const law : {&laws.front, &laws.rear, &laws.straddle})
    *law += "set cage = rolling\nset radial damping = " + damping +
            " N s/mm\nset axial damping = " + damping + " N s/mm\n";
  return laws;
}

void in_motion(Communicator &world)
{
  // Dampers that take as much energy as is exchanged otherwise.
  const Model model = make_model("shafts_in_motion", "20000 rpm", damped_laws("500"), world);
  const std::vector<ReducedBody> bodies = reduce(model, 40e3, 4, world);
  const Means                    a = move(model, bodies, 50, 2), b = move(model, bodies, 100, 2),
              c = move(model, bodies, 200, 2), d = move(model, bodies, 400, 2);
  const double first = distance(a.errors, b.errors), second = distance(b.errors, c.errors),
               third = distance(c.errors, d.errors);
  check("steps of a half: a quarter of the error", first > 3 * second && second > 2.5 * third);
  check_below("energy", c.energy_error, 2e-3);
  check("energy: better with smaller steps", d.energy_error < .5 * b.energy_error);

  // Flanks push both members alike. Shafts stand displaced in space while they turn: damping
  // relative to the turning axes would drag them with 300 N.
  const Model light = make_model("shafts_lightly_damped", "20000 rpm", damped_laws("2"), world);
  const Means e     = move(light, bodies, 200, 8);
  check_below("mean of all bearings' forces over the largest", e.sum.norm() / e.largest, 3e-3);
}

int main(int argc, char **argv)
{
  return run_parts(argc, argv, {at_rest, in_motion});
}
