// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// Free motion of the torsional pair against closed forms: damped, through the backlash, in two
// inertias, on supports, growing under a stiffness that varies.
#include "../tests.h"
#include "pair.h"

using namespace vfife;

/** By the damper of the mesh, or by one against the kinematic speed, zeta_k = 2 zeta omega. */
void damped_motion(const bool by_speed)
{
  const double w = std::sqrt(2.2e9 / 20.), d = .05 * w, wd = w * std::sqrt(1 - .0025);
  LumpedPair   pair = linear_pair();
  if (by_speed)
    pair.speed_damping = 2 * d;
  else
    pair.damping_ratio = .05;
  const std::string     name = by_speed ? "speed damping: " : "";
  const LumpedModel     model(pair);
  const Eigen::VectorXd rest = model.find_equilibrium(0.);
  const double          a    = .5 * 8e5 / 2.2e9;
  check_close(name + "static lag [rad]", -rest[0], 8e5 / 2.2e9, 1e-15);
  check_close(name + "frequency [Hz]", model.find_modes()[0].frequency, w / (2 * pi), 1e-9);
  check_close(name + "damping ratio", model.find_modes()[0].damping_ratio, .05, 1e-14);

  LumpedSolver    solver(model, exact_run(0, 20, 16));
  Eigen::VectorXd q = rest;
  q[0] += a;
  solver.set_motion(q, Eigen::VectorXd::Zero(1));
  double               difference = 0;
  const LumpedResponse response   = solver.run(w / 7., [&](const LumpedSolver::Sample &s) {
    const double t     = s.time;
    const double exact = a * std::exp(-d * t) * (std::cos(wd * t) + d / wd * std::sin(wd * t));
    raise_to(difference, std::abs(s.q[0] - rest[0] - exact) / a);
  });
  // Some thousand steps of 1e-11, whose errors are damped.
  check_below(name + "damped swing", difference, 1e-8);
  check_below(name + "its energy balance", response.energy_error, 1e-8);
}

/** With the amplitude @p part of the static deflection the flanks part, and with a narrow
 * backlash meet on the other side; after the period of the closed form all is as before. */
void through_backlash(const std::string &name, const double part, const double backlash)
{
  LumpedPair   pair = linear_pair();
  const double k = 2.2e9, J = 20., T = 8e5, w = std::sqrt(k / J), rest = T / k;
  pair.law.backlash = backlash * rest;
  const double b = pair.law.backlash, amplitude = part * rest, a = T / J;
  const double v      = w * std::sqrt(amplitude * amplitude - rest * rest);
  double       period = 2 * (pi - std::acos(rest / amplitude)) / w;
  if (v * v / (2 * a) <= b)
    period += 2 * v / a;
  else
    {
      const double v_b = std::sqrt(v * v - 2 * a * b);
      period +=
        2 * (v - v_b) / a + 2 * std::acos(rest / std::sqrt(rest * rest + v_b * v_b / (w * w))) / w;
    }
  const LumpedModel model(pair);
  LumpedSolver      solver(model, exact_run(0, 10, 200));
  Eigen::VectorXd   q = model.find_equilibrium(0.);
  q[0] -= amplitude;
  const double start = q[0];
  solver.set_motion(q, Eigen::VectorXd::Zero(1));
  double               difference = 0;
  const LumpedResponse r          = solver.run(1 / period, [&](const LumpedSolver::Sample &s) {
    if (std::abs(s.position - std::round(s.position)) < 1e-6)
      raise_to(difference, std::abs(s.q[0] - start) / amplitude);
  });
  check_below(name + ": the motion returns", difference, 1e-7);
  check(name + ": flanks part once a period", r.losses == 10);
  check(name + ": the coast flanks touch as they should",
        (r.time_coast > 0) == (v * v / (2 * a) > b));
  check_below(name + ": energy balance", r.energy_error, 1e-8);
  // Impulse of the mesh over whole periods is that of the load; the mean over 200 samples a
  // period of a force with kinks is good to some 1e-4.
  check_ratio(name + ": mean force over T/arm", r.mean_force * 90. / T, 1e-3);
}

void two_inertias()
{
  LumpedPair pair     = linear_pair();
  pair.driver_is_free = true;
  const LumpedModel model(pair);
  const double      i = 27. / 79., J = 1 / (1 / 20. + i * i / .3);
  const auto        modes = model.find_modes();
  check_close("two inertias: they turn as a whole", modes[0].frequency, 0., 0.);
  check_close("two inertias: swing [Hz]",
              modes[1].frequency,
              std::sqrt(2.2e9 / J) / (2 * pi),
              1e-8);
  LumpedSolver    solver(model, exact_run(0, 10, 16));
  Eigen::VectorXd q = model.find_equilibrium(0.), v(2);
  v << .7, -.4;
  solver.set_motion(q, v);
  // Only the sum of both angular momenta over their gearing moves on: i I_g w_g + I_p w_p.
  const double momentum = i * 20. * v[0] + .3 * v[1];
  double       change   = 0;
  solver.run(500., [&](const LumpedSolver::Sample &s) {
    raise_to(change, std::abs(i * 20. * s.v[0] + .3 * s.v[1] - momentum));
  });
  check_below("two inertias: change of momentum", change / (i * 20. * .7), 1e-9);
}

void support()
{
  LumpedPair pair = linear_pair();
  pair.supports.push_back({"axial", false, .004, 1.9e-3, 2e5, 0.});
  const LumpedModel model(pair);
  // K = [k, -k h; -k h, k h^2 + c], M = diag(J, m)
  const double k = 2.2e9, h = .004, c = 2e5, J = 20., m = 1.9e-3;
  const double sum = k / J + (k * h * h + c) / m, product = k * c / (J * m);
  const double root  = std::sqrt(sum * sum / 4 - product);
  const auto   modes = model.find_modes();
  check_close("support: lower mode [Hz]",
              modes[0].frequency,
              std::sqrt(sum / 2 - root) / (2 * pi),
              1e-8);
  check_close("support: upper mode [Hz]",
              modes[1].frequency,
              std::sqrt(sum / 2 + root) / (2 * pi),
              1e-8);
  const Eigen::VectorXd rest = model.find_equilibrium(0.);
  check_close("support: static displacement [mm]", rest[1], -h * 8e5 / c, 1e-15);
  check_close("support: static lag [rad]", -rest[0], 8e5 / k + h * h * 8e5 / c, 1e-15);
  LumpedSolver    solver(model, exact_run(0, 20, 16));
  Eigen::VectorXd q = rest + 1e-4 * modes[0].shape;
  solver.set_motion(q, Eigen::VectorXd::Zero(2));
  double difference = 0;
  solver.run(1000., [&](const LumpedSolver::Sample &s) {
    const Eigen::VectorXd exact =
      1e-4 * std::cos(2 * pi * modes[0].frequency * s.time) * modes[0].shape;
    raise_to(difference, (s.q - rest - exact).norm() / (1e-4 * modes[0].shape.norm()));
  });
  // Some thousand steps of 1e-11.
  check_below("support: a mode swings alone", difference, 5e-8);
}

void growth()
{
  // k (1 + e cos 2 w t): small motions grow by exp(e w t/4) (Mathieu, first order in e).
  LumpedPair   pair = linear_pair();
  const double e = .1, w = std::sqrt(2.2e9 / 20.);
  pair.law.stiffness = FourierSeries(2.2e9, {e * 2.2e9}, {});
  const LumpedModel     model(pair);
  const Eigen::VectorXd rest = model.find_equilibrium(0.);
  std::vector<double>   size;
  for (const double extra : {0., 1e-5})
    {
      LumpedSolver    solver(model, exact_run(0, 90, 4));
      Eigen::VectorXd q = rest;
      q[0] *= 1 + extra;
      solver.set_motion(q, Eigen::VectorXd::Zero(1));
      std::size_t i = 0;
      solver.run(w / pi, [&](const LumpedSolver::Sample &s) {
        if (extra == 0)
          size.push_back(s.q[0]);
        else
          size[i] = std::abs(s.q[0] - size[i]);
        ++i;
      });
    }
  const double rate = std::log(size[4 * 80] / size[4 * 40]) / 40.;
  // The next term is of the order of e^2.
  check_ratio("growth under a varying stiffness", rate / (e * pi / 4), e * e);
}

int main()
{
  damped_motion(false);
  damped_motion(true);
  through_backlash("wide backlash", 3., 100.);
  through_backlash("narrow backlash", 3., .7);
  two_inertias();
  support();
  growth();
  return 0;
}
