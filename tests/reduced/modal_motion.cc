// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// Steps of modes: closed forms, energy and angular momentum, whatever the step is.
#include "../parts.h"
#include "../refusal.h"
#include "../tests.h"

#include <vfife/base/errors.h>
#include <vfife/reduced/modal_motion.h>
#include <vfife/reduced/reduced_body.h>

#include <random>

using namespace vfife;

using Eigen::MatrixXcd;
using Eigen::VectorXcd;

constexpr double rate = 300.; // [rad/s]

/** Modes with h diameters; without coupling by Coriolis forces. */
ReducedBody::Harmonic make_modes(const unsigned int h, const std::vector<double> &eigenvalues)
{
  ReducedBody::Harmonic harmonic;
  const int             n = eigenvalues.size();
  harmonic.number         = h;
  harmonic.eigenvalues    = Eigen::Map<const Eigen::VectorXd>(eigenvalues.data(), n);
  harmonic.coriolis = harmonic.spin_stiffness = MatrixXcd::Zero(n, n);
  harmonic.torque                             = VectorXcd::Ones(n);
  return harmonic;
}

ReducedBody make_body(std::vector<ReducedBody::Harmonic> harmonics)
{
  ReducedBody body;
  body.n_sectors = 12;
  body.rate      = rate;
  body.harmonics = std::move(harmonics);
  return body;
}

ModalForces make_forces(const std::vector<VectorXcd> &modes, const double moment)
{
  ModalForces forces;
  forces.modes  = modes;
  forces.moment = moment;
  return forces;
}

void single_modes()
{
  // The step is far beyond what central differences allow, omega h < 2.
  const double      omega = 1e4, step = 3.7e-4;
  const ReducedBody body = make_body({make_modes(0, {omega * omega})});
  ModalMotion       free(body, rate, {}, step);
  const ModalForces force = make_forces({VectorXcd::Constant(1, 2e3)}, 0.);
  double            worst = 0;
  for (int i = 1; i <= 40; ++i)
    {
      free.advance(force);
      const double exact = 2e3 / (omega * omega) * (1. - std::cos(omega * i * step));
      raise_to(worst, std::abs(free.coordinates(0)[0] - exact) * omega * omega / 2e3);
    }
  check_below("a sudden force: closed form", worst, 1e-10);

  // c'' + zeta c' + omega^2 c = 0 from c = 1
  const double zeta = 900.;
  ModalMotion  damped(body, rate, {zeta, 0.}, step);
  damped.stand(make_forces({VectorXcd::Constant(1, omega * omega)}, 0.), 0., 0.);
  const double own = std::sqrt(omega * omega - .25 * zeta * zeta);
  for (int i = 0; i < 10; ++i)
    damped.advance(damped.no_forces());
  const double t = 10 * step;
  check_close("a damped vibration: closed form",
              damped.coordinates(0)[0].real(),
              std::exp(-.5 * zeta * t) * (std::cos(own * t) + .5 * zeta / own * std::sin(own * t)),
              1e-10);
}

void waves()
{
  // c'' + 2 i Omega gamma c' + lambda c = 0: exp(i s t), s = -Omega gamma +- root.
  ReducedBody::Harmonic two = make_modes(2, {4e7});
  two.coriolis(0, 0)        = Complex(0., .6);
  const ReducedBody body    = make_body({two});
  const double      step = 2e-4, root = std::sqrt(std::pow(.6 * rate, 2) + 4e7);
  ModalMotion       motion(body, rate, {}, step);
  // At rest with c = 1: both waves.
  motion.stand(make_forces({VectorXcd::Constant(1, 4e7)}, 0.), 0., 0.);
  const double forward = -.6 * rate + root, backward = -.6 * rate - root;
  double       worst = 0;
  for (int i = 1; i <= 20; ++i)
    {
      motion.advance(motion.no_forces());
      const double  t = i * step;
      const Complex exact =
        (backward * std::polar(1., forward * t) - forward * std::polar(1., backward * t)) /
        (backward - forward);
      raise_to(worst, std::abs(motion.coordinates(0)[0] - exact));
    }
  check_below("waves with and against the spin: closed form", worst, 1e-10);

  // Under a force that stands in space at the rate of the sectors.
  const double    sector_rate = -rate;
  const VectorXcd force       = VectorXcd::Constant(1, Complex(3e3, -1e3));
  const Complex   c           = (motion.standing_flexibility(0, sector_rate) * force)[0];
  const double    w           = 2 * sector_rate;
  check_below("what stands in space: equation of motion",
              std::abs((4e7 - w * w + Complex(0., 2. * rate * w) * two.coriolis(0, 0)) * c -
                       force[0]) /
                std::abs(force[0]),
              1e-12);
}

void other_rates()
{
  ReducedBody::Harmonic three = make_modes(3, {1e7, 5e7});
  three.spin_stiffness        = -8. * MatrixXcd::Identity(2, 2);
  const ReducedBody body      = make_body({three});
  const double      twice     = 2 * rate;
  const ModalMotion faster(body, twice, {}, 1e-5);
  const VectorXcd   force = VectorXcd::Constant(2, 1.);
  // Omega^2 has grown by three times its value.
  const VectorXcd c = faster.standing_flexibility(0, 0.) * force;
  check_ratio("stiffness at another rate", c[0].real() * (1e7 - 8. * 3 * rate * rate), 1e-12);
  check("a rate at which the body is not stable is refused",
        has_text(message_of<NumericalError>([&] { ModalMotion(body, 5 * rate, {}, 1e-5); }),
                 "not stable at 14323.9 rpm"));
}

/** Modes that breathe under a turning hub, pushed at random: what forces do is energy, and the
 * moment is angular momentum. */
void balances()
{
  ReducedBody::Harmonic zero = make_modes(0, {2e7, 9e7}), one = make_modes(1, {1e7, 3e7});
  one.coriolis << Complex(0., .3), Complex(.4, .2), Complex(-.4, .2), Complex(0., -.5);
  ReducedBody body   = make_body({zero, one});
  body.turns         = true;
  body.turn_inertia  = 28.;
  body.turn_coriolis = Eigen::Vector2d(1.3, -.4);
  ModalMotion                            motion(body, rate, {}, 3e-5);
  std::mt19937                           random(7);
  std::uniform_real_distribution<double> any(-1., 1.);
  double work = 0, momentum = 0, largest = 0, largest_momentum = 0, worst_energy = 0,
         worst_momentum = 0;
  bool came             = true;
  for (int i = 0; i < 500; ++i)
    {
      ModalForces forces = motion.no_forces();
      for (VectorXcd &modes : forces.modes)
        for (Complex &value : modes)
          value = {1e5 * any(random), &modes == &forces.modes[0] ? 0. : 1e5 * any(random)};
      forces.moment                              = 1e6 * any(random);
      const std::vector<VectorXcd> before        = {motion.coordinates(0), motion.coordinates(1)};
      const double                 turned        = motion.turn();
      const Complex                expected      = motion.expect(1, forces)[0];
      const double                 expected_turn = motion.expect_turn(forces);
      motion.advance(forces);
      came = came && expected == motion.coordinates(1)[0] && expected_turn == motion.turn();
      for (unsigned int k = 0; k < 2; ++k)
        work += forces.modes[k].dot(motion.coordinates(k) - before[k]).real();
      work += forces.moment * (motion.turn() - turned);
      momentum += forces.moment * 3e-5;
      const double energy = motion.kinetic() + motion.strain() +
                            .5 * body.turn_inertia * std::pow(motion.turn_rate(), 2);
      raise_to(largest, energy);
      raise_to(worst_energy, std::abs(energy - work));
      raise_to(worst_momentum,
               std::abs(body.turn_inertia * motion.turn_rate() + rate * motion.added_inertia() -
                        momentum));
      raise_to(largest_momentum, std::abs(momentum));
    }
  check_below("energy is the forces' work", worst_energy / largest, 1e-11);
  check_below("angular momentum is the moment's", worst_momentum / largest_momentum, 1e-11);
  check("expected is what comes", came);

  // What the end of the step has of the force there.
  ModalForces   half    = motion.no_forces();
  const Complex without = motion.expect(1, half)[1];
  half.modes[1][0]      = .5 * 7e4;
  check_below("gain: half of a force at the end of the step",
              std::abs(motion.expect(1, half)[1] - without - 7e4 * motion.gain(1)(1, 0)) /
                std::abs(7e4 * motion.gain(1)(1, 0)),
              1e-9);
}

int main()
{
  return run_parts({single_modes, waves, other_rates, balances});
}
