// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// Bodies of two materials and with initial strains, conventional: a heated bar between walls, its
// frequencies, a bimetal strip, a shrink fit, modes of a layered bar, one sector of it.
#include "../composite.h"
#include "../parts.h"
#include "../refusal.h"
#include "../tests.h"

#include <vfife/base/process/communicator.h>
#include <vfife/fem/modes/modal_solver.h>
#include <vfife/fem/modes/rotating_body.h>
#include <vfife/fem/statics/static_solver.h>

using namespace vfife;

FemOptions options_of(const FemElement element)
{
  FemOptions options;
  options.element       = element;
  options.linear_solver = LinearSolverKind::direct;
  return options;
}

void heated_bar(const Communicator &communicator)
{
  const double strain = 1.5e-3;
  const Model  model  = make_heated_bar(strain);
  const double stress = -model.bodies[0].materials().front().youngs_modulus * strain;
  for (const auto &choice : fem_element_choices())
    {
      const StaticSolver solver(model, {0}, options_of(choice.second), communicator);
      const StaticResult result = solver.solve({});
      double             wrong  = 0;
      for (const Stress &s : compute_node_stresses(solver.space(), result.displacements))
        {
          Stress expected = Stress::Zero();
          expected[0]     = stress;
          raise_to(wrong, (s - expected).norm() / -stress);
        }
      check_below("heated bar, " + choice.first + ": stress less -E strain, over it", wrong, 1e-10);
      // What expands freely across stores nothing: E strain^2/2 of the volume.
      check_ratio("heated bar, " + choice.first + ": energy over E strain^2 V/2",
                  result.strain_energy / (.5 * -stress * strain * 120.),
                  1e-10);
    }
}

/** A slender bar between walls: f = f_0 sqrt(1 - P/P_cr) with the force P = E A strain. */
void frequencies_of_heated_bar(const Communicator &communicator)
{
  const double length = 40., height = 1.;
  Material     material;
  material.poissons_ratio = 0.;
  const auto lowest       = [&](const double strain) {
    Model model =
      model_of(Body("bar", make_block(Vector3(length, .7, height), {{40, 1, 2}}), material));
    Body &bar = model.bodies[0];
    if (strain != 0.)
      set_strains(bar, [strain](const Vector3 &) { return strain; });
    for (const char *end : {"x-", "x+"})
      model.constraints.push_back({end, ConstraintKind::held, 0, bar.node_set(end)});
    model.constraints.push_back(hold(all_nodes(bar), {{false, true, false}}));
    FemOptions options = options_of(FemElement::incompatible_modes);
    options.n_modes    = 1;
    return RotatingBody(model, 0, options, communicator).find_modes(0.).modes.front().frequency;
  };
  // Clamped at both ends: P_cr = 4 pi^2 E I/L^2, and f^2 falls by 0.97 P/P_cr.
  const double critical = 4. * pi * pi * height * height / 12. / (length * length);
  const double cold = lowest(0.), ratio = lowest(.3 * critical) / cold;
  check_close("clamped bar under 0.3 of its critical force: 1 - (f/f_0)^2",
              1. - ratio * ratio,
              .3 * .97,
              6e-3);
  check("as much tension stiffens it", lowest(-.3 * critical) > 1.1 * cold);
}

void bimetal_strip(const Communicator &communicator)
{
  const BimetalStrip strip(40., 8);
  const StaticSolver solver(strip.model,
                            {0},
                            options_of(FemElement::incompatible_modes),
                            communicator);
  const StaticResult result = solver.solve({});
  const double       x      = strip.model.bodies[0].node_positions()[strip.middle()][0];
  check_ratio("bimetal strip: deflection over Timoshenko's",
              result.displacements[3 * strip.middle() + 2] / (-.5 * strip.curvature() * x * x),
              1e-4);
}

void shrink_fit(const Communicator &communicator)
{
  std::array<double, 2> errors;
  for (unsigned int i = 0; i < 2; ++i)
    {
      const ShrinkFit                 fit(6 << i);
      const StaticSolver              solver(fit.model,
                                {0},
                                options_of(FemElement::incompatible_modes),
                                communicator);
      const std::vector<double>       u = solver.solve({}).displacements;
      const Vector3                   X = fit.model.bodies[0].node_positions()[fit.bore_node()];
      const Eigen::Map<const Vector3> moved(u.data() + 3 * fit.bore_node());
      errors[i] = moved.dot(X.normalized()) / fit.bore() - 1.;
    }
  check_below("shrink fit: way of the bore less Lame's, over it", errors[1], 2e-4);
  check_close("shrink fit: order", std::log2(errors[0] / errors[1]), 2., .25);
}

/** Frequencies of the bar, free at one end: cos k1 l cos k2 l = Z2/Z1 sin k1 l sin k2 l; both
 * halves have the same speed of sound here, tan^2(k l) = Z1/Z2. */
void layered_bar(const Communicator &communicator)
{
  const double length = 60.;
  for (const auto &[element, n, tolerance] :
       {std::make_tuple(FemElement::incompatible_modes, 60u, 2e-3),
        std::make_tuple(FemElement::quadratic, 20u, 3e-5)})
    {
      Model model = make_layered_bar(n, length);
      model.constraints.push_back(hold(model.bodies[0].node_set("x-"), {{true, false, false}}));
      FemOptions options = options_of(element);
      options.n_modes    = 3;
      const auto   modes = RotatingBody(model, 0, options, communicator).find_modes(0.).modes;
      const double speed = model.bodies[0].sound_speed(), first = std::atan(std::sqrt(3.));
      const double angles[3] = {first, pi - first, pi + first};
      for (unsigned int k = 0; k < 3; ++k)
        check_ratio("layered bar, frequency " + std::to_string(k + 1),
                    modes[k].frequency / (angles[k] * speed / (.5 * length) / (2. * pi)),
                    tolerance);
    }
}

void one_sector(const Communicator &communicator)
{
  Material steel, light;
  light.name = "light";
  light.youngs_modulus /= 3.;
  const auto modes_of = [&](const bool cyclic, const std::function<bool(const Vector3 &)> &where) {
    Model model =
      model_of(make_composite(make_ring(20, 30, 4, {{6, 18, 3}}), {steel, light}, where));
    set_strains(model.bodies[0],
                [](const Vector3 &x) { return x.head<2>().norm() > 25. ? -1e-3 : 0.; });
    model.constraints.push_back(
      {"bore", ConstraintKind::held, 0, model.bodies[0].node_set("inner")});
    FemOptions options      = options_of(FemElement::incompatible_modes);
    options.n_modes         = cyclic ? 2 : 6;
    options.cyclic_symmetry = cyclic;
    return RotatingBody(model, 0, options, communicator).find_modes(0.).modes;
  };
  const auto inside = [](const Vector3 &x) { return x.head<2>().norm() < 25.; };
  const auto whole = modes_of(false, inside), sector = modes_of(true, inside);
  check_ratio("two materials and strains: the lowest mode by one sector over the whole ring",
              sector.front().frequency / whole.front().frequency,
              1e-9);
  print_refusal([&] { modes_of(true, [](const Vector3 &x) { return x[0] > 0.; }); });
}

int main(int argc, char **argv)
{
  run_parts<const Communicator>(argc,
                                argv,
                                {&heated_bar,
                                 &frequencies_of_heated_bar,
                                 &bimetal_strip,
                                 &shrink_fit,
                                 &layered_bar,
                                 &one_sector});
  return 0;
}
