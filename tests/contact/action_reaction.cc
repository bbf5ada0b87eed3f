// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// Forces on both surfaces balance in force and moment for random states, with damping and friction;
// shares of the points add up; nothing is dissipated in a common rigid motion.
#include "../tests.h"
#include "surfaces.h"

using namespace test_surfaces;

std::mt19937 random_engine(2);

double uniform(const double a, const double b)
{
  return std::uniform_real_distribution<double>(a, b)(random_engine);
}

Vector3 random_vector(const double size)
{
  return Vector3(uniform(-size, size), uniform(-size, size), uniform(-size, size));
}

/** Two caps pressed 20 um into each other away from the origin, nodes displaced by up to 5 um,
 * random velocities. */
void random_state(MovingSurface &slave, MovingSurface &master, const double depth = 0.02)
{
  RigidMotion common;
  common.rotation    = rotation_about(random_vector(1.).normalized(), uniform(0., 3.));
  common.translation = random_vector(100.);
  RigidMotion above;
  above.rotation       = rotation_about(random_vector(1.).normalized(), 0.02);
  above.translation    = Vector3(uniform(-2., 2.), uniform(-2., 2.), 0.);
  above.translation[2] = std::sqrt(80. * 80. - above.translation.squaredNorm()) - depth;
  above.translation    = common(above.translation);
  above.rotation       = common.rotation * above.rotation;
  slave.place(above);
  master.place(common);
  for (auto *surface : {&slave, &master})
    {
      surface->clear_forces();
      for (double &x : surface->positions)
        x += uniform(-0.005, 0.005);
      for (double &v : surface->velocities)
        v = uniform(-1000., 1000.);
    }
}

ContactOptions hard_options()
{
  ContactOptions options       = with_penalty(1e6);
  options.damping_ratio        = 0.2;
  options.friction.coefficient = 0.3;
  return options;
}

void check_balance(const std::string    &name,
                   const ContactOptions &options,
                   const double          depth = 0.02)
{
  MovingSurface slave(sphere_patch_down(30., 0.12, 7)), master(sphere_patch(50., 0.1, 6));
  double        force_error = 0., moment_error = 0., result_error = 0., least_power = 0.;
  bool          touching = true;
  for (unsigned int trial = 0; trial < 50; ++trial)
    {
      random_state(slave, master, depth);
      Contact contact(slave.surface, master.surface, options);
      contact.set_penalty(1e6, 2e-9);
      contact.find_candidates(slave.body, master.body, 1.);
      // Points come to stick, and slide when the slave has moved on.
      add_forces(contact, slave, master);
      slave.clear_forces();
      master.clear_forces();
      const Vector3 normal = contact.results().at(0).force.normalized();
      const Vector3 way    = 0.03 * normal.cross(random_vector(1.)).normalized();
      for (std::size_t i = 0; i < slave.positions.size(); ++i)
        slave.positions[i] += way[i % 3];
      add_forces(contact, slave, master);
      const GroupPairResult &result = contact.results().at(0);
      const double           scale  = result.normal_force;
      touching                      = touching && scale > 1. && result.friction_loss > 0.;
      raise_to(force_error, (slave.force() + master.force()).norm() / scale);
      raise_to(moment_error, (slave.moment() + master.moment()).norm() / (100. * scale));
      result_error = largest_of({result_error,
                                 (slave.force() - result.force).norm() / scale,
                                 (slave.moment() - result.moment).norm() / (100. * scale)});
      least_power  = std::min({least_power, result.damping_power, result.friction_loss});
    }
  check(name + ": the surfaces touch", touching);
  // round-off of coordinates of 200 mm against the arm of 100 mm, a few hundred points
  check_below(name + ": sum of forces over the normal force", force_error, 1e-12);
  check_below(name + ": sum of moments over normal force times 100 mm", moment_error, 1e-12);
  check_below(name + ": reported resultants", result_error, 1e-12);
  check_close(name + ": dampers only dissipate", least_power, 0., 0.);
}

void check_parts()
{
  MovingSurface slave(sphere_patch_down(30., 0.12, 7)), master(sphere_patch(50., 0.1, 6));
  double        error = 0., result_error = 0.;
  for (const auto discretization :
       {ContactDiscretization::surface_points, ContactDiscretization::two_pass})
    {
      random_state(slave, master);
      ContactOptions options = hard_options();
      options.discretization = discretization;
      Contact whole(slave.surface, master.surface, options);
      whole.find_candidates(slave.body, master.body, 1.);
      add_forces(whole, slave, master);
      const auto            slave_forces = slave.forces, master_forces = master.forces;
      const GroupPairResult result = whole.results().at(0);
      for (const unsigned int n_ranks : {2u, 3u, 4u})
        {
          slave.clear_forces();
          master.clear_forces();
          Contact shared(slave.surface, master.surface, options);
          shared.find_candidates(slave.body, master.body, 1.);
          GroupPairResult sum;
          for (unsigned int rank = 0; rank < n_ranks; ++rank)
            {
              shared.set_shares({{rank, n_ranks}});
              add_forces(shared, slave, master);
              sum.force += shared.results()[0].force;
              sum.moment += shared.results()[0].moment;
              sum.energy += shared.results()[0].energy;
              sum.area += shared.results()[0].area;
            }
          const double largest = largest_size(slave_forces);
          for (unsigned int i = 0; i < slave_forces.size(); ++i)
            raise_to(error, std::abs(slave.forces[i] - slave_forces[i]) / largest);
          for (unsigned int i = 0; i < master_forces.size(); ++i)
            raise_to(error, std::abs(master.forces[i] - master_forces[i]) / largest);
          result_error =
            largest_of({result_error,
                        (sum.force - result.force).norm() / result.normal_force,
                        (sum.moment - result.moment).norm() / (200. * result.normal_force),
                        std::abs(sum.energy / result.energy - 1.),
                        std::abs(sum.area / result.area - 1.)});
        }
    }
  check_below("shares of 2, 3, 4 ranks add up to the whole: nodal forces", error, 1e-14);
  check_below("shares of 2, 3, 4 ranks add up to the whole: resultants", result_error, 1e-14);
}

/** What both surfaces do together changes nothing between them: with a rotation R in between,
 * forces of springs, dampers and stick are R times those before. */
void check_common_motion()
{
  MovingSurface slave(sphere_patch_down(30., 0.12, 7)), master(sphere_patch(50., 0.1, 6));
  random_state(slave, master);
  for (auto *surface : {&slave, &master})
    std::fill(surface->velocities.begin(), surface->velocities.end(), 0.);
  Contact contact(slave.surface, master.surface, hard_options());
  contact.set_penalty(1e6, 2e-9);
  contact.find_candidates(slave.body, master.body, 1.);
  // Points come to stick and are strained then, some of them until they slide.
  add_forces(contact, slave, master);
  const Vector3 normal = contact.results().at(0).force.normalized();
  const Vector3 way    = 0.001 * normal.cross(random_vector(1.)).normalized();
  for (std::size_t i = 0; i < slave.positions.size(); ++i)
    slave.positions[i] += way[i % 3];
  slave.clear_forces();
  master.clear_forces();
  add_forces(contact, slave, master);
  const auto   &result = contact.results().at(0);
  const double  scale  = result.normal_force;
  const Vector3 before = result.force, before_moment = result.moment;
  check("common rigid motion: surfaces touch", scale > 1.);
  check("common rigid motion: friction holds",
        (before - normal * normal.dot(before)).norm() > 1e-2 * scale);

  // Everything turns by 0.7 rad and goes elsewhere, and goes on doing so.
  RigidMotion common;
  common.rotation    = rotation_about(Vector3(2., -1., 3.).normalized(), 0.7);
  common.translation = Vector3(30., -20., 10.);
  const Vector3 omega(2000., -500., 700.), v0(1e4, 2e3, -5e3);
  const auto    forces_before = std::make_pair(slave.forces, master.forces);
  for (auto *surface : {&slave, &master})
    {
      surface->body.rotation    = common.rotation * surface->body.rotation;
      surface->body.translation = common(surface->body.translation);
      for (unsigned int n = 0; n < surface->surface.positions.size(); ++n)
        {
          auto x                                    = MovingSurface::at(surface->positions, n);
          x                                         = common(Vector3(x));
          MovingSurface::at(surface->velocities, n) = v0 + omega.cross(Vector3(x));
        }
      surface->clear_forces();
    }
  contact.find_candidates(slave.body, master.body, 1.);
  add_forces(contact, slave, master);
  double error = 0.;
  for (auto *surface : {&slave, &master})
    {
      const auto &old = surface == &slave ? forces_before.first : forces_before.second;
      for (unsigned int n = 0; n < surface->surface.positions.size(); ++n)
        raise_to(error,
                 (Vector3(MovingSurface::at(surface->forces, n)) -
                  common.rotation * Eigen::Map<const Vector3>(old.data() + 3 * n))
                     .norm() /
                   scale);
    }
  // Speeds of 3e5 mm/s times round-off 1e-16, and that of coordinates of 100 mm times a penalty
  // of 1e6 N/mm^3.
  check_below("common rigid motion: nodal forces turn with it", error, 1e-8);
  const auto &after = contact.results().at(0);
  check_below("common rigid motion: resultant",
              (after.force - common.rotation * before).norm() / scale,
              1e-8);
  check_below("common rigid motion: moment, over 100 mm",
              (after.moment - common.rotation * before_moment -
               common.translation.cross(common.rotation * before))
                  .norm() /
                (100. * scale),
              1e-8);
  check_below("common rigid motion: dissipation [mJ/s per N]",
              (std::abs(after.friction_loss) + std::abs(after.damping_power)) / scale,
              1e-6);
}

void check_never_adhesive()
{
  MovingSurface slave(plane(3, 3, 1., 2., 1., 2., -0.001, true)),
    master(plane(4, 4, 0., 3., 0., 3., 0.));
  ContactOptions options = hard_options();
  for (unsigned int n = 0; n < slave.surface.positions.size(); ++n)
    slave.velocities[3 * n + 2] = 1e6; // flies off
  Contact contact(slave.surface, master.surface, options);
  contact.find_candidates(slave.body, master.body, 0.5);
  add_forces(contact, slave, master);
  check_close("a damped contact does not pull", slave.force().norm(), 0., 0.);
  check_close("its penetration is reported",
              contact.results().at(0).largest_penetration,
              0.001,
              1e-15);
  for (double &v : slave.velocities)
    v = 0.;
  add_forces(contact, slave, master);
  check_close("at rest it pushes by eps g A", slave.force()[2], 1e6 * 0.001 * 1., 1e-9);
  check_close("energy eps g^2 A / 2", contact.results().at(0).energy, 0.5 * 1e6 * 1e-6, 1e-12);

  RigidMotion deep;
  deep.translation = Vector3(0., 0., -1.5 * contact.depth_limit());
  slave.place(deep);
  slave.clear_forces();
  add_forces(contact, slave, master);
  check_close("beyond the depth limit there is no contact", slave.force().norm(), 0., 0.);

  MovingSurface back(plane(3, 3, 1., 2., 1., 2., -0.001, false));
  Contact       wrong_side(back.surface, master.surface, options);
  wrong_side.find_candidates(back.body, master.body, 0.5);
  add_forces(wrong_side, back, master);
  check_close("a back side is no contact", back.force().norm(), 0., 0.);
}

int main()
{
  ContactOptions options = hard_options();
  check_balance("surface points", options);
  options.discretization = ContactDiscretization::two_pass;
  check_balance("two pass", options);
  options.discretization = ContactDiscretization::nodes;
  check_balance("nodes", options);
  options.discretization = ContactDiscretization::surface_points;
  options.surface        = ContactSurfaceKind::flat_facets;
  // the facets' sags of 22 and 31 um keep them apart unless they are pressed deeper
  check_balance("flat facets", options, 0.1);
  check_parts();
  check_common_motion();
  check_never_adhesive();
  return 0;
}
