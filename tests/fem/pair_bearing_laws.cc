// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// The loaded pair in bearings: rolling bearings against linear ones of their own tangent, preloads,
// the pin of the driven body, what is refused, columns of bearings.csv.
#include "../parts.h"
#include "../refusal.h"
#include "pair_in_bearings.h"

#include <vfife/bearing/rolling_bearing.h>
#include <vfife/fem/system/rigid_motions.h>
#include <vfife/mesh/primitives/primitives.h>
#include <vfife/output/measures/bearing_columns.h>
#include <vfife/study/conventional/loaded_contact_tables.h>

using namespace vfife;

std::shared_ptr<const RollingBearing> tapered_bearing(const double sense, const double preload)
{
  RollingBearingData data;
  data.element        = RollingElement::roller;
  data.n              = 20;
  data.diameter       = 8;
  data.length         = 12;
  data.pitch_diameter = 60;
  data.contact_angle  = 15 * pi / 180;
  data.sense          = sense;
  data.preload        = preload;
  return std::make_shared<RollingBearing>(data, Matrix5::Zero());
}

std::shared_ptr<const RollingBearing> ball_bearing(const double clearance)
{
  RollingBearingData data;
  data.n              = 16;
  data.diameter       = 10;
  data.pitch_diameter = 60;
  data.clearance      = clearance;
  data.working_load   = Vector3(1000., 0., 500.);
  data.cage_rolls     = true;
  return std::make_shared<RollingBearing>(data, Matrix5::Zero());
}

/** Rolling bearings against linear ones that have their load and tangent in the equilibrium. */
void rolling(Communicator &world)
{
  using Laws      = std::vector<std::shared_ptr<const BearingLaw>>;
  const Laws laws = {tapered_bearing(1., 3000.),
                     tapered_bearing(-1., 3000.),
                     ball_bearing(.01),
                     tapered_bearing(-1., 500.)};
  Laws       twins;
  Errors     errors[2];
  for (const bool twin : {false, true})
    {
      Model model = make_held_pair(world);
      hang_in_bearings(model, twin ? twins : laws, 5e8);
      Compliance      compliance(model, lumped_masses(), false, world);
      PairEquilibrium equilibrium(model, compliance, {.1});
      const auto      result = equilibrium.solve(.1, 1.);
      errors[twin]           = transmission_errors(compliance.space(), result);
      check("rolling: few iterations", result.iterations <= 15);
      check_below("rolling: forces of each body", unbalanced(model, result), 1e-6);
      check_below("rolling: moments of each body",
                  unbalanced_moment(model, compliance, equilibrium, result),
                  1e-6);
      if (twin)
        continue;
      for (std::size_t b = 0; b < 4; ++b)
        {
          // A cage that rolls has gone with the kinematic turn of its body.
          const Transmission &t    = *model.only_transmission();
          const double        turn = b < 2 ? t.driver_sense * .1 : t.driven_sense * t.ratio() * .1;
          const Vector5       q    = result.bearings[b].displacement;
          const auto          response = laws[b]->evaluate(q, turn);
          check_below("rolling: load of bearing " + std::to_string(b) + " less that of its law [N]",
                      (result.bearings[b].load - response.load).head<3>().norm(),
                      1e-6);
          if (b == 2)
            check("rolling: with its cage where it was the load would be another one",
                  (laws[b]->evaluate(q).load - response.load).norm() > 1.);
          twins.push_back(
            linear_bearing(response.stiffness, response.load + response.stiffness * q));
        }

      // As the start of a run has it: loads of bearings at the undisplaced place are known.
      std::vector<double> forces(result.displacements.size(), 0.);
      for (std::size_t b = 0; b < 4; ++b)
        {
          const Wrench wrench =
            ShaftSeat(model.bearings[b].axes)
              .of_load(laws[b]->evaluate(Vector5::Zero()).load, MeanMotion::Motion());
          Eigen::Matrix<double, 6, 1> on;
          on << wrench.force, wrench.moment;
          compliance.rings().list()[b].add_forces(on, forces);
        }
      std::vector<double> free = compliance.solve(forces);
      for (std::size_t i = 0; i < free.size(); ++i)
        free[i] += compliance.twisted()[i];
      const auto pressed = equilibrium.press(.1,
                                             std::vector<double>(free.size(), 0.),
                                             free,
                                             model.torques.front().value);
      check_ratio("press() finds the same",
                  lead_of_driven(compliance.space(), pressed.turn, pressed.displacements) /
                    errors[0].loaded,
                  1e-7);
    }
  check_ratio("rolling: transmission error", errors[1].loaded / errors[0].loaded, 1e-7);
  check_ratio("rolling: its slope", errors[1].slope / errors[0].slope, 1e-6);
}

/** Where the unloaded bodies are: preloads that balance, and one that does not. */
void preloads(Communicator &world)
{
  const Vector5 force = 2000. * Vector5::Unit(2);
  for (const bool balanced : {true, false})
    {
      Model      model = make_held_pair(world, rigid_steel);
      const auto front = linear_bearing(soft_front, force);
      hang_in_bearings(model,
                       {tapered_bearing(1., 3000.),
                        tapered_bearing(-1., 3000.),
                        front,
                        linear_bearing(soft_back, balanced ? Vector5(-force) : Vector5::Zero())},
                       5e8);
      Compliance      compliance(model, lumped_masses(), false, world);
      PairEquilibrium equilibrium(model, compliance, {0.});
      const auto      result = equilibrium.solve(0., 1.);
      const auto      shift  = [&](const std::size_t b) {
        const BearingRing &ring = compliance.rings().list()[b];
        return model.bodies[ring.body].axis.direction.dot(
          ring.displacement(result.touch_displacements).head<3>());
      };
      // A hundredth of the shift: the body between the bearings is compressed.
      check_below("opposite preloads leave the driver [mm]", shift(0), 5e-5);
      check_close("shift of the driven body [mm]", shift(3), balanced ? 0. : 2000. / 4e5, 5e-5);
      check_below("preloads: forces of each body", unbalanced(model, result), 1e-6);
      check_below("preloads: moments of each body",
                  unbalanced_moment(model, compliance, equilibrium, result),
                  1e-6);
    }
}

/** The ring that pins the driven body's turn is the first one: either will do. */
void pin(Communicator &world)
{
  std::vector<Errors> errors;
  for (const bool reversed : {false, true})
    {
      Model model = make_held_pair(world);
      hang_in_bearings(model,
                       {linear_bearing(soft_front),
                        linear_bearing(soft_back),
                        linear_bearing(10. * soft_back),
                        linear_bearing(10. * soft_front)},
                       5e8);
      if (reversed)
        std::swap(model.bearings[2], model.bearings[3]);
      Compliance      compliance(model, lumped_masses(), false, world);
      PairEquilibrium equilibrium(model, compliance, {0.});
      errors.push_back(transmission_errors(compliance.space(), equilibrium.solve(0., 1.)));
    }
  // It carries what the moments about displaced and undisplaced axes differ by, some 1e-4 of the
  // load, and that twists the bodies by this part of their windup.
  check_ratio("pin: transmission error", errors[1].loaded / errors[0].loaded, 1e-4);
  check_ratio("pin: its slope", errors[1].slope / errors[0].slope, 1e-4);
}

/** A body on an axis askew to the frame turns freely about that axis, and about nothing else. */
void free_motion(Communicator &)
{
  Model model;
  model.add_body(Body("ring", make_ring(20., 40., 60., {{1, 12, 2}}), Material()));
  Body &ring              = model.bodies[0];
  ring.placement.rotation = axes_along(Vector3(1., 2., 3.).normalized());
  ring.axis.direction     = ring.placement.rotation.col(2);
  ring.axis.point         = ring.placement.translation;
  Bearing bearing;
  bearing.nodes = ring.node_set("inner");
  bearing.axes  = axes_along(ring.axis.direction);
  bearing.law   = linear_bearing(bearing_stiffness(1e5, 1e2, 1e8));
  model.bearings.push_back(bearing);
  const FemSpace points(model, {0}, FemElement::full);
  const auto     motions = find_free_motions(points, points.parts().front());
  check("one motion is free", motions.size() == 1);
  double off = 0, largest = 0;
  for (std::size_t p = 0; p < points.n_points(); ++p)
    {
      const Eigen::Map<const Vector3> u(motions.front().data() + 3 * p);
      const Vector3 way = ring.axis.direction.cross(points.points()[p] - ring.axis.point);
      raise_to(off, u.cross(way).norm() / way.squaredNorm());
      raise_to(largest, u.norm() / way.norm());
    }
  check_below("it is the turn about the axis", off / largest, 1e-6);
}

/** Bearings so soft that flanks would leave what was looked at for contact. */
void too_soft(Communicator &world)
{
  Model      model = make_held_pair(world, rigid_steel);
  const auto law   = linear_bearing(5e-3 * soft_front);
  hang_in_bearings(model, {law, law, law, law}, 5e8);
  Compliance        compliance(model, lumped_masses(), false, world);
  PairEquilibrium   equilibrium(model, compliance, {0.});
  const std::string message = message_of<NumericalError>([&] { equilibrium.solve(0., 1.); });
  const bool        told    = has_text(message, "bearings displace the flanks by ");
  check("too soft bearings are told", told);
  if (!told)
    std::cout << message << std::endl;
}

void refusals(Communicator &world)
{
  const auto law = linear_bearing(soft_front);
  {
    Model model = make_held_pair(world);
    hang_in_bearings(model, {law, law, law, law}, 5e8);
    model.couplings.front().body  = model.only_transmission()->driven;
    model.couplings.front().nodes = model.only_transmission()->driven_bore;
    print_refusal([&]() { Compliance(model, lumped_masses(), false, world); });
  }
  {
    Model model = make_held_pair(world);
    hang_in_bearings(model, {law, law, law, law}, 5e8);
    Coupling second = model.couplings.front();
    second.body     = model.only_transmission()->driven;
    second.nodes    = model.only_transmission()->driven_bore;
    model.couplings.push_back(second);
    Compliance compliance(model, lumped_masses(), false, world);
    print_refusal([&]() { PairEquilibrium(model, compliance, {0.}); });
  }
}

/** Numbers that all differ. */
void columns(Communicator &)
{
  SeatState state;
  state.load << 3, 4, 5, 6000, 7000;
  state.displacement << .03, .04, .05, 60 * arcsecond, 120 * arcsecond;
  Table             table = make_loaded_bearing_table();
  const std::string name  = "front";
  table.add_row(list_bearing_columns().make_row(.5, {name, state}));
  const auto value = [&table](const char *column) { return table.numbers(column)[0]; };
  check("bearings.csv: each number in its column",
        value("position") == .5 && table.column("bearing").texts.front() == "front" &&
          value("force x") == 3 && value("force y") == 4 && value("force z") == 5 &&
          value("moment x") == 6 && value("moment y") == 7 && value("radial force") == 5);
  check_close("bearings.csv: displacement z [um]", value("displacement z"), 50., 1e-12);
  check_close("bearings.csv: tilt y [arcmin]", value("tilt y"), 2., 1e-12);
  check_close("bearings.csv: radial displacement [um]", value("radial displacement"), 50., 1e-12);
}

int main(int argc, char **argv)
{
  return run_parts(argc, argv, {columns, free_motion, rolling, preloads, pin, too_soft, refusals});
}
