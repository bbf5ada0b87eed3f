// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// Time of the contact per step and point; not a test, but the build target contact_benchmark.
#include "../tests.h"
#include "surfaces.h"

#include <ctime>
#include <iostream>

using namespace test_surfaces;

namespace
{
  /** The surface seen from the other side. */
  FacetSurface inside_out(FacetSurface surface)
  {
    for (auto &facet : surface.facets)
      std::swap(facet[1], facet[3]);
    for (Vector3 &n : surface.normals)
      n = -n;
    find_neighbours(surface);
    add_sphere_offsets(surface, Vector3::Zero(), 49.99, 5);
    return surface;
  }

  /** Best of several rounds of @p steps steps, each moving the slave by @p stride [mm] [ns per
   * step]. */
  double time_of_step(Contact       &contact,
                      MovingSurface &slave,
                      MovingSurface &master,
                      const double   rise,
                      const double   stride)
  {
    const unsigned int steps = 400;
    double             best  = 1e300;
    // positions beforehand: only the contact is timed
    std::vector<std::vector<double>> positions;
    std::vector<RigidMotion>         bodies;
    for (unsigned int i = 0; i < steps; ++i)
      {
        RigidMotion motion;
        motion.rotation    = rotation_about(Vector3::UnitY(), i * stride / 50.);
        motion.translation = motion.rotation * Vector3(0., 0., rise);
        slave.place(motion);
        positions.push_back(slave.positions);
        bodies.push_back(motion);
      }
    for (unsigned int round = 0; round < 7; ++round)
      {
        const std::clock_t start = std::clock(); // of this process: other jobs do not count
        for (unsigned int i = 0; i < steps; ++i)
          contact.add_forces({positions[i].data(), slave.velocities.data(), bodies[i]},
                             master.motion(),
                             5e-8,
                             slave.forces.data(),
                             master.forces.data());
        best = std::min(best, 1e9 / CLOCKS_PER_SEC * (std::clock() - start) / steps);
      }
    return best;
  }

  void run(const char  *name,
           const double damping,
           const double friction,
           const double rise,
           FacetSurface slave_surface)
  {
    MovingSurface  slave(slave_surface), master(sphere_patch(50., 0.25, 30));
    ContactOptions options;
    options.damping_ratio        = damping;
    options.friction.coefficient = friction;
    Contact contact(slave.surface, master.surface, options);
    contact.set_penalty(1e5, 2e-9);
    contact.find_candidates({Matrix3::Identity(), Vector3(0., 0., rise)}, {}, 3.);
    const double       ns    = time_of_step(contact, slave, master, rise, 5e-4);
    const std::clock_t start = std::clock();
    contact.smallest_gap(slave.motion(), master.motion(), contact.search_skin());
    const double wide = 1e6 / CLOCKS_PER_SEC * (std::clock() - start);
    std::cout << name << ": wide search " << wide << " us, " << 1e-3 * ns << " us a step, "
              << contact.n_listed_points() << " listed points, " << contact.points().size()
              << " in contact, " << ns / contact.n_listed_points() << " ns per listed point, "
              << ns / std::max<std::size_t>(1, contact.points().size())
              << " ns per point in contact" << std::endl;
  }
} // namespace

int main()
{
  // 24 x 24 slave facets of 3 x 3 points: 5184 points
  const FacetSurface shell = inside_out(sphere_patch(49.99, 0.1, 24)),
                     cap   = sphere_patch_down(30., 0.1, 24);
  run("all points in contact", 0., 0., 0., shell);
  run("all in contact, damping", 0.2, 0., 0., shell);
  run("all in contact, damping and friction", 0.2, 0.1, 0., shell);
  run("few points in contact", 0., 0., 79.99, cap);
  run("none in contact", 0., 0., 80.05, cap);
}
