// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// Vibrations at speed: membrane limit of a disc, Coriolis splitting of a ring, sector against body.
#include "../model_parts.h"
#include "../parts.h"
#include "../refusal.h"
#include "../tests.h"

#include <vfife/base/process/communicator.h>
#include <vfife/fem/modes/campbell.h>
#include <vfife/fem/modes/rotating_body.h>
#include <vfife/mesh/primitives/primitives.h>

using namespace vfife;

/**
 * Lamb & Southwell 1921: omega^2 >= omega0^2 + lambda Omega^2, lambda of the membrane without
 * bending stiffness; without nodal circle 8 lambda = n (n + 2) (3 + nu) - n^2 (1 + 3 nu).
 */
void disc(const Communicator &communicator)
{
  Material steel;
  steel.poissons_ratio = .3;
  Model model          = model_of(Body("disc", make_cylinder(100., 1., {{8, 8, 1}}), steel));
  // The middle does not move in modes of two or more diameters.
  model.constraints.push_back({"axis", ConstraintKind::held, 0, model.bodies[0].node_set("axis")});
  FemOptions options;
  options.n_modes = 14;
  const RotatingBody rotating(model, 0, options, communicator);
  const ModesAtSpeed at_rest = rotating.find_modes(0.);
  // A mode is known by the sine and cosine of its angle along the border.
  const auto frequency = [&](const ModesAtSpeed &modes, const unsigned int n) {
    const Body &body = model.bodies[0];
    for (const RotatingMode &mode : modes.modes)
      {
        double wave = 0, all = 0;
        for (const unsigned int axis : {0, 1})
          {
            double sum = 0;
            for (const unsigned int i : body.node_set("outer"))
              {
                const double angle =
                  n * std::atan2(body.node_positions()[i][1], body.node_positions()[i][0]);
                sum += mode.shape[3 * i + 2] * (axis == 0 ? std::cos(angle) : std::sin(angle));
              }
            wave += sum * sum;
          }
        for (const unsigned int i : body.node_set("outer"))
          all += mode.shape[3 * i + 2] * mode.shape[3 * i + 2];
        if (2. * wave / (all * body.node_set("outer").size()) > .9)
          return mode.frequency * 2. * pi;
      }
    return 0.;
  };
  for (const double rate : {100., 2000.})
    {
      const ModesAtSpeed spun = rotating.find_modes(rate);
      for (const unsigned int n : {2u, 4u})
        {
          const double lambda = n * (n + 2) * 3.3 / 8. - n * n * 1.9 / 8.;
          const double slope =
            (std::pow(frequency(spun, n), 2) - std::pow(frequency(at_rest, n), 2)) / (rate * rate);
          // At low speed the mode is that of bending, whose quotient lies above the membrane's.
          check("disc: slope at least lambda", slope > .99 * lambda);
          check_ratio("disc: slope over lambda", slope / lambda, .1);
        }
    }
}

/**
 * Bryan 1890: waves of n diameters in a thin ring that turns differ by 4 n/(n^2 + 1) Omega, the
 * one against the spin being the faster.
 */
void ring(const Communicator &communicator)
{
  Model      model = model_of(Body("ring", make_ring(49.5, 50.5, 4., {{1, 72, 1}}), {}));
  FemOptions options;
  options.n_modes         = 14;
  options.coriolis        = true;
  const double       rate = -50.; // backward is against the spin, whatever its sense
  const RotatingBody rotating(model, 0, options, communicator);
  const ModesAtSpeed modes = rotating.find_modes(rate);
  for (const int n : {2, 3})
    {
      // Both waves of m w^2 + g w - k = 0 have w w' = k/m: T/(T + U) = w/(w + w'), and the
      // damping ratio zeta T/(T + U)/w is the same for both, zeta/(w + w').
      constexpr double zeta    = 30.;
      double           forward = 0, backward = 0, of_forward = 0, of_backward = 0;
      for (const RotatingMode &mode : modes.modes)
        if (mode.description.nodal_diameter == n && mode.description.axial < .1)
          {
            const bool with                   = mode.description.forward > .75;
            (with ? forward : backward)       = mode.frequency;
            (with ? of_forward : of_backward) = mode.damping_ratio(zeta);
          }
      const double split = (backward - forward) * 2. * pi / std::abs(rate);
      // A thin ring without stretching; 72 linear elements around and chords.
      check_close("ring: split of the waves", split, 4. * n / (n * n + 1.), 5e-3);
      const double ratio = zeta / (2. * pi * (forward + backward));
      check_ratio("ring: damping ratio, forward", of_forward / ratio, 1e-6);
      check_ratio("ring: damping ratio, backward", of_backward / ratio, 1e-6);
    }
}

/** A wheel on a hub that turns freely, placed with its mesh's z along that of @p rotation. */
Model make_wheel(const Matrix3                     &rotation,
                 const Vector3                     &axis,
                 const std::array<unsigned int, 3> &cells = {{4, 12, 3}})
{
  Model model;
  Body  wheel("wheel", make_ring(20., 40., 3., cells), {});
  wheel.placement.rotation    = rotation;
  wheel.placement.translation = Vector3(7., -5., 3.);
  // Any point of the axis will do.
  wheel.axis = {wheel.placement(Vector3(0., 0., 11.)), axis};
  model.add_body(std::move(wheel));
  model.constraints.push_back(
    {"hub", ConstraintKind::free_rotation, 0, model.bodies[0].node_set("inner")});
  return model;
}

/** As many modes, and the lowest of all diameters. */
void compare_lowest(const ModesAtSpeed &whole, const ModesAtSpeed &sector)
{
  double difference = 0;
  for (std::size_t k = 0; k < whole.modes.size(); ++k)
    raise_to(difference,
             std::abs(whole.modes[k].frequency - sector.modes.at(k).frequency) /
               whole.modes.back().frequency);
  check("lowest of the body: number, counted",
        whole.modes.size() == sector.modes.size() && sector.counted && whole.counted);
  check_below("lowest of the body: frequencies", difference, 1e-6);
}

/** Members of a pair may share theirs in any way: sums over all modes below a gap. */
void compare_effective_masses(const ModesAtSpeed &whole,
                              const ModesAtSpeed &sector,
                              const double        mass)
{
  std::size_t below = whole.modes.size() - 1;
  while (whole.modes[below - 1].frequency > (1 - 1e-4) * whole.modes[below].frequency)
    --below;
  for (unsigned int d = 0; d < 6; ++d)
    {
      double of_whole = 0, of_sector = 0;
      for (std::size_t k = 0; k < below; ++k)
        {
          of_whole += whole.modes[k].effective_mass[d];
          of_sector += sector.modes[k].effective_mass[d];
        }
      // Inertias: of a ring with radii of some 30 mm.
      const double scale = d < 3 ? mass : 900 * mass;
      check("effective mass: part of the whole", of_whole > 1e-3 * scale);
      check_below("effective mass of sectors", std::abs(of_sector - of_whole) / scale, 1e-6);
    }
}

/** One sector gives the modes of the whole body, at rest, at speed, and with Coriolis forces. */
void sector(const Model               &model,
            const std::vector<bool>   &with_coriolis,
            const std::vector<double> &rates,
            const Communicator        &communicator,
            const FemElement           element = FemElement::incompatible_modes)
{
  for (const bool coriolis : with_coriolis)
    for (const double rate : rates)
      {
        FemOptions options;
        options.element          = element;
        options.coriolis         = coriolis;
        options.n_modes          = 16;
        const ModesAtSpeed all   = RotatingBody(model, 0, options, communicator).find_modes(rate);
        options.cyclic_symmetry  = true;
        options.largest_diameter = 6;
        options.n_modes          = 4;
        const ModesAtSpeed parts = RotatingBody(model, 0, options, communicator).find_modes(rate);
        if (element == FemElement::incompatible_modes) // others have too few unknowns here
          {
            options.lowest_of_body = true;
            options.n_modes        = 16;
            const ModesAtSpeed lowest =
              RotatingBody(model, 0, options, communicator).find_modes(rate);
            compare_lowest(all, lowest);
            if (!(coriolis && rate != 0))
              compare_effective_masses(all, lowest, model.bodies[0].mass());
          }
        double             difference = 0, residual = 0;
        bool               same = true;
        const unsigned int n    = 10; // the lowest ones, complete in both
        for (unsigned int k = 0; k < n; ++k)
          {
            const RotatingMode &a = all.modes[k], &b = parts.modes[k];
            raise_to(difference, std::abs(a.frequency - b.frequency) / all.modes[n].frequency);
            residual = largest_of({residual, a.residual, b.residual});
            same     = same && a.description.nodal_diameter == b.description.nodal_diameter &&
                   a.description.is_pair == b.description.is_pair;
            // Members of a pair that stands may be told apart in any way.
            if (coriolis && rate != 0)
              same = same && std::abs(a.description.forward - b.description.forward) < 1e-2;
          }
        // The error is the square of the residual: round-off without Coriolis forces, 1e-6 with
        // them.
        check_below("sector: frequencies", difference, 1e-6);
        check_below("sector: residuals", residual, 2e-3);
        check("sector: nodal diameters", same);
        // The hub's free rotation stays a rigid motion at speed, but for terms of the order of
        // the strain under spin, 1e-4, times the speed squared.
        if (!coriolis)
          check_below("rotation about the axis",
                      std::pow(2. * pi * all.modes[0].frequency, 2) / std::max(rate * rate, 1e6),
                      1e-3);
      }
}

/** As many diameters as half the sectors: nodes and sectors coincide, there is one such mode and
 * not a pair, and it travels nowhere. */
void half_the_sectors(const Communicator &communicator)
{
  const Model model = make_wheel(Matrix3::Identity(), Vector3::UnitZ());
  for (const bool coriolis : {false, true})
    {
      FemOptions options;
      options.cyclic_symmetry  = true;
      options.coriolis         = coriolis;
      options.largest_diameter = 6;
      options.n_modes          = 4;
      const RotatingBody        wheel(model, 0, options, communicator);
      std::vector<ModesAtSpeed> speeds;
      speeds.push_back(wheel.find_modes(0.));
      speeds.push_back(wheel.find_modes(2000.));
      bool stands = true;
      for (const ModesAtSpeed &at_speed : speeds)
        for (const RotatingMode &mode : at_speed.modes)
          if (mode.description.nodal_diameter == 6)
            stands = stands && !mode.description.is_pair && mode.description.forward == .5;
      check("half the sectors: modes stand", stands);
      // Four modes a diameter: alone, or two pairs, whose waves part with Coriolis forces.
      unsigned int alone = 0, of_pairs = 0;
      bool         is_complete = true;
      for (const CampbellBranch &branch : make_branches(speeds))
        {
          alone += branch.nodal_diameter == 6;
          of_pairs += branch.nodal_diameter == 3;
          if (branch.nodal_diameter == 6)
            is_complete = is_complete && branch.rates.size() == 2 && branch.direction == "standing";
        }
      check("half the sectors: a branch each", alone == 4 && is_complete);
      check("a branch a pair, or a wave", of_pairs == (coriolis ? 4 : 2));
    }
}

/** Sectors lie about the mesh's z wherever the body is placed and in whichever sense it turns. */
void sector_axes(const Communicator &communicator)
{
  const Vector3 z = Vector3::UnitZ();
  sector(make_wheel(Matrix3::Identity(), z), {false, true}, {0., 3000.}, communicator);
  sector(make_wheel(Matrix3::Identity(), -z), {true}, {3000.}, communicator);
  const Matrix3 turn = rotation_about(Vector3(1., 2., -1.).normalized(), 1.);
  sector(make_wheel(turn, turn * z), {true}, {3000.}, communicator);
  for (const FemElement element : {FemElement::quadratic, FemElement::cubic})
    sector(make_wheel(turn, turn * z, {{1, 12, 1}}), {false, true}, {3000.}, communicator, element);
  // Spin about another line is not the same for all sectors, nor is a hub.
  const auto refuses = [&communicator](const Model &model) {
    FemOptions options;
    options.cyclic_symmetry = true;
    return has_text(message_of([&] { RotatingBody(model, 0, options, communicator); }),
                    "body \"wheel\"");
  };
  check("another axis is refused",
        refuses(make_wheel(Matrix3::Identity(), Vector3::UnitX())) && refuses(make_wheel(turn, z)));
  Model aside = make_wheel(Matrix3::Identity(), z);
  aside.bodies[0].axis.point += Vector3(0., .1, 0.);
  check("an axis beside is refused", refuses(aside));
}

int main(int argc, char **argv)
{
  return run_parts(argc, argv, {disc, ring, sector_axes, half_the_sectors});
}
