// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// Travelling waves of a reduced body at speed and the rates at which mesh orders meet them, against
// closed forms of one mode.
#include "../parts.h"
#include "../refusal.h"
#include "../tests.h"

#include <vfife/base/types.h>
#include <vfife/reduced/body_waves.h>
#include <vfife/reduced/modal_motion.h>

using namespace vfife;

constexpr double       body_rate = 700., lambda = 9e8, coupling = .3, spin = 6.;
constexpr unsigned int teeth = 40, diameters = 3;

/** One mode with K = lambda + spin (rate^2 - body_rate^2) and the Coriolis matrix i coupling. */
ReducedBody make_body()
{
  ReducedBody::Harmonic harmonic;
  harmonic.number         = diameters;
  harmonic.eigenvalues    = Eigen::VectorXd::Constant(1, lambda);
  harmonic.coriolis       = Eigen::MatrixXcd::Constant(1, 1, Complex(0., coupling));
  harmonic.spin_stiffness = Eigen::MatrixXcd::Constant(1, 1, spin);
  ReducedBody body;
  body.n_sectors = teeth;
  body.rate      = body_rate;
  body.cutoff    = 1e5;
  body.harmonics = {harmonic};
  return body;
}

double stiffness_at(const double rate)
{
  return lambda + spin * (rate * rate - body_rate * body_rate);
}

/** omega^2 + 2 rate coupling omega - K = 0. */
void frequencies()
{
  const ReducedBody body  = make_body();
  double            worst = 0, share = 0;
  bool              named = true;
  for (const double rate : {300., 700., -700.})
    for (const double sense : {1., -1.})
      {
        const std::vector<BodyWave> waves = find_waves(body, 0, rate, sense);
        named                             = named && waves.size() == 2;
        for (const BodyWave &wave : waves)
          {
            const double half = rate * coupling, K = stiffness_at(rate);
            const double root  = std::sqrt(half * half + K);
            const double omega = wave.omega > 0 ? -half + root : -half - root;
            raise_to(worst, std::abs(wave.omega / omega - 1.));
            // Crests k h alpha + omega t: against the turn where both have one sign.
            const bool backward = wave.omega * sense * rate > 0;
            named =
              named && wave.order == 1 && backward == (wave.direction == WaveDirection::backward);
            const double kinetic = omega * omega, strain = K;
            raise_to(share, std::abs(wave.kinetic_share / (kinetic / (kinetic + strain)) - 1.));
          }
      }
  check_below("frequencies", worst, 1e-12);
  check_below("kinetic over all energy", share, 1e-12);
  check("directions", named);
  check_close("at rest both waves have one frequency",
              find_waves(body, 0, 0., 1.)[0].frequency(),
              find_waves(body, 0, 0., 1.)[1].frequency(),
              1e-6);
}

/** Free motion under weak damping: its steps decay at the rate that is said. */
void decay()
{
  const ReducedBody body = make_body();
  const BodyWave    wave = find_waves(body, 0, body_rate, 1.)[0];
  const double      zeta = 200., step = 1e-5;
  ModalMotion       motion(body, body_rate, {zeta, 0.}, step);
  // A knock starts both waves; the part with the frequency of one by its mean over many periods.
  ModalForces knock = motion.no_forces();
  knock.modes[0][0] = 1e6;
  motion.advance(knock);
  const auto amplitude = [&]() {
    Complex   sum     = 0;
    const int n_steps = 4000;
    for (int k = 0; k < n_steps; ++k)
      {
        motion.advance(motion.no_forces());
        // Weighted by Hann's window: the other wave has no part in it.
        const double part = (k + .5) / n_steps;
        sum += (1. - std::cos(2. * pi * part)) * motion.coordinates(0)[0] *
               std::exp(Complex(0., -wave.omega * k * step));
      }
    return std::abs(sum);
  };
  const double first = amplitude(), second = amplitude();
  check_ratio("decay of a wave over that of its energy",
              std::log(first / second) / (4000 * step) / wave.decay_rate(zeta),
              1e-4);
}

/** K(rate) = (m^2 + 2 coupling m) rate^2 with m = +-(k z +- n) signed as the frequency. */
void meetings()
{
  const ReducedBody        body  = make_body();
  double                   worst = 0, width = 0;
  std::vector<WaveMeeting> found;
  for (const unsigned int order : {1u, 2u})
    for (const BodyWave &wave : find_waves(body, 0, body_rate, 1.))
      found.push_back(find_wave_meeting(body, wave, order, 100., 1.));
  for (const WaveMeeting &meeting : found)
    {
      const bool   backward = meeting.wave.direction == WaveDirection::backward;
      const double turns    = meeting.mesh_order * teeth + (backward ? 1. : -1.) * diameters;
      const double m        = backward ? turns : -turns;
      const double rate =
        std::sqrt((lambda - spin * body_rate * body_rate) / (m * m + 2. * coupling * m - spin));
      raise_to(worst, std::abs(meeting.rate / rate - 1.));
      // The damped wave met at rate (1 + d) has half the power where its frequency is missed by
      // its decay rate.
      const double d     = meeting.wave.damping_ratio(50.) / (1. - meeting.stiffening);
      const double at    = rate * (1. + d);
      const auto   waves = find_waves(body, 0, at, 1.);
      const double own =
        waves[0].direction == meeting.wave.direction ? waves[0].frequency() : waves[1].frequency();
      raise_to(width, std::abs((turns * at - own) / meeting.wave.decay_rate(50.) - 1.));
      check("orders of the turn", meeting.turns_order(teeth) == turns);
    }
  check_below("rates at which they meet", worst, 1e-9);
  check_below("half power at half the width", width, 1e-3);
  // The same body, its axis called by the other sense.
  ReducedBody other = body;
  other.harmonics[0].coriolis *= -1.;
  for (const WaveMeeting &meeting : found)
    for (const BodyWave &wave : find_waves(other, 0, -body_rate, -1.))
      if (wave.direction == meeting.wave.direction)
        check_close("turning the other way about a turned axis",
                    find_wave_meeting(other, wave, meeting.mesh_order, -800., -1.).rate,
                    -meeting.rate,
                    1e-6);
  BodyWave none;
  none.diameters = 5;
  print_refusal([&]() { find_wave_meeting(body, none, 1, 100., 1.); });
}

/** All sectors alike: real coordinates, one vibration and no direction. */
void umbrella()
{
  ReducedBody body               = make_body();
  body.harmonics[0].number       = 0;
  body.harmonics[0].coriolis     = Eigen::MatrixXcd::Zero(1, 1);
  const std::vector<BodyWave> at = find_waves(body, 0, 300., 1.);
  check("umbrella: one vibration", at.size() == 1 && at[0].order == 1);
  check_ratio("its frequency over the closed form",
              at[0].frequency() / std::sqrt(stiffness_at(300.)),
              1e-12);
  const WaveMeeting met = find_wave_meeting(body, at[0], 2, 300., 1.);
  check_ratio("met at twice the mesh frequency",
              met.rate /
                std::sqrt((lambda - spin * body_rate * body_rate) / (4. * teeth * teeth - spin)),
              1e-9);
}

int main()
{
  return run_parts({frequencies, decay, meetings, umbrella});
}
