// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// The torsional pair under a transmission error: linear response, and with loss of contact against
// piecewise closed forms; both branches of a jump.
#include "../parts.h"
#include "../tests.h"
#include "pair.h"

#include <vfife/lumped/speed_sweep.h>

#include <complex>

using namespace vfife;

const double J = 20., k = 2.2e9, T = 8e5, w = std::sqrt(k / J), zeta = .05;

LumpedPair excited_pair(const double amplitude)
{
  LumpedPair pair         = linear_pair();
  pair.damping_ratio      = zeta;
  pair.law.backlash       = 100. * T / k;
  pair.law.unloaded_error = FourierSeries(0., {amplitude}, {});
  return pair;
}

void linear_response()
{
  const double      a = .05 * T / k;
  const LumpedModel model(excited_pair(a));
  for (const double part : {.4, .98, 1.7})
    {
      LumpedSolver               solver(model, exact_run(150, 10, 64));
      const double               W = part * w;
      const LumpedResponse       r = solver.run(W / (2 * pi));
      const std::complex<double> c(0., 2 * zeta * w * W);
      const double exact = a * std::abs((w * w + c) / (w * w - W * W + c)) / std::sqrt(2.);
      check_ratio("rms at " + std::to_string(part) + " of the swing's rate",
                  r.rms_error / exact,
                  1e-6);
      check("no loss of contact", r.losses == 0);
      check_ratio("mean force", r.mean_force * 90. / T, 1e-6);
      check_below("energy balance", r.energy_error, 1e-7);
    }
}

/** J s'' + [c s' + k s] = T - J W^2 a cos(W t), brackets in contact only; pieces in closed form,
 * their ends by bisection. */
class Pieces
{
public:
  Pieces(const double a, const double W)
    : a_(a)
    , W_(W)
  {
  }

  /** Motion at @p time after @p t with s, v there, without a change of contact. */
  void move(const bool touches, const double t, const double time, double &s, double &v) const
  {
    if (!touches)
      {
        // s'' = T/J - W^2 a cos(W t): s = ... + a cos(W t)
        const double d = time - t, v0 = v + W_ * a_ * std::sin(W_ * t),
                     s0 = s - a_ * std::cos(W_ * t);
        s               = s0 + v0 * d + .5 * T / J * d * d + a_ * std::cos(W_ * time);
        v               = v0 + T / J * d - W_ * a_ * std::sin(W_ * time);
        return;
      }
    const std::complex<double> i(0., 1.),
      H             = -W_ * W_ * a_ / (w * w - W_ * W_ + 2. * i * zeta * w * W_);
    const auto   p  = [&](const double x) { return T / k + std::real(H * std::exp(i * W_ * x)); };
    const auto   dp = [&](const double x) { return std::real(i * W_ * H * std::exp(i * W_ * x)); };
    const double wd = w * std::sqrt(1 - zeta * zeta), d = time - t;
    const double A = s - p(t), B = (v - dp(t) + zeta * w * A) / wd, e = std::exp(-zeta * w * d);
    const double C = std::cos(wd * d), S = std::sin(wd * d);
    s = p(time) + e * (A * C + B * S);
    v = dp(time) + e * (-zeta * w * (A * C + B * S) + wd * (B * C - A * S));
  }

  /** From time zero to @p end in scans of @p step. */
  void run(const double end, const double step, double &s, double &v) const
  {
    bool touches = s > 0;
    for (double t = 0; t < end - 1e-9 * step;)
      {
        double next = std::min(end, t + step), s1 = s, v1 = v;
        move(touches, t, next, s1, v1);
        if ((s1 > 0) != touches)
          {
            double low = t, high = next;
            for (unsigned int n = 0; n < 60; ++n)
              {
                const double middle = .5 * (low + high);
                s1                  = s;
                v1                  = v;
                move(touches, t, middle, s1, v1);
                ((s1 > 0) == touches ? low : high) = middle;
              }
            next = high;
            s1   = s;
            v1   = v;
            move(touches, t, next, s1, v1);
            touches = !touches;
          }
        t = next;
        s = s1;
        v = v1;
      }
  }

private:
  double a_, W_;
};

void loss_of_contact()
{
  const double      a = .3 * T / k, W = .8 * w;
  const LumpedModel model(excited_pair(a));
  LumpedSolver      solver(model, exact_run(0, 30, 64));
  Eigen::VectorXd   q(1), v(1);
  q << a - 3 * T / k; // three times the static compression
  v << 0;
  solver.set_motion(q, v);
  const Pieces         pieces(a, W);
  double               difference = 0;
  const LumpedResponse r          = solver.run(W / (2 * pi), [&](const LumpedSolver::Sample &m) {
    if (std::abs(m.position - std::round(m.position)) > 1e-6)
      return;
    double s = 3 * T / k, s_rate = 0;
    pieces.run(m.time, 1e-3 / W, s, s_rate);
    raise_to(difference, std::abs(a - m.q[0] - s) / (T / k));
  });
  check("flanks part often", r.losses >= 10);
  // Steps over kinks are of first order in their length only, and controlled to 1e-11.
  check_below("loss of contact against closed pieces", difference, 1e-6);
  check_below("its energy balance", r.energy_error, 1e-6);
}

void jump()
{
  const double      a = .2 * T / k;
  const LumpedModel model(excited_pair(a));
  SpeedSweepOptions sweep;
  sweep.kind          = SweepKind::up_and_down;
  sweep.lowest_speed  = .7 * w / 27;
  sweep.highest_speed = 1.05 * w / 27;
  sweep.n_speeds      = 36;
  Table table         = make_resonance_response_table();
  sweep_speeds(model, exact_run(100, 10, 64), sweep, table);
  const std::vector<double> &swing = table.numbers("peak to peak dte"),
                            &speed = table.numbers("speed"),
                            &apart = table.numbers("time without contact");
  // The same speeds up and down, in equal steps of the mesh frequency.
  double steps = 0;
  for (std::size_t i = 0; i < 36; ++i)
    for (const std::size_t row : {i, 71 - i})
      steps =
        largest_of({steps,
                    std::abs(speed[row] * pi / 30 * 27 / w - (.7 + .35 * i / 35)),
                    std::abs(table.numbers("mesh frequency")[row] / (speed[row] * 27 / 60) - 1)});
  check_below("speeds up and down, over the swing's", steps, 1e-12);
  double      largest = 0;
  std::size_t at      = 0;
  for (std::size_t i = 0; i < 36; ++i)
    if (swing[71 - i] - swing[i] > largest)
      {
        largest = swing[71 - i] - swing[i];
        at      = i;
      }
  const double rate = speed[at] * pi / 30 * 27;
  check("falling speed stays on the upper branch", largest > swing[at]);
  check("the upper branch has lost contact, the lower has not",
        apart[71 - at] > 0 && apart[at] == 0);
  check("a jump below the swing's rate", rate < w);
  // Lower branch: linear. Upper branch: closed pieces, led down in the same way.
  const std::complex<double> c(0., 2 * zeta * w * rate);
  const double linear = 2 * a * std::abs((w * w + c) / (w * w - rate * rate + c)) / arcsecond;
  // 64 samples a mesh miss the crest by up to (pi/64)^2/2.
  check_ratio("lower branch", swing[at] / linear, 1.3e-3);
  double s = T / k + a, s_rate = 0, lowest = 1, highest = -1;
  for (std::size_t i = 36; i-- > at;)
    {
      const double W = speed[i] * pi / 30 * 27;
      Pieces(a, W).run(2 * pi / W * 150, .05 / W, s, s_rate);
    }
  const Pieces pieces(a, rate);
  for (unsigned int n = 0; n < 400; ++n)
    {
      // Whole periods have gone by: time begins at zero again.
      double       s_n = s, v_n = s_rate;
      const double t = 2 * pi / rate * n / 400;
      pieces.run(t, .01 / rate, s_n, v_n);
      const double q = a * std::cos(rate * t) - s_n;
      lowest         = std::min(lowest, q);
      raise_to(highest, q);
    }
  check_ratio("upper branch", swing[71 - at] * arcsecond / (highest - lowest), 3e-3);
}

int main()
{
  return run_parts({linear_response, loss_of_contact, jump});
}
