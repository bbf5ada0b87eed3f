// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// Explicit dynamics of blocks against what mechanics knows exactly: conservation in free tumbling,
// axial frequency of a free bar, bending frequency of a cantilever.
#include "../parts.h"
#include "../tests.h"
#include "one_solver.h"

#include <vfife/mesh/body_mesh.h>

using namespace vfife;

void set_velocity(State &state, const std::uint32_t i, const Vector3 &v)
{
  state.velocity.set(i, v);
}

void tumble()
{
  Model model = model_of(Body("block", make_block(Vector3(20, 10, 4), {{8, 4, 2}}), Material()));
  OneSolver run(model, undamped());

  // About the middle axis of inertia with a disturbance, and flying: Euler's unstable case, so
  // that it turns over.
  const Vector3 centre(10, 5, 2), flight(3000, -1000, 500), omega(200, 20000, 100);
  for (std::uint32_t i = 0; i < run.state.partition->n_local(); ++i)
    set_velocity(run.state, i, flight + omega.cross(run.state.node_position(i) - centre));
  const auto    &masses = run.solver.vfife_operator().masses();
  const Momentum start(run.state, masses);

  // Euler's equations of the rigid block of the same lumped masses, in its own axes.
  Matrix3 second = Matrix3::Zero();
  for (std::uint32_t i = 0; i < run.state.partition->n_local(); ++i)
    {
      const Vector3 r = run.state.node_position(i) - centre;
      second += masses[i] * r * r.transpose();
    }
  const Vector3 inertia    = (second.trace() * Matrix3::Identity() - second).diagonal();
  Vector3       rate       = omega;
  double        rigid_time = 0;
  const auto    derivative = [&](const Vector3 &w) {
    return Vector3(w.cross(Vector3(inertia.cwiseProduct(w))).cwiseQuotient(-inertia));
  };
  const auto advance_rigid = [&](const double time) {
    const double h = (time - rigid_time) / 20;
    for (unsigned int n = 0; n < 20; ++n)
      {
        const Vector3 k1 = derivative(rate), k2 = derivative(rate + h / 2 * k1),
                      k3 = derivative(rate + h / 2 * k2), k4 = derivative(rate + h * k3);
        rate += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
      }
    rigid_time = time;
  };

  const double turn_time  = 2 * pi / omega.norm();
  const double total_mass = model.bodies[0].mass();
  double linear = 0, angular = 0, energy = 0, stretch = 0, euler = 0, least_side = 1, measured = 0,
         followed = 0;
  auto observers  = watch(20, [&](const State &state) {
    const Momentum now(state, masses);
    for (const std::uint32_t i : state.partition->nodes(0))
      {
        const Vector3 X = model.bodies[0].node_positions()[state.partition->global_node[i]];
        raise_to(followed, (state.body_motion[0](X) - state.node_position(i)).norm());
      }
    measured =
      largest_of({measured,
                  (state.measured.momentum - now.linear).norm() / start.linear.norm(),
                  (state.measured.angular_momentum - now.angular).norm() / start.angular.norm()});
    raise_to(linear, (now.linear - start.linear).norm() / start.linear.norm());
    const Vector3 spin =
      now.angular - (centre + (state.time - state.dt / 2) * flight).cross(now.linear);
    const Vector3 first_spin = start.angular - (centre - state.dt / 2 * flight).cross(start.linear);
    raise_to(angular, (spin - first_spin).norm() / first_spin.norm());
    raise_to(energy,
             std::abs(state.measured.energy.residual()) /
               (0.5 * omega.dot(Vector3(inertia.cwiseProduct(omega)))));

    Vector3             corner[4];
    const std::uint32_t nodes[4] = {0, 8, 36, 90};
    for (unsigned int c = 0; c < 4; ++c)
      corner[c] = state.node_position(state.partition->local_node[nodes[c]]);
    const double size[3] = {20, 10, 4};
    for (unsigned int c = 0; c < 3; ++c)
      raise_to(stretch, std::abs((corner[c + 1] - corner[0]).norm() / size[c] - 1));

    // Rates in the block's axes: those of the angular momentum.
    advance_rigid(state.time);
    Vector3 own;
    for (unsigned int c = 0; c < 3; ++c)
      own[c] = first_spin.dot((corner[c + 1] - corner[0]).normalized()) / inertia[c];
    raise_to(euler, (own - rate).norm() / omega.norm());
    least_side = std::min(least_side, own[1] / omega[1]);
  });
  run.solver.run(run.state, 6 * turn_time, observers);

  // 10^4 steps of sums of some 100 terms: round-off is far below; 1e-12 leaves a factor of 10 to
  // 100.
  check_below("tumbling: momentum", linear, 1e-12);
  // The nodal forces of the polar frame are free of moments but for round-off.
  check_below("tumbling: angular momentum", angular, 1e-12);
  check_below("tumbling: measured momenta less those of the nodes", measured, 1e-12);
  // The velocities of a rigid motion do not fit a stretched block: at rho omega^2 L^2/8/E = 8e-4
  // vibrations of twice that.
  // Over the block's length of 20 mm: the nodes vibrate by parts of the stretch.
  check_below("tumbling: motion of the body beside its nodes", followed / 20, 4e-3);
  check_below("tumbling: change of length", stretch, 2e-3);
  // Work of central differences is exact for linear forces; the strain energy is 1e-3 of the spin
  // energy and the relative error of the ledger some percent of it in steps near the limit of
  // stability.
  check_below("tumbling: energy residual over spin energy", energy, 1e-4);
  // Elastic change of inertia (1e-3) advances the unstable turning over: factor exp(growth) of
  // some tens.
  check_below("tumbling: rates of Euler's equations", euler, 0.05);
  check("tumbling: turned over", least_side < -0.9);
  check("tumbling: momentum is that of the flight",
        (start.linear - total_mass * flight).norm() < 1e-9 * start.linear.norm());
}

/** Frequency of the first sign change cycle: half periods between interpolated zeros of samples.
 */
class ZeroCounter
{
public:
  void add(const double time, const double value)
  {
    if (n_ > 0 && value * last_ < 0)
      {
        const double zero = last_time_ + (time - last_time_) * last_ / (last_ - value);
        if (zeros_++ == 0)
          first_ = zero;
        latest_ = zero;
      }
    ++n_;
    last_      = value;
    last_time_ = time;
  }
  double frequency() const
  {
    return 0.5 * (zeros_ - 1) / (latest_ - first_);
  }

private:
  unsigned int n_ = 0, zeros_ = 0;
  double       last_ = 0, last_time_ = 0, first_ = 0, latest_ = 0;
};

void free_bar()
{
  const double       L = 100;
  const unsigned int n = 20;
  Material           material;
  material.poissons_ratio = 0;
  Model        model = model_of(Body("bar", make_block(Vector3(L, 5, 5), {{n, 1, 1}}), material));
  OneSolver    run(model, undamped());
  const double amplitude = 100; // [mm/s]; strain 2e-5, the frame's rotation plays no part
  for (std::uint32_t i = 0; i < run.state.partition->n_local(); ++i)
    set_velocity(run.state,
                 i,
                 Vector3(amplitude * std::cos(pi * run.state.node_position(i)[0] / L), 0, 0));

  const double c = std::sqrt(material.youngs_modulus / material.density), f = c / (2 * L),
               h = L / n;
  ZeroCounter zeros;
  const auto &masses = run.solver.vfife_operator().masses();
  double      energy = 0, other = 0;
  auto        observers = watch(1, [&](const State &state) {
    double mode = 0, square = 0;
    for (std::uint32_t i = 0; i < state.partition->n_local(); ++i)
      {
        const double shape =
          std::cos(pi * model.bodies[0].node_positions()[state.partition->global_node[i]][0] / L);
        mode += masses[i] * shape * state.node_velocity(i)[0];
        square += masses[i] * state.node_velocity(i).squaredNorm();
      }
    const double modal_mass = model.bodies[0].mass() / 2;
    raise_to(other,
             std::abs(square - mode * mode / modal_mass) / (modal_mass * amplitude * amplitude));
    zeros.add(state.time - state.dt / 2, mode);
    raise_to(energy, std::abs(state.measured.energy.error()));
  });
  run.solver.run(run.state, 10.3 / f, observers);

  // Lumped linear elements and central differences have the exact frequency
  //   sin(omega dt/2) = (c dt/h) sin(pi h/(2 L)):
  // zeros of the sampled cosine, interpolated linearly, are as exact as (omega dt)^2 over the 20
  // half periods.
  const double exact =
    std::asin(run.state.dt * c / h * std::sin(pi * h / (2 * L))) / (pi * run.state.dt);
  check_close("bar: frequency of lumped elements over continuum's",
              zeros.frequency() / f,
              exact / f,
              5e-6);
  // Both dispersions are below (pi h/(2 L))^2/6 = 1e-3, lumped masses down, steps up.
  check_ratio("bar: axial frequency over sqrt(E/rho)/(2 L)", zeros.frequency() / f, 1.1e-3);
  // cos(pi x/L) at the nodes is an eigenvector of the lumped bar: nothing else moves, but for
  // strains of second order (2e-5).
  check_below("bar: kinetic energy in other modes", other, 1e-6);
  // With v_- v_+/2 as kinetic energy central differences conserve energy exactly for linear
  // forces; here these are linear to the strain squared.
  check_below("bar: energy error", energy, 1e-8);
}

void cantilever()
{
  const double L = 100, H = 10;
  Material     material;
  material.poissons_ratio = 0; // a held end then does not stiffen what is near it
  Model model = model_of(Body("beam", make_block(Vector3(L, 5, H), {{20, 1, 2}}), material));
  model.constraints.push_back({"end", ConstraintKind::held, 0, model.bodies[0].node_set("x-")});
  OneSolver run(model, undamped());

  // The first shape of Euler and Bernoulli as initial velocity.
  const double k = 1.875104068711961 / L, ratio = 0.734095513778;
  const auto   shape = [&](const double x) {
    return std::cosh(k * x) - std::cos(k * x) - ratio * (std::sinh(k * x) - std::sin(k * x));
  };
  for (std::uint32_t i = 0; i < run.state.partition->n_local(); ++i)
    set_velocity(run.state, i, Vector3(0, 0, 10 * shape(run.state.node_position(i)[0])));
  const double c     = std::sqrt(material.youngs_modulus / material.density);
  const double euler = std::pow(k, 2) * c * H / std::sqrt(12.) / (2 * pi);

  ZeroCounter zeros;
  const auto &masses = run.solver.vfife_operator().masses();
  double      energy = 0, held = 0;
  auto        observers = watch(5, [&](const State &state) {
    double mode = 0;
    for (std::uint32_t i = 0; i < state.partition->n_local(); ++i)
      {
        const Vector3 &X = model.bodies[0].node_positions()[state.partition->global_node[i]];
        mode += masses[i] * shape(X[0]) * state.node_velocity(i)[2];
        if (X[0] == 0)
          raise_to(held, (state.node_position(i) - X).norm());
      }
    zeros.add(state.time, mode);
    raise_to(energy, std::abs(state.measured.energy.error()));
  });
  run.solver.run(run.state, 4.3 / euler, observers);

  // Timoshenko's beam (kappa = 5/6, nu = 0, so E/G = 2), first order: omega lower by
  // (k r)^2/2 (a + b E/(kappa G)), r = H/sqrt(12): by Rayleigh's quotient with the shape above,
  //   a = int phi'^2 / (k^2 int phi^2) of rotary inertia, b = int phi'''^2/(k^6 int phi^2) of
  //   shear.
  double       a = 0, b = 0, norm = 0;
  const double step = 1e-3 * L;
  for (double x = step / 2; x < L; x += step)
    {
      const double slope =
        std::sinh(k * x) + std::sin(k * x) - ratio * (std::cosh(k * x) - std::cos(k * x));
      const double third =
        std::sinh(k * x) - std::sin(k * x) - ratio * (std::cosh(k * x) + std::cos(k * x));
      norm += std::pow(shape(x), 2);
      a += std::pow(slope, 2);
      b += std::pow(third, 2);
    }
  const double timoshenko = euler * (1 - std::pow(k * H, 2) / 24 * (a + 2.4 * b) / norm);
  // 20 elements of the length with a linear deflection each: masses on nodes and the curvature of
  // one element, (k h)^2/12 = 7e-4 each, lower order terms of Timoshenko's beam 1e-4; of the
  // zeros by higher modes in the velocity some 1e-3.
  check_ratio("cantilever: frequency over Timoshenko's", zeros.frequency() / timoshenko, 2e-3);
  // Shear and rotary inertia of a beam of H/L = 0.1 take 0.7 % off.
  check("cantilever: frequency 0.5 to 1 % below Euler's and Bernoulli's",
        zeros.frequency() < 0.995 * euler && zeros.frequency() > 0.99 * euler);
  check_below("cantilever: held nodes", held, 0);
  check_below("cantilever: energy error", energy, 1e-6);
}

int main(int argc, char **argv)
{
  return run_parts(argc, argv, {tumble, free_bar, cantilever});
}
