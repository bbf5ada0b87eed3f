// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// Amplitudes by orders from run-ups: of given amplitudes, and of an oscillator that a force of one
// order drives through its resonance, against its response with the first effect of the sweep.
#include "../history_of.h"
#include "../refusal.h"
#include "../tests.h"

#include <vfife/base/text/column_names.h>
#include <vfife/base/text/table.h>
#include <vfife/base/types.h>
#include <vfife/model/transmission.h>
#include <vfife/output/measures/order_tracking.h>

#include <complex>

using namespace vfife;

/** Mesh cycles of a pair of 30 teeth at 2000 rpm that gains 2e5 rpm a second. */
Transmission make_pair()
{
  const QuantityOverTime speed = history_of("2000 + 2e5*t", "rpm");
  Transmission           pair;
  pair.driver_teeth = pair.driven_teeth = 30;
  pair.driver_rate                      = speed.start;
  pair.rate_history                     = speed.factor;
  return pair;
}

/** Orders 1 and 3 whose amplitudes do not change, a mean and a drift, 20 samples a mesh at the
 * end. */
void given_amplitudes()
{
  const Transmission pair     = make_pair();
  constexpr double   end      = .03;
  const double       interval = 1. / (20 * pair.mesh_frequency(end));
  Table              history;
  for (const char *name : {column::time, column::dte, column::rim_dte, column::contact_force_total})
    history.add_column(name, "-");
  for (double t = 0; t < end; t += interval)
    {
      const double turn = 2 * pi * pair.meshes(t);
      history.add_row({t,
                       7 * std::cos(turn + .3) + 2 * std::sin(3 * turn) - 80 - 100 * t,
                       .5 * std::sin(2 * turn),
                       9000 + 40 * std::cos(turn)});
    }
  const Table  orders = track_mesh_orders(history, pair, 4, 3);
  const double meshes = pair.meshes(history.numbers(column::time).back());
  check("rows: windows of 4 meshes in steps of 2, 3 orders",
        orders.n_rows() == 3 * static_cast<std::size_t>(std::floor((meshes - 4) / 2) + 1));
  double of_dte = 0, of_rim = 0, of_force = 0, of_speed = 0, of_place = 0;
  for (std::size_t i = 0; i < orders.n_rows(); ++i)
    {
      const double t = orders.numbers(column::time)[i], k = orders.numbers("mesh order")[i];
      const auto   value = [&](const std::string &name) {
        return orders.numbers(name + " amplitude")[i];
      };
      raise_to(of_dte, std::abs(value("dte") - (k == 1 ? 7. : k == 3 ? 2. : 0.)));
      raise_to(of_rim, std::abs(value("rim dte") - (k == 2 ? .5 : 0.)));
      raise_to(of_force, std::abs(value("contact force total") - (k == 1 ? 40. : 0.)));
      raise_to(of_speed, std::abs(orders.numbers(column::speed)[i] / (2000 + 2e5 * t) - 1));
      raise_to(of_place, std::abs(pair.meshes(t) - 2 - 2 * std::floor(i / 3.)));
    }
  // Splines between 20 samples a mesh, 7 a period of the third order at the end; the drift of 0.1
  // in a window is none of its orders.
  check_below("amplitudes of the transmission error", of_dte, .02);
  check_below("amplitudes of the rim", of_rim, 2e-3);
  check_below("amplitudes of the force", of_force, .02);
  check_below("speed at the middle of a window", of_speed, 1e-12);
  check_below("middles of the windows [mesh cycles]", of_place, 1e-9);
}

/** What is not periodic with the mesh cycle, as the swing of the pair: windows of weights 1 - cos
 * let little of it into the orders, a sin(pi d)/(pi d (1 - d^2)) for a vibration d periods a
 * window beside an order. Windows without weights let a sin(pi d)/(pi d) in, 30 times as much
 * here. */
void leakage()
{
  const Transmission pair = make_pair();
  constexpr double   end = .03, order = 2.4, a = 10;
  const double       interval = 1. / (20 * pair.mesh_frequency(end));
  Table              history;
  for (const char *name : {column::time, column::dte, column::rim_dte, column::contact_force_total})
    history.add_column(name, "-");
  for (double t = 0; t < end; t += interval)
    history.add_row({t, a * std::cos(order * 2 * pi * pair.meshes(t) + .2), 0., 0.});
  const Table orders = track_mesh_orders(history, pair, 4, 3);
  double      wrong  = 0;
  for (std::size_t i = 0; i < orders.n_rows(); ++i)
    {
      const double d = 4 * (order - orders.numbers("mesh order")[i]);
      const double expected =
        std::abs(a * std::sin(pi * d) / (pi * d * (1 - d * d))); // its mirror adds 1e-3 at most
      wrong = largest_of(wrong, std::abs(orders.numbers("dte amplitude")[i] - expected));
    }
  check("leakage: rows", orders.n_rows() >= 3);
  check_below("leakage of a vibration between the orders", wrong, .02);
}

/** A wave against the spin and one with it at orders 1 and 2, and what stands in space, whichever
 * way the sectors are counted. */
void rim_waves(const double sense)
{
  const Transmission pair     = make_pair();
  constexpr double   end      = .03;
  const double       interval = 1. / (20 * pair.mesh_frequency(end));
  Table              rim;
  for (const char *name : {column::time, "z cos 1", "z sin 1", "z cos 2", "z sin 2"})
    rim.add_column(name, "-");
  for (double t = 0; t < end; t += interval)
    {
      // In turning axes: frequencies (k z + n) and (k z - n) times the rate of the body.
      const double turn = sense * 2 * pi * pair.meshes(t) / 30;
      const auto   wave = [&](const double size, const int orders) {
        return std::polar(size, orders * turn + .3);
      };
      const std::complex<double> one = wave(3., 1),
                                 two = wave(.5, 2) + wave(4., 30 + 2) + wave(2., -60 + 2);
      rim.add_row({t, one.real(), -one.imag(), two.real(), -two.imag()});
    }
  const Table orders = track_rim_waves(rim, pair, sense, 4, 2);
  double      wrong  = 0;
  for (std::size_t i = 0; i < orders.n_rows(); ++i)
    {
      const double n = orders.numbers("nodal diameter")[i], k = orders.numbers("mesh order")[i];
      const std::string direction = orders.column("wave").texts[i];
      const double      expected  = n == 2 && k == 1 && direction == "backward"  ? 4.
                                    : n == 2 && k == 2 && direction == "forward" ? 2.
                                                                                 : 0.;
      raise_to(wrong, std::abs(orders.numbers("amplitude")[i] - expected));
    }
  check("rim: two orders, diameters and directions a window",
        orders.n_rows() > 0 && orders.n_rows() % 8 == 0);
  check_below("rim: amplitudes of waves", wrong, .01);
}

constexpr double omega = 2 * pi * 1000, ratio = .01; // of the oscillator

/** Response to exp(i w t), of the unit static one. */
std::complex<double> response(const double w)
{
  return omega * omega / std::complex<double>(omega * omega - w * w, 2 * ratio * omega * w);
}

/**
 * y'' + 2 ratio omega y' + omega^2 y = omega^2 cos psi, psi'' = 2 pi a: y = Re(A exp(i psi)), A =
 * H
 * - i/2 psi'' H'' to the first order of the sweep. Integrated in equal steps with the exact
 * motion for a force that is linear within a step.
 */
void oscillator()
{
  constexpr double first = 900, a = 60, end = 3., interval = 1. / 40000, start_up = .3;
  const auto       turns = [](const double t) { return first * t + .5 * a * t * t; };
  const auto       rate  = [](const double t) { return first + a * t; };

  // Free motion z' = s z with s = -ratio omega + i omega_d; y is the real part of particular
  // sums.
  const double               damped = omega * std::sqrt(1 - ratio * ratio);
  const std::complex<double> s(-ratio * omega, damped), grown = std::exp(s * interval);
  // z' = s z + f, y = Im z/omega_d: weights of f at both ends of the step.
  const std::complex<double> whole = (grown - 1.) / s,
                             late  = (grown - 1. - s * interval) / (s * s * interval);
  std::vector<double>  time, samples;
  std::complex<double> z = 0.;
  const auto force = [&](const double t) { return omega * omega * std::cos(2 * pi * turns(t)); };
  for (unsigned int i = 0; i * interval < end; ++i)
    {
      const double t = i * interval;
      if (t >= start_up)
        {
          time.push_back(t);
          samples.push_back(z.imag() / damped);
        }
      z = grown * z + (whole - late) * force(t) + late * force(t + interval);
    }

  const OrderTracking tracking(time, turns, rate, 20, 2);
  const auto          amplitudes = tracking.compute_amplitudes(samples);
  double              wrong = 0, without = 0, highest = 0, at_highest = 0, second = 0;
  for (std::size_t w = 0; w < amplitudes.size(); ++w)
    {
      const double               f = rate(tracking.windows()[w].centre), x = 2 * pi * f, h = 1.;
      const std::complex<double> bend =
        (response(x + h) - 2. * response(x) + response(x - h)) / (h * h);
      const double expected =
        std::abs(response(x) - std::complex<double>(0., .5) * (2 * pi * a) * bend);
      raise_to(wrong, std::abs(amplitudes[w][0] / expected - 1));
      raise_to(without, std::abs(amplitudes[w][0] / std::abs(response(x)) - 1));
      raise_to(second, amplitudes[w][1]);
      if (amplitudes[w][0] > highest)
        {
          highest    = amplitudes[w][0];
          at_highest = f;
        }
    }
  check("oscillator: many windows", amplitudes.size() > 200);
  // Windows of 20 turns are 1.2 Hz of the sweep, a sixteenth of the half-power width.
  check_below("oscillator: order 1 over the response with the sweep", wrong, .03);
  check("oscillator: the sweep is seen", without > 2 * wrong);
  check_close("oscillator: highest at [Hz]", at_highest, 1000 + .5 * 60 / (ratio * omega), 1.5);
  check_below("oscillator: nothing at order 2", second, .02 * highest);
}

void refusals()
{
  const auto one = [](const double t) { return t; };
  const auto two = [](const double) { return 1.; };
  print_refusal([&] { OrderTracking({0., 1., 2.}, one, two, 2, 1); });
  print_refusal([&] { OrderTracking({0., 1., 2., 3.}, one, two, 1, 1); });
  check("too short: no window", OrderTracking({0., 1., 2., 3.}, one, two, 4, 1).windows().empty());
}

int main()
{
  given_amplitudes();
  leakage();
  rim_waves(1.);
  rim_waves(-1.);
  oscillator();
  refusals();
  return 0;
}
