// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// What is said of made-up vibrations of a ring of 12 sectors: waves, their sense, their shares in
// the kinetic energy. All sums over 12 sectors are closed forms: cos^2 and sin^2 of h alpha have
// the mean 1/2, products of unlike waves have none.
#include "../parts.h"
#include "../tests.h"

#include <vfife/base/types.h>
#include <vfife/fem/modes/mode_description.h>
#include <vfife/mesh/primitives/primitives.h>

#include <functional>

using namespace vfife;

/** r, theta, z about the axis of rotation. */
struct Components
{
  Complex r, theta, z;
};

constexpr double inner = 10, outer = 20;
const Complex    i(0., 1.);

Model make_model(const double sense)
{
  Model model;
  Body  ring("ring", make_ring(inner, outer, 3., {{8, 12, 1}}), Material());
  ring.placement.rotation    = rotation_about(Vector3(1., 2., -1.).normalized(), 1.);
  ring.placement.translation = Vector3(7., -5., 3.);
  ring.axis = {ring.placement(Vector3(0., 0., 11.)), sense * ring.placement.rotation.col(2)};
  model.add_body(std::move(ring));
  return model;
}

/** Of the shape whose components are @p shape of the angle about the axis and the radius from 0
 * (inside) to 1. */
ModeDescription describe(const std::function<Components(double, double)> &shape,
                         const double                                     sense = 1.)
{
  const Model         model = make_model(sense);
  const FemSpace      d(model, {0}, FemElement::incompatible_modes);
  const Axis         &axis = model.bodies[0].axis;
  const Vector3       e1 = axis.direction.unitOrthogonal(), e2 = axis.direction.cross(e1);
  std::vector<double> real, imaginary;
  for (const Vector3 &x : d.points())
    {
      const Vector3 r         = x - axis.point;
      const double  alpha     = std::atan2(r.dot(e2), r.dot(e1)),
                   radius     = std::hypot(r.dot(e1), r.dot(e2));
      const Components u      = shape(alpha, (radius - inner) / (outer - inner));
      const Vector3    radial = std::cos(alpha) * e1 + std::sin(alpha) * e2,
                    around    = axis.direction.cross(radial);
      for (unsigned int c = 0; c < 3; ++c)
        {
          const Complex value = u.r * radial[c] + u.theta * around[c] + u.z * axis.direction[c];
          real.push_back(value.real());
          imaginary.push_back(value.imag());
        }
    }
  return ModeDescriber(d, d.parts()[0]).describe(real, imaginary);
}

void waves()
{
  for (const double sense : {1., -1.})
    {
      // cos(2 alpha - omega t) is the real part of exp(-2 i alpha) exp(i omega t).
      const auto with = describe(
        [](const double alpha, double) {
          return Components{0., 0., std::exp(-2. * i * alpha)};
        },
        sense);
      check("with the axis: two diameters, a pair", with.nodal_diameter == 2 && with.is_pair);
      check_ratio("with the axis: forward", with.forward, 1e-13);
      // Amplitudes 2 with and 1 against: energies as 4 to 1.
      const auto mixed = describe(
        [](const double alpha, double) {
          return Components{0., 0., 2. * std::exp(-2. * i * alpha) + std::exp(2. * i * alpha)};
        },
        sense);
      check_close("mixed: forward", mixed.forward, .8, 1e-13);
    }
  const auto standing = describe([](const double alpha, double) {
    return Components{0., 0., std::cos(2 * alpha + .3)};
  });
  check_close("standing: half of it", standing.forward, .5, 1e-13);
  const auto umbrella = describe([](double, double) { return Components{0., 0., 1.}; });
  check("umbrella: alone",
        umbrella.nodal_diameter == 0 && !umbrella.is_pair && umbrella.forward == .5);
  const auto highest = describe([](const double alpha, double) {
    return Components{0., 0., std::cos(6 * alpha + 1.)};
  });
  check("half the sectors: alone", highest.nodal_diameter == 6 && !highest.is_pair);
  // Two unlike waves, energies as 9 to 16.
  const auto sum = describe([](const double alpha, double) {
    return Components{0., 0., 3. * std::cos(2 * alpha) + 4. * std::sin(3 * alpha + .2)};
  });
  check("two waves: the stronger one", sum.nodal_diameter == 3);
  check_close("two waves: its share", sum.share, 16. / 25., 1e-13);
}

void directions()
{
  // Radial, tangential and axial energies as 1 to 4 to 9, at rest and in one travelling wave.
  const auto check_shares = [](const std::string &name, const ModeDescription &d) {
    check_close(name + ": radial", d.radial, 1. / 14., 1e-13);
    check_close(name + ": tangential", d.tangential, 4. / 14., 1e-13);
    check_close(name + ": axial", d.axial, 9. / 14., 1e-13);
  };
  check_shares(
    "standing", describe([](const double alpha, double) {
      return Components{std::cos(2 * alpha), 2. * std::sin(2 * alpha), 3. * std::cos(2 * alpha)};
    }));
  check_shares("travelling", describe([](const double alpha, double) {
                 const Complex wave = std::exp(-2. * i * alpha);
                 return Components{wave, 2. * i * wave, -3. * wave};
               }));
  // Radial motion a quarter of a period after the axial one: energies as 9 to 1.
  const auto later = describe([](const double alpha, double) {
    return Components{3. * i * std::cos(2 * alpha), 0., std::cos(2 * alpha)};
  });
  check_close("one after the other: radial", later.radial, .9, 1e-13);
  check_close("one after the other: axial", later.axial, .1, 1e-13);
}

void circles()
{
  for (const int n : {0, 1, 2})
    {
      // cos(n pi rho) changes its sign n times from the inside to the outside.
      const auto d = describe([n](const double alpha, const double rho) {
        return Components{.1 * std::cos(3 * alpha),
                          0.,
                          std::cos(n * pi * rho) * std::cos(3 * alpha + .4)};
      });
      check("nodal circles: " + std::to_string(n), d.nodal_circles == n);
      // Waves in either direction, most of them axial; the other one is a hundred-thousandth.
      for (const double side : {1., -1.})
        {
          const auto wave = describe([n, side](const double alpha, const double rho) {
            const Complex other = 1e-5 * std::cos(5 * pi * rho) * std::exp(-3. * side * i * alpha),
                          own   = std::exp(3. * side * i * alpha);
            return Components{.1 * own, .2 * i * own, std::cos(n * pi * rho) * own + other};
          });
          check("of a travelling wave", wave.nodal_circles == n);
        }
    }
}

void no_sectors()
{
  Model model;
  model.add_body(Body("block", make_block(Vector3(3., 2., 1.), {{3, 2, 1}}), Material()));
  const FemSpace      d(model, {0}, FemElement::incompatible_modes);
  std::vector<double> shape;
  for (unsigned int n = 0; n < d.n_points(); ++n)
    for (const double u : {0., 0., 1.})
      shape.push_back(u);
  const auto description = ModeDescriber(d, d.parts()[0]).describe(shape);
  check("a block has no diameters",
        description.nodal_diameter == -1 && description.nodal_circles == -1);
  check_ratio("a block: axial", description.axial, 1e-13);
}

int main(int argc, char **argv)
{
  return run_parts(argc, argv, {waves, directions, circles, no_sectors});
}
