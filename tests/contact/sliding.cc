// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// Sliding over the facets of a sphere: the force with offsets is that of the sphere, without steps
// at the facets' edges; plain facets show their sag. Energy balance along paths. Fading at the
// edge.
#include "../tests.h"
#include "surfaces.h"

using namespace test_surfaces;

constexpr double radius = 50., penalty = 1e5;

ContactOptions options_for(const ContactSurfaceKind kind, const unsigned int points)
{
  ContactOptions options          = with_penalty(penalty);
  options.surface                 = kind;
  options.points_per_facet.number = points;
  options.depth_limit             = 0.5; // the slider of one point is smaller than its depth
  return options;
}

/** A motion that puts the pole of @p direction to a depth below the sphere of the master. */
RigidMotion over(const double angle_x, const double angle_y, const double rise)
{
  RigidMotion motion;
  motion.rotation =
    rotation_about(Vector3::UnitY(), angle_x) * rotation_about(Vector3::UnitX(), angle_y);
  motion.translation = motion.rotation * Vector3(0., 0., rise);
  return motion;
}

struct Ripple
{
  double deviation = 0.; ///< largest relative deviation from the reference force
  double step      = 0.; ///< largest relative change from one position to the next
  double spread    = 0.; ///< (largest - least)/(largest + least)
};

/**
 * Slides over 6 of 10 facets in 4000 positions at constant depth; the slider turns about its
 * centre by @p rolling times the angle, so that the contact wanders over its own facets too.
 */
Ripple slide(const FacetSurface   &slider,
             const double          rise,
             const ContactOptions &options,
             const double          reference,
             const double          rolling = 0.)
{
  MovingSurface slave(slider), master(sphere_patch(radius, 0.25, 10));
  Contact       contact(slave.surface, master.surface, options);
  Ripple        ripple;
  double        last = -1., largest = 0., least = 1e300;
  for (unsigned int i = 0; i <= 4000; ++i)
    {
      const double  angle  = -0.15 + 0.3 * i / 4000.;
      RigidMotion   motion = over(angle, 0.013 + 0.3 * angle, rise);
      const Vector3 along  = motion.rotation.col(2);
      motion.rotation =
        rotation_about(Vector3(-0.2, 1., 0.).normalized(), rolling * angle) * motion.rotation;
      slave.place(motion);
      if (i % 100 == 0)
        contact.find_candidates(slave.body, master.body, 3.);
      slave.clear_forces();
      master.clear_forces();
      add_forces(contact, slave, master);
      const double force = slave.force().dot(along);
      raise_to(ripple.deviation, std::abs(force / reference - 1.));
      if (last >= 0.)
        raise_to(ripple.step, std::abs(force - last) / reference);
      last = force;
      raise_to(largest, force);
      least = std::min(least, force);
    }
  ripple.spread = (largest - least) / (largest + least);
  return ripple;
}

void check_point()
{
  // one point 0.1 mm below the sphere: F = eps depth A, A = (20 um)^2
  FacetSurface slider  = plane(1, 1, -0.01, 0.01, -0.01, 0.01, radius - 0.1, true);
  const double force   = penalty * 0.1 * 4e-4;
  const Ripple smooth  = slide(slider, 0., options_for(ContactSurfaceKind::true_flank, 1), force);
  const Ripple faceted = slide(slider, 0., options_for(ContactSurfaceKind::flat_facets, 1), force);
  // the interpolated normal differs from the sphere's by 1e-5: depth errors of 1e-7 mm in 0.1 mm
  check_below("one point over the true surface: deviation", smooth.deviation, 5e-6);
  check_below("one point over the true surface: step", smooth.step, 5e-6);
  check("one point over flat facets sees the sag of 31 um", faceted.deviation > 0.2);
}

void check_caps()
{
  // two spheres overlapping by d: the overlap over the contact is d - r^2/(2 R), F = pi eps R d^2
  // (to d/R)
  const double reduced = 1. / (1. / 30. + 1. / radius), depth = 0.03;
  const double force = pi * penalty * reduced * depth * depth;
  const auto   cap   = sphere_patch_down(30., 0.1, 10); // facets of 0.6 mm, contact radius 1.06 mm
  const double rise  = radius + 30. - depth;
  for (const unsigned int points : {1u, 2u, 3u, 5u})
    {
      const ContactOptions options = options_for(ContactSurfaceKind::true_flank, points);
      const Ripple         sliding = slide(cap, rise, options, force);
      const Ripple         rolling = slide(cap, rise, options, force, 0.4);
      const std::string name = "cap, true surface, points per direction " + std::to_string(points);
      // the master's facets alone: only the interpolation of offsets and normals is left
      check_below(name + ": spread over the master's facets", sliding.spread, 1e-8);
      if (points == 3)
        {
          // points 0.2 mm apart integrate a pressure that ends with a kink at a radius of 1.06 mm
          check_below(name + ": spread over the slave's facets", rolling.spread, 1e-2);
          check_below(name + ": deviation from the spheres", rolling.deviation, 1e-2);
        }
    }
  const Ripple flat = slide(cap, rise, options_for(ContactSurfaceKind::flat_facets, 3), force, 0.4);
  check("cap over flat facets: far from the force of the spheres", flat.deviation > 0.2);
}

/** Work along a closed path against the energy, and fading at the border. */
void check_energy(const std::string &name, const ContactSurfaceKind kind, const double bound)
{
  const auto path = [](const double t) {
    return over(0.05 * std::sin(t),
                0.04 * std::sin(2. * t),
                radius + 30. - 0.06 - 0.02 * std::cos(3. * t));
  };
  check_below(name + ": work of the contact force against the change of energy",
              find_energy_residual(sphere_patch_down(30., 0.1, 10),
                                   sphere_patch(radius, 0.25, 10),
                                   options_for(kind, 3),
                                   path,
                                   100),
              bound);
}

void check_fading()
{
  // a small slave facet leaves a plane over its edge at x = 1
  MovingSurface slave(plane(1, 1, -0.01, 0.01, 1.9, 2.1, -0.01, true)),
    master(plane(2, 2, -1., 1., 1., 3., 0.));
  ContactOptions options = options_for(ContactSurfaceKind::true_flank, 1);
  for (const bool fading : {true, false})
    {
      options.edge_fading = fading ? 0.15 : 0.;
      Contact      contact(slave.surface, master.surface, options);
      const double full = penalty * 0.01 * 0.004;
      double       step = 0., slope_step = 0., last = full, last_slope = 0.;
      bool         none_beyond = true, all_inside = true;
      double       results = 0.;
      for (unsigned int i = 0; i <= 1000; ++i)
        {
          RigidMotion motion;
          motion.translation[0] = 0.7 + 0.4 * i / 1000.;
          slave.place(motion);
          if (i % 100 == 0)
            contact.find_candidates(slave.body, master.body, 0.5);
          slave.clear_forces();
          add_forces(contact, slave, master);
          const double force = slave.force()[2];
          raise_to(step, std::abs(force - last) / full);
          raise_to(slope_step, std::abs(force - last - last_slope) / full);
          last_slope = force - last;
          last       = force;
          // Area, energy and pressure fade as the force does, the depth does not; the slope of
          // the energy pushes the slave outwards.
          const double t    = std::clamp((1. - motion.translation[0]) / 0.15, 0., 1.),
                       part = t * t * (3. - 2. * t), slope = 6. * t * (1. - t) / 0.15;
          if (fading && part > 0.)
            {
              const GroupPairResult &result = contact.results().at(0);
              results                       = largest_of({results,
                                                          std::abs(result.area / 0.004 - part),
                                                          std::abs(result.energy / (0.5 * 0.01 * full) - part),
                                                          std::abs(result.largest_pressure / (penalty * 0.01) - part),
                                                          std::abs(result.largest_penetration / 0.01 - 1.),
                                                          std::abs(result.normal_force / full - part),
                                                          std::abs(slave.force()[0] / (0.5 * 0.01 * full) - slope)});
            }
          if (motion.translation[0] > 1. + 2e-3)
            none_beyond = none_beyond && force == 0.;
          if (motion.translation[0] < 1. - 0.15)
            all_inside = all_inside && std::abs(force / full - 1.) < 1e-12;
        }
      const std::string name = fading ? "fading edge" : "sharp edge";
      check(name + ": no force beyond", none_beyond);
      check(name + ": full force before the fading", all_inside);
      if (fading)
        {
          // 0.15 of a facet of 1 mm: slope 1.5/0.15 a mm, 0.4 um a position; curvature 6/0.15^2
          check_below("fading edge: largest step of the force", step, 1.5 / 0.15 * 4e-4 * 1.01);
          check_below("fading edge: area, energy, pressure, force less their part", results, 1e-9);
          check_below("fading edge: largest step of its slope",
                      slope_step,
                      6. / 0.0225 * 1.6e-7 * 1.01);
        }
      else
        check_ratio("sharp edge: the force jumps", step, 1e-12);
    }
}

int main()
{
  check_point();
  check_caps();
  check_energy("true surface", ContactSurfaceKind::true_flank, 1e-5);
  // averaged normals are not those of the facets: the force along the facets does the work (without
  // it 31 % were missing). It jumps at kinks, which costs the trapezoidal rule 6e-4.
  check_energy("flat facets", ContactSurfaceKind::flat_facets, 1e-3);
  check_fading();
  return 0;
}
