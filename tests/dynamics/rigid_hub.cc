// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// A turning ring under a torque on a quarter of its bore: with a rigid hub the bore turns as one,
// with free rotation it does not; the angular momentum follows the torque either way. So it does
// for a solid shaft, whose face has nodes on the axis.
#include "../tests.h"
#include "relaxed.h"

#include <vfife/base/process/mpi_session.h>
#include <vfife/mesh/body_mesh.h>

using namespace vfife;

constexpr double rate = 500, torque = 2e5;

/** The nodes of @p hub turn, those of @p loaded in a quarter take the torque. */
Model make_model(const ConstraintKind      kind,
                 std::unique_ptr<BodyMesh> mesh,
                 const std::string        &hub,
                 const std::string        &loaded)
{
  Model model;
  Body  turning("body", std::move(mesh), Material());
  turning.turns_on_axis = true;
  turning.rate          = rate;
  model.add_body(std::move(turning));
  const Body &body = model.bodies[0];
  model.constraints.push_back({"hub", kind, 0, body.node_set(hub)});
  Torque load;
  load.name = "load";
  for (const unsigned int node : body.node_set(loaded))
    if (body.node_positions()[node][0] > 0 && body.node_positions()[node][1] > 0)
      load.nodes.push_back(node);
  load.areas = compute_nodal_areas(body, load.nodes);
  load.value = torque;
  model.torques.push_back(load);
  return model;
}

/** Default steel [t/mm^3]. */
constexpr double density = 7.85e-9;

/** Moment of inertia about z of the mass points, J = sum r_i^2 int rho N_i dV, by Gauss's rule of
 * two points along each direction: exact, as N_i det J is of third order in each [t mm^2]. */
double integrate_inertia(const Body &body)
{
  double       sum = 0;
  const double g   = std::sqrt(1. / 3.);
  for (unsigned int e = 0; e < body.n_elements(); ++e)
    for (const double x : {-g, g})
      for (const double y : {-g, g})
        for (const double z : {-g, g})
          {
            const auto corner = [&](const unsigned int i) -> const Vector3 & {
              return body.node_positions()[body.elements()[e][i]];
            };
            Matrix3 jacobian = Matrix3::Zero();
            double  square   = 0;
            for (unsigned int i = 0; i < 8; ++i)
              {
                const double a = i & 1 ? 1 : -1, b = i & 2 ? 1 : -1, c = i & 4 ? 1 : -1;
                const double A = (1 + a * x) / 2, B = (1 + b * y) / 2, C = (1 + c * z) / 2;
                jacobian += corner(i) * Vector3(a * B * C, A * b * C, A * B * c).transpose() / 2;
                square += A * B * C * corner(i).head<2>().squaredNorm();
              }
            sum += density * square * jacobian.determinant();
          }
  return sum;
}

/** The same of a ring of n chords with nodes at radii 20, 25, 30 mm and a height of 10 mm, in
 * closed form: r^2 of a cell's nodes is interpolated over its trapezoid, of area r dr sin(2 pi/n)
 * at each radius. */
double ring_inertia(const unsigned int n)
{
  double sum = 0;
  for (const double r1 : {20., 25.})
    {
      const double r2 = r1 + 5, d = r2 * r2 - r1 * r1;
      // int_0^1 (r1^2 + s d) (r1 + 5 s) 5 ds
      sum += 5 * (r1 * r1 * r1 + (d * r1 + 5 * r1 * r1) / 2 + 5 * d / 3);
    }
  return density * 10 * n * std::sin(2 * pi / n) * sum;
}

/** Largest difference of the angles by which the hub's nodes have turned [rad]. */
double turn_apart(const Model &model)
{
  const Body  &body = model.bodies[0];
  OneSolver    run(model, undamped());
  const double steps     = 400;
  const double inertia   = integrate_inertia(body);
  double       wrong     = 0;
  auto         observers = watch(10, [&](const State &state) {
    // Velocities are half a step back; the first half step adds half of an impulse.
    const double expected = rate + torque * state.time / inertia;
    raise_to(wrong, std::abs(state.measured.body_rates[0] - expected) / rate);
  });
  run.solver.run(run.state, steps * run.state.dt, observers);

  double least = 1e9, most = -1e9, radius = 0;
  for (const unsigned int node : model.constraints[0].nodes)
    {
      const Vector3 start = body.placement(body.node_positions()[node]);
      const Vector3 now   = run.state.node_position(run.state.partition->local_node[node]);
      if (start.head<2>().norm() < 1e-9)
        {
          // On the axis there is no angle.
          check("node on the axis stays", now == start);
          continue;
        }
      const double angle =
        std::atan2(start[0] * now[1] - start[1] * now[0], start[0] * now[0] + start[1] * now[1]);
      least = std::min(least, angle);
      raise_to(most, angle);
      raise_to(radius, std::abs(now.head<2>().norm() / start.head<2>().norm() - 1));
    }
  // The rate belongs to the middle of a step: half of its gain, and the sums' round-off.
  check_below("rate follows the torque", wrong, 1e-10 + torque * run.state.dt / inertia / rate);
  check_below("bore keeps its radius", radius, 1e-12);
  check_below("energy error", run.state.measured.energy.error(), 1e-2);
  return most - least;
}

/** A tube whose nodes all turn freely on their circles, under opposite torques at its ends: the
 * twist of its equilibrium [rad]. */
double twist(const unsigned int n)
{
  constexpr double length = 50;
  Model       model = model_of(Body("tube", make_ring(20, 22, length, {{1, n, 10}}), Material()));
  const Body &body  = model.bodies[0];
  model.constraints.push_back({"circles", ConstraintKind::free_rotation, 0, all_nodes(body)});
  for (const auto &[end, sign] : {std::pair("top", 1.), std::pair("bottom", -1.)})
    {
      model.torques.push_back(torque_on(model, end, sign * torque));
    }
  OneSolver run(model, undamped());
  relax(model, run);
  const auto angle = [&](const std::string &end) {
    double sum = 0;
    for (const unsigned int node : body.node_set(end))
      {
        const Vector3 X = body.node_positions()[node],
                      x = run.state.node_position(run.state.partition->local_node[node]);
        sum += std::atan2(X[0] * x[1] - X[1] * x[0], X[0] * x[0] + X[1] * x[1]);
      }
    return sum / body.node_set(end).size();
  };
  return angle("top") - angle("bottom");
}

/** The twist tends to T L/(G J), its error with the square of the chords. */
void relax_twist()
{
  const Material material;
  const double   G = material.youngs_modulus / (2 * (1 + material.poissons_ratio)),
               J = pi / 2 * (std::pow(22., 4) - std::pow(20., 4)), exact = torque * 50 / (G * J),
               coarse = twist(24) / exact - 1, fine = twist(48) / exact - 1;
  check_below("twist in equilibrium, 48 chords", fine, 0.008);
  check_close("twist in equilibrium, order", std::log2(coarse / fine), 2., 0.1);
}

/** A turning tube, all of whose nodes turn freely on their circles, in its first torsional mode:
 * the damper takes the energy of the mode with exp(-zeta t) and leaves the spin. */
void damp_torsion()
{
  constexpr double zeta = 2000, length = 100, excited = 20;
  Model            model;
  Body             tube("tube", make_ring(20, 22, length, {{1, 24, 20}}), Material());
  tube.turns_on_axis = true;
  tube.rate          = rate;
  for (const Vector3 &X : tube.node_positions())
    tube.initial_velocity.push_back(excited * std::cos(pi * X[2] / length) *
                                    Vector3(-X[1], X[0], 0));
  model.add_body(std::move(tube));
  model.constraints.push_back(
    {"all", ConstraintKind::free_rotation, 0, all_nodes(model.bodies[0])});
  DynamicsOptions options = undamped();
  options.damping         = zeta;
  OneSolver    run(model, options);
  EnergyLedger first;
  double       last_rate = 0;
  auto         observers = watch(10, [&](const State &state) {
    if (state.step == 0)
      first = state.measured.energy;
    last_rate = state.measured.body_rates[0];
  });
  run.solver.run(run.state, 5e-4, observers);
  const EnergyLedger &last  = run.state.measured.energy;
  const double        start = first.kinetic_relative + first.strain,
               end          = last.kinetic_relative + last.strain;
  // The shape is excited by half of I excited^2/2.
  check_ratio("tube: energy of the mode at the start",
              start / (0.25 * model.bodies[0].axial_inertia() * excited * excited),
              1e-2);
  // Within zeta/omega of a half period's swing of the loss, omega = pi/L sqrt(G/rho) = 1e5 1/s.
  check_ratio("tube: logarithm of the energy over -zeta t",
              std::log(end / start) / (-zeta * run.state.time),
              2e-2);
  check_ratio("tube: damping loss over the energy lost", last.damping_loss / (start - end), 2e-3);
  // Momenta are those of the chords.
  check_ratio("tube: the spin stays", last_rate / rate, std::pow(rate * run.state.dt, 2));
  check_below("tube: mean torque of the damper over that of a drag zeta I rate",
              run.solver.damping_audit()[0].net_torque /
                (zeta * model.bodies[0].axial_inertia() * rate),
              1e-9);
}

int main(int argc, char **argv)
{
  MpiSession session(argc, argv);
  const auto ring = [](const ConstraintKind kind) {
    return make_model(kind, make_ring(20, 30, 10, {{2, 24, 2}}), "inner", "inner");
  };
  {
    const Model model = ring(ConstraintKind::rigid_hub);
    check_ratio("inertia of the ring: closed form over quadrature",
                ring_inertia(24) / integrate_inertia(model.bodies[0]),
                1e-13);
  }
  const double hub = turn_apart(ring(ConstraintKind::rigid_hub));
  // All nodes get the same angle; it is read back from coordinates by a quotient of products.
  check_below("rigid hub turns as one [rad]", hub, 2e-15);
  const double free = turn_apart(ring(ConstraintKind::free_rotation));
  // 2e5 N mm at 20 mm on a quarter of the bore, 314 mm^2, are 32 MPa of shear, 4e-4 rad in steel.
  check("free bore is sheared", free > 2e-5 && free < 2e-3);

  const auto shaft = [](const ConstraintKind kind) {
    return make_model(kind, make_cylinder(20, 10, {{2, 3, 2}}), "bottom", "outer");
  };
  check_below("rigid face of a shaft turns as one [rad]",
              turn_apart(shaft(ConstraintKind::rigid_hub)),
              2e-15);
  check("free face of a shaft is sheared", turn_apart(shaft(ConstraintKind::free_rotation)) > 0);
  damp_torsion();
  relax_twist();
  return 0;
}
