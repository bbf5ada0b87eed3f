// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// Pressures over a step of central differences: bounces of masses for any penalty and step, what is
// kept, damping against its closed form, many points that share nodes, held directions.
#include "../parts.h"
#include "../tests.h"
#include "exponential_law.h"

#include <vfife/base/errors.h>
#include <vfife/contact/law/linear_law.h>
#include <vfife/contact/pressure_solver.h>

#include <sstream>

using namespace vfife;

/** A point over the middle of two facets that move as one: gap z_slave - z_master. */
TouchingPoint middle_point(const double gap, const double area)
{
  TouchingPoint point;
  point.direction[2] = 1.;
  for (unsigned int k = 0; k < 4; ++k)
    {
      point.slave_weights[k]    = .25;
      point.master_slopes[k][2] = -.25;
    }
  point.area = area;
  point.gap  = gap;
  return point;
}

/** Two bodies of four nodes each that fly along z: place, velocity, mass of a body. */
struct Bodies
{
  double mass[2], place[2] = {0., 0.}, velocity[2];
  double pressure = 0., energy = 0., loss = 0.;

  /** One step; forces act between the bodies only. */
  void step(const double dt, const ContactLaw &law, const double penalty, const double damping)
  {
    std::vector<PressureSolver::Node> nodes;
    for (const unsigned int body : {0, 0, 0, 0, 1, 1, 1, 1})
      {
        const Vector3 v(0., 0., velocity[body]);
        nodes.push_back({v, v, Matrix3::Identity() * (4. / mass[body])});
      }
    PressureSolver             solver(dt, nodes);
    std::vector<TouchingPoint> points = {middle_point(place[0] - place[1], 1.)};
    points[0].pressure                = pressure; // of the step before
    solver.add(points[0], {{0, 1, 2, 3}}, {{4, 5, 6, 7}}, {law, penalty, damping});
    solver.solve(points);
    pressure = points[0].pressure;
    loss -= (pressure - points[0].elastic) * points[0].gap_rate * dt;
    // Kinetic energy of the ledger: the product of the velocities before and after.
    energy                 = points[0].energy;
    const double before[2] = {velocity[0], velocity[1]};
    velocity[0] += dt * pressure / mass[0];
    velocity[1] -= dt * pressure / mass[1];
    for (unsigned int b = 0; b < 2; ++b)
      {
        energy += .5 * mass[b] * before[b] * velocity[b];
        place[b] += dt * velocity[b];
      }
  }
};

/** Whatever the penalty makes of a step, the bodies part as in an elastic collision, and energy
 * and momentum are kept in each step. */
void bounce()
{
  const LinearLaw      linear{PenaltyOptions()};
  const ExponentialLaw exponential{PenaltyOptions()};
  const double         dt = 1e-3;
  // Of central differences with the pressure before the step the limit is 4 of k dt^2/m.
  for (const double stiffness : {1e-2, 1., 1e2, 1e6})
    for (const ContactLaw *law :
         {static_cast<const ContactLaw *>(&linear), static_cast<const ContactLaw *>(&exponential)})
      {
        Bodies       bodies{{2., 3.}, {.0107, 0.}, {-7., 1.}};
        const double reduced = 2. * 3. / 5., penalty = stiffness * reduced / (dt * dt);
        const double kinetic  = .5 * (2. * 49. + 3. * 1.);
        const double momentum = -14. + 3.;
        double       energy = 0., impulse = 0.;
        unsigned int n = 0;
        for (;
             n < 1000 && (n < 5 || bodies.pressure > 0. || bodies.velocity[0] < bodies.velocity[1]);
             ++n)
          {
            bodies.step(dt, *law, penalty, 0.);
            raise_to(energy, std::abs(bodies.energy / kinetic - 1.));
            raise_to(impulse,
                     std::abs((2. * bodies.velocity[0] + 3. * bodies.velocity[1]) / momentum - 1.));
          }
        std::ostringstream name;
        name << (law == &linear ? "linear" : "exponential") << ", k dt^2/m = " << stiffness << ": ";
        // Elastic: the speed of approach 8 comes back, the centre of mass goes on with -11/5.
        const double bound = 1e-8;
        check_close(name.str() + "speed of parting",
                    bodies.velocity[0] - bodies.velocity[1],
                    8.,
                    8. * bound);
        check_below(name.str() + "energy", energy, bound);
        check_below(name.str() + "momentum", impulse, 1e-14);
      }
}

/** A damper beside the spring, at small steps against the closed form (no adhesion: Schwager and
 * Poeschel 2007), and at a step beyond all limits of an explicit one: no gain, the loss is known.
 */
void damped_bounce()
{
  const LinearLaw law{PenaltyOptions()};
  const double    mass = 2., penalty = 800., ratio = .1, speed = 3.;
  const double    damping = 2. * ratio * std::sqrt(penalty * mass);
  const double    omega0 = std::sqrt(penalty / mass), beta = ratio * omega0,
               omega = std::sqrt(omega0 * omega0 - beta * beta);
  const double duration =
    (std::acos(-1.) - std::atan(2. * beta * omega / (omega * omega - beta * beta))) / omega;
  for (const double dt : {1e-5, 1.})
    {
      Bodies bodies{{mass, 1e30}, {1e-9, 0.}, {-speed, 0.}};
      // To the end of the spring that it leaves pressed.
      for (unsigned int n = 0; n < 40000 && (n < 3 || bodies.place[0] < 0.); ++n)
        bodies.step(dt, law, penalty, damping);
      const double restitution = bodies.velocity[0] / speed;
      if (dt < 1e-3)
        check_close("damped: restitution", restitution, std::exp(-beta * duration), 1e-4);
      else
        check("damped: a long step gives no energy back", restitution > -1. && restitution < 1.);
      check_ratio("damped: loss over the energy of flight",
                  bodies.loss / (.5 * mass * speed * speed) + restitution * restitution,
                  1e-6);
    }
}

/** Nine points share the nodes of two facets, one node being held along the normal: the pressures
 * solve p = P(gaps at both ends) together. */
void shared_nodes()
{
  const LinearLaw                   law{PenaltyOptions()};
  const double                      dt = 1e-3, penalty = 5e6;
  std::vector<PressureSolver::Node> nodes;
  for (unsigned int i = 0; i < 8; ++i)
    nodes.push_back({Vector3(.1 * i, -.2, i < 4 ? -1. - .1 * i : .5),
                     Vector3(.1 * i, -.2, i < 4 ? -1.2 : .5),
                     Matrix3::Identity() * (1. + .1 * i)});
  nodes[2].inverse_mass(2, 2) = 0.;
  std::vector<TouchingPoint> points;
  PressureSolver             solver(dt, nodes);
  for (const double x : {.1, .5, .9})
    for (const double y : {.1, .5, .9})
      {
        TouchingPoint point = middle_point(-1e-4 * (1. + x - .5 * y), .1);
        const double  N[4]  = {(1. - x) * (1. - y), x * (1. - y), x * y, (1. - x) * y};
        for (unsigned int k = 0; k < 4; ++k)
          {
            point.slave_weights[k]    = N[k];
            point.master_slopes[k][2] = -N[(k + 1) % 4];
          }
        points.push_back(point);
        solver.add(point, {{0, 1, 2, 3}}, {{4, 5, 6, 7}}, {law, penalty});
      }
  solver.solve(points);
  // What the pressures make of the velocities, and the gaps at both ends by it.
  std::vector<PressureSolver::Node> after = nodes;
  double                            force = 0.;
  for (const TouchingPoint &point : points)
    for (unsigned int k = 0; k < 4; ++k)
      {
        const double f = dt * point.pressure * point.area;
        after[k].free_velocity += f * point.slave_weights[k] * nodes[k].inverse_mass.col(2);
        after[4 + k].free_velocity +=
          f * point.master_slopes[k][2] * nodes[4 + k].inverse_mass.col(2);
      }
  double error = 0.;
  for (const TouchingPoint &point : points)
    {
      double rate[2] = {0., 0.};
      for (unsigned int k = 0; k < 4; ++k)
        {
          rate[0] += point.slave_weights[k] * nodes[k].old_velocity[2] +
                     point.master_slopes[k][2] * nodes[4 + k].old_velocity[2];
          rate[1] += point.slave_weights[k] * after[k].free_velocity[2] +
                     point.master_slopes[k][2] * after[4 + k].free_velocity[2];
        }
      const double a = -(point.gap - .5 * dt * rate[0]), b = -(point.gap + .5 * dt * rate[1]);
      const double p = a > 0. && b > 0. ? .5 * penalty * (a + b)
                       : b > 0.         ? .5 * penalty * b * b / (b - a)
                       : a > 0.         ? .5 * penalty * a * a / (a - b)
                                        : 0.;
      raise_to(force, point.pressure);
      raise_to(error, std::abs(point.pressure - p));
    }
  check_below("shared nodes: pressures solve their law", error / force, 1e-7);
  check_below("shared nodes: a held node stays",
              std::abs(after[2].free_velocity[2] - nodes[2].free_velocity[2]),
              1e-300);
  check("shared nodes: sweeps", solver.n_sweeps() <= 12);
}

int main()
{
  return run_parts({bounce, damped_bounce, shared_nodes});
}
