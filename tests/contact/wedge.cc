// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// A stiff block on a wedge with friction: it slides down with the acceleration of the closed form,
// or stays but for the creep that regularized friction has.
#include "../tests.h"
#include "surfaces.h"

#include <Eigen/Geometry>

using namespace test_surfaces;

namespace
{
  constexpr double slope = pi / 6., gravity = 9810., mass = 1e-5; // [rad], [mm/s^2], [t]
  constexpr double side = 10., penalty = 10., creep = 0.1;        // [mm], [N/mm^3], [mm/s]

  /** Velocity along the slope after @p time [s] from rest, by central differences [mm/s]. */
  double slide(const double friction, const double time, const ContactSurfaceKind surface)
  {
    ContactOptions options;
    options.surface                 = surface;
    options.penalty.from_step       = false;
    options.penalty.value           = penalty;
    options.friction_coefficient    = friction;
    options.regularization_velocity = creep;

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
      }
    return velocity.dot(turn.col(0));
  }
} // namespace

int main()
{
  for (const auto surface : {ContactSurfaceKind::true_flank, ContactSurfaceKind::flat_facets})
    {
      const std::string name = word_of(surface, contact_surface_kinds()) + ": ";
      const double      time = 0.03;
      // Regularized friction is missing below its velocity: mu cos/(sin - mu cos) creep, 0.05 mm/s
      // of 100 here.
      check_close(name + "slides, velocity over closed form",
                  slide(0.2, time, surface) /
                    (gravity * time * (std::sin(slope) - 0.2 * std::cos(slope))),
                  1.,
                  1e-3);
      // mu v/sqrt(v^2 + creep^2) = tan(slope)
      const double rest = creep / std::sqrt(std::pow(0.7 / std::tan(slope), 2) - 1.);
      check_close(name + "stays, creep over closed form",
                  slide(0.7, 0.003, surface) / rest,
                  1.,
                  1e-3);
    }
}
