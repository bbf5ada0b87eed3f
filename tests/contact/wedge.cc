// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// A stiff block on a wedge with friction: it slides down with the acceleration of the closed form,
// or stays, swinging on the elastic stick.
#include "../tests.h"
#include "surfaces.h"

#include <Eigen/Geometry>

using namespace test_surfaces;

constexpr double slope = pi / 6., gravity = 9810., mass = 1e-5; // [rad], [mm/s^2], [t]
constexpr double side = 10., penalty = 10.;                     // [mm], [N/mm^3]

struct Slide
{
  double velocity = 0., way = 0.; ///< along the slope at the end [mm/s], the longest one [mm]
};

/** What the block does in @p time [s] from rest, by central differences. */
Slide slide(const double friction, const double time, const ContactSurfaceKind surface)
{
  ContactOptions options;
  options.surface              = surface;
  options.penalty.value        = penalty;
  options.friction.coefficient = friction;

  MovingSurface block(plane(2, 2, -0.5 * side, 0.5 * side, -0.5 * side, 0.5 * side, 0., true));
  MovingSurface wedge(plane(9, 5, -20., 40., -15., 15., 0.));
  const Matrix3 turn =
    Eigen::AngleAxisd(slope, Vector3::UnitY()).toRotationMatrix(); // x points down the slope
  wedge.place({turn, Vector3::Zero()});

  Contact contact(block.surface, wedge.surface, options);
  contact.set_penalty(penalty, mass / (side * side));
  const double dt = 1e-6;
  // Starts at rest, pressed in by its weight.
  Vector3 position = -turn.col(2) * mass * gravity * std::cos(slope) / (penalty * side * side);
  Vector3 velocity = Vector3::Zero();
  Slide   result;
  for (unsigned int step = 0; step < time / dt; ++step)
    {
      block.place({turn, position});
      for (std::size_t i = 0; i < block.velocities.size(); ++i)
        block.velocities[i] = velocity[i % 3];
      if (step % 1000 == 0) // on less than a millimetre
        contact.find_candidates(block.body, wedge.body, 1. + contact.search_skin());
      block.clear_forces();
      add_forces(contact, block, wedge, dt);
      velocity += dt * (block.force() / mass - gravity * Vector3::UnitZ());
      position += dt * velocity;
      result.way = std::max(result.way, position.dot(turn.col(0)));
    }
  result.velocity = velocity.dot(turn.col(0));
  return result;
}

int main()
{
  for (const auto surface : {ContactSurfaceKind::true_flank, ContactSurfaceKind::flat_facets})
    {
      const std::string name = word_of(surface, contact_surface_kinds()) + ": ";
      const double      time = 0.03;
      // Friction is less than its limit while the spring is stretched to it: 0.1 mm/s of 96.
      check_ratio(name + "slides, velocity over closed form",
                  slide(0.2, time, surface).velocity /
                    (gravity * time * (std::sin(slope) - 0.2 * std::cos(slope))),
                  2e-3);
      // From rest it swings between 0 and twice the elastic displacement m g sin/k.
      const double rest = mass * gravity * std::sin(slope) / (penalty * side * side);
      check_ratio(name + "stays, longest way over the swing's",
                  slide(1.2, 0.01, surface).way / (2. * rest),
                  1e-3);
    }
  return 0;
}
