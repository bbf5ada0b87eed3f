// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// Bodies of two materials and with initial strains, by VFIFE: classes of congruent elements, a
// heated bar, a bimetal strip and a shrink fit that come to rest, a bar that is heated at once, a
// wave across the joint of a layered bar.
#include "../composite.h"
#include "../parts.h"
#include "../tests.h"
#include "relaxed.h"

#include <vfife/dynamics/operator/congruence.h>
#include <vfife/dynamics/watch/measurement.h>

using namespace vfife;

std::size_t n_classes(const Body &body)
{
  std::vector<std::uint32_t> all(body.n_elements());
  std::iota(all.begin(), all.end(), 0);
  return find_congruence_classes(body, all).size.size();
}

void classes()
{
  const auto material = [](const Vector3 &x) { return x[0] > 2.; };
  Body       body =
    make_composite(make_block(Vector3(4, 2, 2), {{4, 2, 2}}), {Material(), Material()}, material);
  check("congruent elements of two materials are two classes", n_classes(body) == 2);
  set_strains(body, [](const Vector3 &x) { return x[1] > 1. ? 1e-6 : 0.; });
  check("with two initial strains four", n_classes(body) == 4);
}

DynamicsOptions options_of_rest()
{
  DynamicsOptions options      = undamped();
  options.relaxation.tolerance = 1e-8;
  return options;
}

Vector3 displacement(const OneSolver &run, const Model &model, const unsigned int node)
{
  return run.state.node_position(run.state.partition->local_node[node]) -
         model.bodies[0].node_positions()[node];
}

void heated_bar()
{
  const double    strain  = 1.5e-3;
  const Model     model   = make_heated_bar(strain);
  DynamicsOptions options = options_of_rest();
  OneSolver       run(model, options);
  relax(model, run);
  // Lengths are compared with those without stress: -strain/(1 + strain).
  const double stress =
    -model.bodies[0].materials().front().youngs_modulus * strain / (1. + strain);
  Probe probe;
  probe.name = "middle";
  probe.node = model.bodies[0].node_set("y+").front();
  const auto values =
    measure_probes(model, {probe}, run.state, run.solver.vfife_operator(), run.communicator);
  check_ratio("heated bar: stress over -E strain/(1 + strain)",
              values.front().von_mises / -stress,
              1e-6);
}

void bimetal_strip()
{
  const BimetalStrip strip(12., 4);
  OneSolver          run(strip.model, options_of_rest());
  relax(strip.model, run);
  const double x = strip.model.bodies[0].node_positions()[strip.middle()][0];
  // An arc: its height, by large rotations, is less than that of the parabola by (kappa x)^2/12.
  const double angle = strip.curvature() * x;
  check_ratio("bimetal strip: deflection over that of Timoshenko's arc",
              displacement(run, strip.model, strip.middle())[2] /
                (-(1. - std::cos(angle)) / strip.curvature()),
              3e-3);
}

void shrink_fit()
{
  const ShrinkFit fit(6);
  OneSolver       run(fit.model, options_of_rest());
  relax(fit.model, run);
  const Vector3 X = fit.model.bodies[0].node_positions()[fit.bore_node()];
  check_ratio("shrink fit: way of the bore over Lame's",
              displacement(run, fit.model, fit.bore_node()).dot(X.normalized()) / fit.bore(),
              5e-3);
}

/** A free bar that is hot from the start swings about its new length with the frequency of a free
 * bar, and the energy of the strain is kept. */
void bar_heated_at_once()
{
  const double strain = 1e-3, length = 40.;
  Material     material;
  material.poissons_ratio = 0.;
  Model model = model_of(Body("bar", make_block(Vector3(length, 1, 1), {{80, 1, 1}}), material));
  Body &bar   = model.bodies[0];
  set_strains(bar, [strain](const Vector3 &) { return strain; });
  model.constraints.push_back(hold(all_nodes(bar), {{false, true, true}}));
  model.constraints.push_back(hold(bar.node_set("x-"), {{true, false, false}}));
  OneSolver          run(model, undamped());
  const unsigned int tip     = bar.node_set("x+").front();
  double             longest = 0, shortest = length;
  const double       period    = 4. * length / bar.sound_speed();
  auto               observers = watch(1, [&](const State &state) {
    const double u = state.node_position(state.partition->local_node[tip])[0] - length;
    raise_to(longest, u);
    shortest = std::min(shortest, u);
  });
  run.solver.run(run.state, .52 * period, observers);
  // A wave of relief runs in from the tip and back: the tip moves by twice the expansion.
  check_close("bar heated at once: largest way of its tip over the expansion",
              longest / (strain * length),
              2.,
              .06);
  check_below("it does not shrink", -shortest / (strain * length), 1e-9);
}

/** A pulse of velocities in the middle of the first half: half of it goes to the joint. */
void wave_across_joint()
{
  const double length = 240., width = 6., speed_of_pulse = 1000.;
  Model        model = make_layered_bar(480, length);
  Body        &bar   = model.bodies[0];
  for (const Vector3 &X : bar.node_positions())
    bar.initial_velocity.push_back(
      Vector3(speed_of_pulse * std::exp(-.5 * std::pow((X[0] - .25 * length) / width, 2)), 0, 0));
  OneSolver run(model, undamped());
  run.solver.set_initial_velocities(run.state);
  // From a quarter of the length past the joint: both pulses are then in the middle of a half.
  const double time = .5 * length / bar.sound_speed();
  Observers    none;
  run.solver.run(run.state, time, none);
  double reflected = 0, transmitted = 0, at = 0;
  for (unsigned int i = 0; i < bar.n_nodes(); ++i)
    {
      const double x = bar.node_positions()[i][0];
      const double v = run.state.node_velocity(run.state.partition->local_node[i])[0];
      if (x > .5 * length && v > transmitted)
        {
          transmitted = v;
          at          = x;
        }
      // The other half of the pulse comes back from the free end to its start.
      if (x > .45 * length && x < .5 * length)
        raise_to(reflected, std::abs(v));
    }
  // Velocities: 2 Z1/(Z1 + Z2) of the impedances 3 and 1.
  check_close("wave into the softer half over the incoming one",
              transmitted / (.5 * speed_of_pulse),
              1.5,
              .015);
  check_ratio("place of its peak over the closed form's", at / (.75 * length), 5e-3);
  check_below("nothing stays at the joint", reflected / speed_of_pulse, 1e-2);
}

int main(int argc, char **argv)
{
  return run_parts(
    argc,
    argv,
    {&classes, &heated_bar, &bimetal_strip, &shrink_fit, &bar_heated_at_once, &wave_across_joint});
}
