// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// The equations of the lumped model written out by hand for one motion, its powers and energy; what
// each number of the pair does to stiffness, damping and critical speeds; the numbers of its
// tables.
#include "../parts.h"
#include "../tests.h"
#include "pair.h"

#include <vfife/lumped/speed_sweep.h>

using namespace vfife;

constexpr double ratio = 27. / 79;

/** Free pinion, two supports, stiffness and error that change over the mesh, all dampers. */
LumpedPair full_pair()
{
  LumpedPair pair         = linear_pair();
  pair.driver_is_free     = true;
  pair.law.stiffness      = FourierSeries(2.2e9, {2.2e8}, {});
  pair.law.unloaded_error = FourierSeries(0., {}, {3e-5});
  pair.law.backlash       = 1e-3;
  pair.damping_ratio      = .04;
  pair.speed_damping      = 50;
  pair.supports = {{"axial", false, .004, 1.9e-3, 2e5, .03}, {"tilt", true, -.7, 9., 1e9, .06}};
  return pair;
}

void equations()
{
  const LumpedPair  pair = full_pair();
  const LumpedModel model(pair);
  const double      x = .3, f = 9000, w = 2 * pi;
  Eigen::VectorXd   q(4), v(4);
  q << -5e-4, 1e-4, -2e-2, 3e-5;
  v << .8, -.5, 7., .2;

  // The gear's turn opens the mesh, the pinion's closes it.
  const double k = 2.2e9 * (1 + .1 * std::cos(w * x)), k_x = -2.2e8 * w * std::sin(w * x);
  const double u = 3e-5 * std::sin(w * x), u_t = 3e-5 * w * std::cos(w * x) * f;
  const double s   = -q[0] + ratio * q[1] + .004 * q[2] - .7 * q[3] + u;
  const double s_t = -v[0] + ratio * v[1] + .004 * v[2] - .7 * v[3] + u_t;
  check_close("compression [rad]", model.compression(q, x), s, 1e-18);
  check("it is in contact", s > 0);
  check_close("transmission error [rad]", model.transmission_error(q), q[0] - ratio * q[1], 1e-18);

  // The damper is critical for the swing of both members on the mean stiffness.
  const double J = 1 / (1 / 20. + ratio * ratio / .3), c = 2 * .04 * std::sqrt(2.2e9 * J);
  const double M = k * s + c * s_t, c0 = 50 * 20., c2 = 2 * .03 * std::sqrt(2e5 * 1.9e-3),
               c3  = 2 * .06 * std::sqrt(1e9 * 9.);
  const auto rates = model.compute_rates(q, v, x, f);
  check_ratio("torque of the mesh [N mm]", rates.mesh_torque / M, 1e-12);
  const double expected[] = {(-8e5 + M - c0 * v[0]) / 20.,
                             ratio * (8e5 - M) / .3,
                             (-.004 * M - 2e5 * q[2] - c2 * v[2]) / 1.9e-3,
                             (.7 * M - 1e9 * q[3] - c3 * v[3]) / 9.};
  const char  *names[]    = {"gear", "pinion", "displacement", "tilt"};
  for (unsigned int j = 0; j < 4; ++j)
    check_ratio(std::string("acceleration of the ") + names[j],
                rates.acceleration[j] / expected[j],
                1e-12);

  // Torques, the flank's form that passes and the stiffness that changes bring energy.
  check_ratio("power supplied [mJ/s]",
              rates.supplied / (-8e5 * v[0] + ratio * 8e5 * v[1] + M * u_t + k_x * f * s * s / 2),
              1e-12);
  check_ratio("power of the dampers [mJ/s]",
              rates.dissipated /
                (c * s_t * s_t + c0 * v[0] * v[0] + c2 * v[2] * v[2] + c3 * v[3] * v[3]),
              1e-12);
  check_ratio("energy [mJ]",
              model.compute_energy(q, v, x) /
                (.5 * (20. * v[0] * v[0] + .3 * v[1] * v[1] + 1.9e-3 * v[2] * v[2] +
                       9. * v[3] * v[3]) +
                 .5 * (2e5 * q[2] * q[2] + 1e9 * q[3] * q[3] + k * s * s)),
              1e-12);

  // At rest the mesh carries the torque, and the supports their share of its force.
  const Eigen::VectorXd rest = model.find_equilibrium(x);
  check_close("at rest: compression", model.compression(rest, x), 8e5 / k, 1e-15);
  check_close("at rest: displacement [mm]", rest[2], -.004 * 8e5 / 2e5, 1e-15);
  check_close("at rest: tilt [rad]", rest[3], .7 * 8e5 / 1e9, 1e-15);
  check_close("at rest: the pinion stands", rest[1], 0., 0.);

  // Through the play there is neither spring nor damper; on the coast flanks both.
  q[0] += s + .5e-3;
  check_close("in the play: no torque", model.compute_rates(q, v, x, f).mesh_torque, 0., 0.);
  q[0] += 1e-3;
  check_ratio("on the coast flanks [N mm]",
              model.compute_rates(q, v, x, f).mesh_torque / (-.5e-3 * k + c * s_t),
              1e-9);
}

void stiffness_and_damping()
{
  // M = k d (k d/T0)^(p - 1): the slope under T is p k (T/T0)^(1 - 1/p).
  LumpedPair pair           = linear_pair();
  pair.law.exponent         = 1.3;
  pair.law.reference_torque = 5e5;
  const double k            = 1.3 * 2.2e9 * std::pow(1.6, 1 - 1 / 1.3);
  check_ratio("slope of the power law under the torque",
              LumpedModel(pair).mesh_stiffness() / k,
              1e-12);

  // The mean over the mesh of what varies.
  LumpedPair varying    = linear_pair();
  varying.law.stiffness = FourierSeries(2.2e9, {2e8, 1e8}, {3e8});
  check_ratio("mean over the mesh", LumpedModel(varying).mesh_stiffness() / 2.2e9, 1e-12);

  // One inertia: the damper's ratio, and half of the decay of the speed damping over the rate.
  LumpedPair damped     = linear_pair();
  damped.damping_ratio  = .05;
  damped.speed_damping  = 600;
  const double     rate = std::sqrt(2.2e9 / 20.);
  const LumpedMode mode = LumpedModel(damped).find_modes().at(0);
  check_close("frequency [Hz]", mode.frequency, rate / (2 * pi), 1e-9);
  check_close("damping ratio", mode.damping_ratio, .05 + 600 / (2 * rate), 1e-13);
  check_ratio("modal mass 1 t", mode.shape[0] * mode.shape[0] * 20., 1e-13);
}

void motion_table()
{
  const LumpedModel    model(full_pair());
  LumpedSolver::Sample sample;
  sample.time     = .01;
  sample.position = 3.25;
  sample.q        = Eigen::VectorXd(4);
  sample.v        = Eigen::VectorXd::Zero(4);
  sample.q << 4 * arcsecond, 7 * arcsecond, .005, 6 * arcsecond;
  sample.mesh_torque  = 9e5;
  sample.energy_error = .7;
  Table table         = make_motion_table(model);
  add_motion(model, sample, table);
  const auto close = [&table](const char *name, const char *unit, const double expected) {
    check_close(std::string("motion: ") + name,
                table.numbers(name)[0],
                expected,
                1e-12 * std::abs(expected));
    check(std::string("motion: unit of ") + name, table.column(name).unit == unit);
  };
  close("time", "s", .01);
  close("position", "mesh cycles", 3.25);
  close("dte", "arcsec", 4 - ratio * 7);
  close("mesh force", "N", 9e5 / 90);
  close("contact torque on the gear", "N m", 900);
  close("axial", "um", 5);
  close("tilt", "arcsec", 6);
  close("energy error", "mJ", .7);
}

void response_table()
{
  const LumpedModel model(linear_pair());
  Table             table = make_resonance_response_table();
  add_response("down", 100 * pi, model.pair().driver_teeth, made_up_response(), table);
  check("response: direction", table.column("direction").texts[0] == "down");
  const auto close = [&table](const char *name, const double expected) {
    check_close(std::string("response: ") + name,
                table.numbers(name)[0],
                expected,
                1e-12 * expected);
  };
  close("speed", 3000);              // rpm
  close("mesh frequency", 50. * 27); // Hz
  close("mean dte", 11);             // arcsec
  close("rms dte", 12);
  close("peak to peak dte", 13);
  close("mean force", 14);
  close("rms force", 15);
  close("peak to peak force", 16);
  close("largest force", 17);
  close("losses of contact", 18);
  close("time without contact", .19);
  close("time on coast flanks", .2);
  close("energy error", .21);
}

/** A quasi-static pair follows its equilibrium: figures of u(x) and of k(x) alone. */
void slow_response()
{
  LumpedPair pair         = linear_pair();
  pair.damping_ratio      = .1;
  pair.law.unloaded_error = FourierSeries(0., {2 * arcsecond}, {});
  const LumpedModel model(pair);
  LumpedSolver      solver(model, exact_run(2, 2, 64));
  // A 10,000th of the swing's frequency: forces of inertia are 1e-8 of those of the mesh.
  const LumpedResponse r = solver.run(1e-4 * model.swing_rate() / (2 * pi));
  // theta = u(x) - T/k; samples meet the crests.
  check_close("slow: mean error [arcsec]",
              r.mean_error / arcsecond,
              -8e5 / 2.2e9 / arcsecond,
              1e-5);
  check_close("slow: rms error [arcsec]", r.rms_error / arcsecond, std::sqrt(2.), 1e-5);
  check_close("slow: peak to peak error [arcsec]", r.pp_error / arcsecond, 4., 1e-5);
  check_close("slow: mean force [N]", r.mean_force, 8e5 / 90, 1e-3);
  check_close("slow: largest force [N]", r.largest_force, 8e5 / 90, 1e-1);
  check_below("slow: peak to peak force [N]", r.pp_force, 1e-1);
  check("slow: flanks stay together", r.losses == 0 && r.time_apart == 0 && r.time_coast == 0);
}

int main()
{
  return run_parts({equations, stiffness_and_damping, motion_table, response_table, slow_response});
}
