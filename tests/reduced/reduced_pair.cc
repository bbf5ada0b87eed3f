// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// A pair of reduced bodies: at rest beside whole bodies, in motion its energy and its order.
#include "../parts.h"
#include "../refusal.h"
#include "../study/gear_model.h"
#include "../study/quick_pair.h"
#include "pair_of_bodies.h"

#include <vfife/element/stress.h>
#include <vfife/fem/statics/static_solver.h>
#include <vfife/reduced/reduced_options.h>
#include <vfife/reduced/resonance/linear_response.h>
#include <vfife/reduced/resonance/static_passage.h>

using namespace vfife;
using namespace pair_of_bodies;

Model make_model(const std::string  &name,
                 const std::string  &speed,
                 const std::string  &torque,
                 const Communicator &world)
{
  std::ofstream(name + ".prm") << coarse_pair("set body type = conical web", coarse_web)
                               << "subsection Operation\n set speed = " << speed
                               << "\n set torque = " << torque << "\n set end time = 1 ms\nend\n"
                               << given_penalty;
  return make_gear_model(name + ".prm", world);
}

Model make_model(const std::string &name, const double rpm, const Communicator &world)
{
  return make_model(name, std::to_string(rpm) + " rpm", "800 N m", world);
}

/** Where whole bodies turn by some 1e-4 on their hubs and reduced ones about their momentum, the
 * other's turn is a displacement, which is straight: parts of 1e-4 of displacements. */
constexpr double straight = 3e-5;

/** So slow that the pair is at rest in each position. */
void at_rest(Communicator &world)
{
  const Model  model = make_model("at_rest", 6., world);
  const double mesh  = 1. / model.only_transmission()->mesh_frequency();
  Compliance   compliance(model, make_fem_options(StiffnessKind::incompatible_modes), false, world);
  const std::vector<double>   turns = {0., .5 * 2. * pi / 27., 2. * pi / 27.};
  PairEquilibrium             whole(model, compliance, turns);
  const PairEquilibriumResult at = whole.solve(0., 1.);
  const double                te = error_of(model, compliance, at);

  // All residuals: two cut-offs, one static answer.
  for (const double cutoff : {15e3, 40e3})
    {
      ReducedPair pair =
        make_pair(model, reduce(model, cutoff, 39, world), {mesh / 2000., 2000., 2000.});
      const ReducedEquilibrium found = pair.start();
      const State              state = measure(pair);
      check_ratio("equilibrium of whole bodies: transmission error",
                  state.measured.transmission_error / te,
                  straight);
      double force = 0;
      for (const ToothContact &tooth : at.teeth)
        force += tooth.force.norm();
      check_ratio("force", state.measured.contact_force / force, 1e-6);
      check("teeth", state.measured.teeth.size() == at.teeth.size());
      const double slope = at.turn_slope + mean_rotation(compliance.space(),
                                                         1,
                                                         model.only_transmission()->driven_bore,
                                                         at.displacement_slope);
      check_ratio("stiffness", found.stiffness * std::abs(slope) / 8e5, straight);
      check_ratio("the load is carried", state.measured.contact_torque / 8e5, 1e-6);
    }

  // Through a mesh cycle.
  ReducedPair pair = make_pair(model, reduce(model, 15e3, 6, world), {mesh / 2000., 2000., 2000.});
  pair.start();
  double worst = 0;
  for (unsigned int i = 1; i <= 2000; ++i)
    {
      pair.step();
      if (i % 1000 != 0)
        continue;
      const State state = measure(pair);
      const auto  there = whole.solve(i == 1000 ? turns[1] : turns[2], 1.);
      raise_to(worst,
               std::abs(state.measured.transmission_error / error_of(model, compliance, there) -
                        1.));
    }
  // The swing that a load upon another tooth starts is still there.
  check_below("positions of a mesh cycle in turn", worst, 2e-4);

  // In equilibria alone, few and far between.
  pair.set_speed(model.only_transmission()->driver_rate, mesh / 8.);
  pair.start();
  for (const unsigned int half : {1, 2})
    {
      for (unsigned int i = 0; i < 4; ++i)
        pair.step_standing();
      const State state = measure(pair);
      check_ratio("equilibria in turn: transmission error",
                  state.measured.transmission_error /
                    error_of(model, compliance, whole.solve(turns[half], 1.)),
                  straight);
      check_ratio("the load is carried", state.measured.contact_torque / 8e5, 1e-6);
    }
}

/** Bodies with points between the nodes: facets move as the means at their nodes. */
void quadratic(Communicator &world)
{
  const Model    model = make_model("quadratic", 6., world);
  const double   mesh  = 1. / model.only_transmission()->mesh_frequency();
  ReducedOptions options;
  options.elements     = BodyElements::quadratic;
  const FemOptions fem = options.fem(StiffnessKind::incompatible_modes);
  check("curved elements, facets as their nodes",
        fem.element == FemElement::quadratic && fem.geometry == FemGeometry::curved &&
          !fem.divides_facets);
  Compliance                  compliance(model, fem, false, world);
  PairEquilibrium             whole(model, compliance, {0.});
  const PairEquilibriumResult at = whole.solve(0., 1.);
  ReducedPair                 pair =
    make_pair(model, reduce(model, 15e3, 39, world, fem), {mesh / 2000., 2000., 2000.});
  pair.start();
  check_ratio("quadratic elements: transmission error",
              measure(pair).measured.transmission_error / error_of(model, compliance, at),
              straight);
  const std::vector<Stress> stresses = compute_node_stresses(compliance.space(), at.displacements);
  double                    worst    = 0;
  for (std::size_t i = 0; i < model.probes.size(); ++i)
    {
      const Probe &probe = model.probes[i];
      const double known = von_mises(stresses[model.bodies[probe.body].first_node + probe.node]);
      raise_to(worst, std::abs(pair.reader().read_probes({probe}).front().von_mises / known - 1.));
    }
  check("probes", model.probes.size() > 1);
  // The turn on the hub strains the whole body by its linear strains.
  check_below("stresses at probes", worst, 1e-4);
}

/** Transmission errors at the ends of steps of a history. */
std::vector<double> move(const Model                    &model,
                         const std::vector<ReducedBody> &bodies,
                         const unsigned int              steps_per_mesh,
                         double                         &energy_error)
{
  const double mesh = 1. / model.only_transmission()->mesh_frequency();
  ReducedPair  pair = make_pair(model, bodies, {mesh / steps_per_mesh, 1000., 2000.});
  pair.start();
  std::vector<double> errors;
  for (unsigned int i = 1; i <= 2 * steps_per_mesh; ++i)
    {
      pair.step();
      if (i % (steps_per_mesh / 10) != 0)
        continue;
      const State state = measure(pair);
      errors.push_back(state.measured.transmission_error / arcsecond);
      raise_to(energy_error, std::abs(state.measured.energy.error()));
    }
  return errors;
}

void in_motion(Communicator &world)
{
  const Model                    model    = make_model("in_motion", 20000., world);
  const std::vector<ReducedBody> bodies   = reduce(model, 40e3, 4, world);
  double                         error[4] = {0, 0, 0, 0};
  const auto a = move(model, bodies, 50, error[0]), b = move(model, bodies, 100, error[1]),
             c = move(model, bodies, 200, error[2]), d = move(model, bodies, 400, error[3]);
  const double first = distance(a, b), second = distance(b, c), third = distance(c, d);
  check("steps of a half: a quarter of the error", first > 3 * second && second > 2.5 * third);
  check_below("energy", error[2], 2e-3);
  check("energy: better with smaller steps", error[3] < .5 * error[1]);
}

/** Rates at which mesh orders meet free vibrations: all of them, also where lines are near each
 * other. */
void resonances(Communicator &world)
{
  const Model                    model  = make_model("resonances", 20000., world);
  const std::vector<ReducedBody> bodies = reduce(model, 40e3, 4, world);
  const double                   mesh   = 1. / model.only_transmission()->mesh_frequency();
  ReducedPair                    pair   = make_pair(model, bodies, {mesh / 150., 1000., 2000.});
  const Transmission            &t      = *model.only_transmission();
  const StaticPassage            passage(model, pair, 12);
  const LinearResponse           linear(
    pair.body(t.driven), passage, {1000., 2000.}, pair.sector_sense(t.driven), t.driven_sense);
  unsigned int n_free = 2; // of the turn
  for (const ReducedBody::Harmonic &modes : bodies[t.driven].harmonics)
    n_free += (modes.number == 0 ? 2 : 4) * modes.n_modes();
  for (const int p : {1, 3})
    {
      // A quotient of polynomials of this degree has no other zeros, if these are different ones.
      const std::vector<Complex> rates = linear.resonance_rates(p);
      check("a rate for each free vibration", rates.size() == n_free);
      double worst = 0, nearest = 1;
      for (std::size_t i = 0; i < rates.size(); ++i)
        {
          const auto compliance = [&](const Complex &rate) {
            return linear.loop_compliance(linear.mesh_frequency(p, rate), rate);
          };
          for (std::size_t k = 0; k < i; ++k)
            nearest = std::min(nearest, std::abs(rates[i] / rates[k] - 1.));
          // How far Newton's method would move it.
          const Complex step = 1e-6 * rates[i];
          raise_to(worst,
                   std::abs(compliance(rates[i]) /
                            (compliance(rates[i] + step) - compliance(rates[i] - step)) * 2e-6));
        }
      check_below("zeros of the loop's compliance", worst, 1e-6);
      check("no zero twice", nearest > 1e-5);
    }
}

/** Speed and torque over time. */
void speeding_up(Communicator &world)
{
  // Accelerations begin and end without a jump; after 2 ms both are constant.
  const std::string ramp = "(min(t/0.002, 1) - sin(2*pi*min(t/0.002, 1))/(2*pi))";
  const Model model = make_model("speeding_up", "12000 + 4000*" + ramp, "800 + 400*" + ramp, world),
              end   = make_model("speeded_up", "16000 rpm", "1200 N m", world);
  const std::vector<ReducedBody> bodies = reduce(end, 40e3, 4, world);
  const Transmission            &t      = *model.only_transmission();
  const double                   step   = 1. / (150. * end.only_transmission()->mesh_frequency());
  ReducedPair                    pair   = make_pair(model, bodies, {step, 1000., 2000.});
  pair.start();
  double              time = 0, impulse = 0, load = 0, drive = 0, worst = 0;
  std::vector<double> errors;
  State               state;
  while (time < 5e-3)
    {
      pair.step();
      time += step;
      pair.measure(state);
      raise_to(worst, std::abs(state.measured.energy.residual() / state.measured.energy.strain));
      impulse += step * state.measured.contact_torque;
      load += step * std::abs(pair.load());
      drive += step * state.measured.drive_torque;
      if (time > 3.5e-3)
        errors.push_back(state.measured.transmission_error);
    }
  check_close("turn of the driver",
              state.measured.driver_angle,
              t.driver_start + t.driver_turn(time),
              1e-5);
  // Angular momentum, but for that of the swing at the end.
  const auto gain = [](const double inertia, const double from, const double to) {
    return inertia * (std::abs(to) - std::abs(from));
  };
  check_ratio("the contact speeds the gear up beside its load",
              (impulse - load) / gain(bodies[1].turn_inertia,
                                      t.driven_rate(),
                                      end.only_transmission()->driven_rate()),
              1e-2);
  check_ratio("the drive the pinion beside the contact",
              (drive - t.ratio() * impulse) / gain(model.bodies[0].axial_inertia(),
                                                   t.driver_rate,
                                                   end.only_transmission()->driver_rate),
              1e-2);
  // Euler forces on what the modes displace are left out, 1e-5 of the others.
  check_below("energy over the strain energy", worst, 5e-2);

  // Beside a pair that has the last speed and torque from the start.
  ReducedPair constant = make_pair(end, bodies, {step, 1000., 2000.});
  constant.start();
  double mean = 0, there = 0;
  for (const double error : errors)
    mean += error / errors.size();
  const unsigned int n_steps = 4 * 150;
  for (unsigned int i = 0; i < n_steps; ++i)
    {
      constant.step();
      constant.measure(state);
      there += state.measured.transmission_error / n_steps;
    }
  check_ratio("then it runs as one with that speed and torque", mean / there, 2e-3);
}

/** Without its load the gear springs away from the pinion; with it again it comes back. */
void parting(Communicator &world)
{
  const Model model =
    make_model("parting", "12000 rpm", "if(t < 0.0001, 800, if(t < 0.0006, 0, 400))", world);
  const double step = 1. / (150. * model.only_transmission()->mesh_frequency());
  ReducedPair  pair = make_pair(model, reduce(model, 15e3, 4, world), {step, 1000., 2000.});
  pair.start();
  unsigned int n_apart = 0, n_back = 0;
  double       torque = 0, last = 0;
  for (double time = step; time < 6e-3; time += step)
    {
      pair.step();
      const State state   = measure(pair);
      const bool  touches = !state.measured.teeth.empty();
      n_apart += touches ? 0 : 1;
      n_back += touches && n_apart > 0 ? 1 : 0;
      last = std::abs(state.measured.energy.error());
      if (time > 3e-3)
        torque += step / 3e-3 * state.measured.contact_torque;
    }
  check("flanks part", n_apart > 30);
  check("and come together", n_back > n_apart);
  check_ratio("the load is carried again", torque / 4e5, 5e-2);
  check_below("energy", last, 1e-2);
}

/** Steps in which the load alone would turn the gear by teeth. */
void too_long_steps(Communicator &world)
{
  const Model  model = make_model("too_long", 6., world);
  const double mesh  = 1. / model.only_transmission()->mesh_frequency();
  ReducedPair  pair  = make_pair(model, reduce(model, 15e3, 4, world), {mesh / 4., 2000., 2000.});
  pair.start();
  print_refusal<NumericalError>([&] {
    for (unsigned int i = 0; i < 20; ++i)
      pair.step();
  });
  pair.start();
  for (unsigned int i = 0; i < 20; ++i)
    pair.step_standing();
  check("equilibria have no such step", true);
}

void refusals(Communicator &world)
{
  Model                          model           = make_model("refused", 1., world);
  const std::vector<ReducedBody> bodies          = reduce(model, 10e3, 1, world);
  model.contacts[0].options.friction.coefficient = .1;
  check("friction is refused",
        has_text(message_of([&] { make_pair(model, bodies, {1e-5}); }), "friction"));
}

int main(int argc, char **argv)
{
  return run_parts(
    argc,
    argv,
    {at_rest, quadratic, in_motion, resonances, speeding_up, parting, too_long_steps, refusals});
}
