// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// Contact laws: energy, pressure and tangent of every law that a user may choose belong together;
// and the contact of two surfaces with a law that the program does not have.
#include "../tests.h"
#include "exponential_law.h"
#include "surfaces.h"

using namespace test_surfaces;

constexpr double penalty = 6e5; // [N/mm^3]

PressedPoint evaluate(const MakeContactLaw make, const double penetration, const double eps)
{
  std::vector<PressedPoint> points = {{penetration, eps}};
  make(PenaltyOptions())->evaluate(points);
  return points.front();
}

/** What a contact law promises, by differences of 0.1 nm from 10 nm to 30 um of depth. */
void check_law(const std::string &name, const MakeContactLaw make)
{
  const double step           = 1e-7;
  double       pressure_error = 0., tangent_error = 0., steepest = 0., scaling = 0., before = 0.;
  bool         grows = true;
  for (double h = 1e-5; h < 0.03; h *= 1.1)
    {
      const PressedPoint here = evaluate(make, h, penalty), twice = evaluate(make, h, 2. * penalty),
                         low  = evaluate(make, h - step, penalty),
                         high = evaluate(make, h + step, penalty);
      raise_to(pressure_error,
               std::abs((high.energy - low.energy) / (2. * step) / here.pressure - 1.));
      raise_to(tangent_error,
               std::abs((high.pressure - low.pressure) / (2. * step) / here.tangent - 1.));
      raise_to(steepest, here.tangent / penalty);
      scaling = largest_of({scaling,
                            std::abs(twice.pressure / here.pressure - 2.),
                            std::abs(twice.energy / here.energy - 2.),
                            std::abs(twice.tangent / here.tangent - 2.)});
      grows   = grows && here.pressure > before;
      before  = here.pressure;
    }
  const PressedPoint none = evaluate(make, 0., penalty);
  check(name + ": nothing at no penetration", none.pressure == 0. && none.energy == 0.);
  check(name + ": the pressure grows with the penetration", grows);
  // Of differences: the third derivative, and round-off of the energy of 30 um
  check_below(name + ": pressure against the slope of the energy", pressure_error, 1e-6);
  check_below(name + ": tangent against the slope of the pressure", tangent_error, 1e-6);
  check(name + ": the slope stays within the penalty", steepest <= 1. + 1e-14);
  check_below(name + ": proportional to the penalty", scaling, 1e-12);
}

ContactOptions exponential_options()
{
  ContactOptions options = with_penalty(penalty);
  options.penalty.law    = &make_contact_law<ExponentialLaw>;
  options.depth_limit    = 0.5;
  return options;
}

/** Parallel planes: the pressure is that of the law all over 1 mm^2. */
void check_planes()
{
  for (const double depth : {1e-3, 5e-3, 2e-2})
    {
      MovingSurface slave(plane(2, 2, -0.5, 0.5, -0.5, 0.5, -depth, true)),
        master(plane(4, 4, -1., 1., -1., 1., 0.));
      Contact contact(slave.surface, master.surface, exponential_options());
      contact.find_candidates(slave.body, master.body, 0.5);
      add_forces(contact, slave, master);
      double stiffness = 0.;
      for (const ContactSpring &spring : contact.springs())
        stiffness += spring.stiffness * spring.direction[2] * spring.direction[2];
      const PressedPoint expected = evaluate(&make_contact_law<ExponentialLaw>, depth, penalty);
      const std::string  name =
        "planes " + std::to_string(static_cast<int>(1e3 * depth + 0.5)) + " um deep: ";
      check_ratio(name + "force", slave.force()[2] / expected.pressure, 1e-12);
      check_ratio(name + "energy", contact.results().at(0).energy / expected.energy, 1e-12);
      check_ratio(name + "tangent", stiffness / expected.tangent, 1e-12);
    }
}

/** Work of the contact forces along a closed path against the energy: the force is its slope. */
void check_path(const std::string                              &name,
                const FacetSurface                             &slave,
                const FacetSurface                             &master,
                const std::function<RigidMotion(double angle)> &path,
                const double                                    bound)
{
  check_below(name + ": work against the change of energy",
              find_energy_residual(slave, master, exponential_options(), path, 50),
              bound);
}

int main()
{
  for (const auto &law : contact_laws())
    check_law(law.first, law.second);
  check_law("exponential", &make_contact_law<ExponentialLaw>);
  check_planes();

  check_path(
    "spheres",
    sphere_patch_down(30., 0.1, 10),
    sphere_patch(50., 0.25, 10),
    [](const double t) {
      RigidMotion motion;
      motion.rotation = rotation_about(Vector3::UnitY(), 0.05 * std::sin(t)) *
                        rotation_about(Vector3::UnitX(), 0.04 * std::sin(2. * t));
      motion.translation = motion.rotation * Vector3(0., 0., 79.98 - 0.01 * std::cos(3. * t));
      return motion;
    },
    1e-5);
  // A small facet leaves a plane over its edge, where the weight of its point fades.
  check_path(
    "fading edge",
    plane(1, 1, -0.01, 0.01, 1.9, 2.1, 0., true),
    plane(2, 2, -1., 1., 1., 3., 0.),
    [](const double t) {
      RigidMotion motion;
      motion.translation = Vector3(0.9 + 0.15 * std::sin(t), 0., -0.01 - 0.008 * std::cos(t));
      return motion;
    },
    1e-5);
  return 0;
}
