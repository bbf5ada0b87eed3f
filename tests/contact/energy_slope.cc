// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// Forces of a contact are the slope of its energy in every motion of a node, and its springs the
// slope of the forces, inside a surface and over its fading edge: by central differences. Areas of
// the nodes by hand.
#include "../tests.h"
#include "exponential_law.h"
#include "surfaces.h"

#include <vfife/contact/law/linear_law.h>

using namespace test_surfaces;

constexpr double penalty = 6e5;  // [N/mm^3]
constexpr double step    = 1e-6; // of the differences [mm]

std::mt19937 random_engine(7);

double uniform(const double size)
{
  return std::uniform_real_distribution<double>(-size, size)(random_engine);
}

/** The facets' offsets in micrometres, quadratic or linear in both directions, other ones on each
 * facet: all that counts here is their slope. */
void add_offsets(FacetSurface &surface, const bool quadratic)
{
  const auto points     = gauss_lobatto_points(3);
  surface.offset_points = 3;
  for (unsigned int f = 0; f < surface.facets.size(); ++f)
    {
      surface.offset_row.push_back(f);
      const double a = uniform(2e-3), b = uniform(4e-3), c = uniform(4e-3),
                   d = quadratic ? uniform(4e-3) : 0.;
      for (const double eta : points)
        for (const double xi : points)
          surface.offsets.push_back(a + b * xi + c * eta + d * xi * eta * (1. - xi));
    }
}

/** A plane of 3 x 3 facets of about 1 mm, skewed; @p irregular: no two sides are parallel. */
FacetSurface master_plane(const bool irregular)
{
  FacetSurface surface = grid(
    3,
    3,
    [](const double u, const double v) { return Vector3(3. * u + 0.6 * v, 3. * v + 0.3 * u, 0.); },
    [](double, double) { return Vector3::UnitZ(); });
  if (irregular)
    for (Vector3 &x : surface.positions)
      x += Vector3(uniform(0.1), uniform(0.1), 0.);
  add_offsets(surface, irregular);
  return surface;
}

/** Two surfaces in contact, anywhere in space. */
struct Touch
{
  MovingSurface slave, master;
  Contact       contact;

  /** The slave's facets lie over the master at @p place, some 20 um deep, its nodes displaced. */
  Touch(const FacetSurface   &slave_surface,
        const FacetSurface   &master_surface,
        const ContactOptions &options,
        const Vector3        &place,
        const double          displaced)
    : slave(slave_surface)
    , master(master_surface)
    , contact(slave_surface, master_surface, options)
  {
    RigidMotion common;
    common.rotation    = rotation_about(Vector3(2., -1., 2.) / 3., 0.7);
    common.translation = Vector3(10., -20., 15.);
    master.place(common);
    slave.place({common.rotation, common(place)});
    for (double &x : slave.positions)
      x += uniform(displaced);
    contact.find_candidates(slave.body, master.body, 1.);
  }

  double energy()
  {
    slave.clear_forces();
    master.clear_forces();
    add_forces(contact, slave, master);
    return contact.results().at(0).energy;
  }

  /** Slope of the energy as the coordinates of @p surface move by @p way. */
  double slope(MovingSurface &surface, const std::vector<double> &way)
  {
    const std::vector<double> before = surface.positions;
    const auto                at     = [&](const double length) {
      for (std::size_t i = 0; i < way.size(); ++i)
        surface.positions[i] = before[i] + length * way[i];
      return energy();
    };
    const double result = (at(step) - at(-step)) / (2. * step);
    surface.positions   = before;
    return result;
  }

  /** One node along a direction. */
  std::vector<double>
  way_of(const MovingSurface &surface, const unsigned int node, const Vector3 &direction) const
  {
    std::vector<double> way(surface.positions.size(), 0.);
    MovingSurface::at(way, node) = direction;
    return way;
  }
};

double dot(const std::vector<double> &a, const std::vector<double> &b)
{
  double sum = 0.;
  for (std::size_t i = 0; i < a.size(); ++i)
    sum += a[i] * b[i];
  return sum;
}

ContactOptions options_of(const MakeContactLaw law, const double fading)
{
  ContactOptions options = with_penalty(penalty);
  options.penalty.law    = law;
  options.edge_fading    = fading;
  return options;
}

/** All coordinates of the slave, and those of the master along its plane (out of it the normals
 * follow the facets around a node, of which the force is not the slope). */
void check_slopes(const std::string &name, const MakeContactLaw law, const double fading)
{
  const FacetSurface slave = plane(3, 3, 0., 1.3, 0., 1.1, 0., true), master = master_plane(true);
  // Over a corner of the master, over a side of it, and inside.
  double error = 0., touched = 0.;
  for (const Vector3 &place :
       {Vector3(0., 0., -0.02), Vector3(1.2, 0.1, -0.02), Vector3(1.3, 1.2, -0.02)})
    {
      Touch touch(slave, master, options_of(law, fading), place, 0.005);
      touch.energy();
      const std::vector<double> slave_forces  = touch.slave.forces;
      const std::vector<double> master_forces = touch.master.forces;
      const double              scale         = touch.contact.results().at(0).normal_force;
      touched += scale;
      for (unsigned int n = 0; n < slave.positions.size(); ++n)
        for (unsigned int c = 0; c < 3; ++c)
          {
            const auto way = touch.way_of(touch.slave, n, Vector3::Unit(c));
            raise_to(error,
                     std::abs(dot(slave_forces, way) + touch.slope(touch.slave, way)) / scale);
          }
      const Matrix3 axes = touch.master.body.rotation;
      for (unsigned int n = 0; n < master.positions.size(); ++n)
        for (unsigned int c = 0; c < 2; ++c)
          {
            const auto way = touch.way_of(touch.master, n, axes.col(c));
            raise_to(error,
                     std::abs(dot(master_forces, way) + touch.slope(touch.master, way)) / scale);
          }
    }
  check(name + ": the surfaces touch", touched > 1000.);
  // Differences: the third derivative over the strip, (1 um/0.3 mm)^2 of 1e-3; round-off of an
  // energy of 100 mJ over 1 um.
  check_below(name + ": force less the slope of the energy, over the normal force", error, 1e-8);
}

/** A rigid facet on its way over the edge: the force along the way, until it has left. */
void check_leaving()
{
  Touch               touch(plane(1, 1, -0.1, 0.1, -0.1, 0.1, 0., true),
              plane(2, 2, -1., 1., -1., 1., 0.),
              options_of(&make_contact_law<LinearLaw>, 0.5),
              Vector3(0.3, 0.2, -0.01),
              0.);
  const Vector3       ahead = touch.master.body.rotation.col(0);
  std::vector<double> way;
  for (unsigned int n = 0; n < 4; ++n)
    way.insert(way.end(), ahead.data(), ahead.data() + 3);
  double       error = 0., largest = 0., done = 0.;
  const double first = touch.energy();
  for (unsigned int i = 0; i < 400; ++i)
    {
      // The middle of the step: 2 um, of a strip of 500 um.
      for (std::size_t k = 0; k < way.size(); ++k)
        touch.slave.positions[k] += 0.001 * way[k];
      touch.energy();
      const double force = dot(touch.slave.forces, way);
      raise_to(error, std::abs(force + touch.slope(touch.slave, way)));
      raise_to(largest, force);
      done += 0.002 * force;
      for (std::size_t k = 0; k < way.size(); ++k)
        touch.slave.positions[k] += 0.001 * way[k];
    }
  check_close("leaving: nothing is left beyond the edge", touch.energy(), 0., 0.);
  check_below("leaving: force along the way less the slope, over the largest",
              error / largest,
              1e-7);
  // eps h^2 A/2, all of which the edge gives back: it pushes outwards.
  check_ratio("leaving: energy before [mJ]", first / (0.5 * penalty * 1e-4 * 0.04), 1e-12);
  check_ratio("leaving: work of the force along the way over that energy", done / first, 1e-4);
}

/** What a spring answers to a motion of the nodes: the change of the slave's forces. */
std::vector<double> answer(const std::vector<ContactSpring> &springs,
                           const std::vector<double>        &slave_way,
                           const std::vector<double>        &master_way)
{
  std::vector<double> forces(slave_way.size(), 0.);
  for (const ContactSpring &s : springs)
    {
      Vector3 moved = Vector3::Zero();
      for (unsigned int k = 0; k < 4; ++k)
        moved +=
          s.slave_weights[k] * Eigen::Map<const Vector3>(&slave_way[3 * s.slave_nodes[k]]) -
          s.master_weights[k] * Eigen::Map<const Vector3>(&master_way[3 * s.master_nodes[k]]);
      for (unsigned int k = 0; k < 4; ++k)
        MovingSurface::at(forces, s.slave_nodes[k]) -=
          s.stiffness * s.slave_weights[k] * s.direction.dot(moved) * s.direction;
    }
  return forces;
}

/** Inside, on a plane with offsets that are linear in each facet, the gap is linear in what moves
 * and the springs are all of the tangent. */
void check_tangent(const std::string &name, const MakeContactLaw law)
{
  Touch touch(plane(3, 3, 0., 1.3, 0., 1.1, 0., true),
              master_plane(false),
              options_of(law, 0.),
              Vector3(0.9, 0.8, -0.01),
              0.005);
  touch.energy();
  const std::vector<ContactSpring> springs = touch.contact.springs();
  double                           error = 0., largest = 0.;
  const auto compare = [&](MovingSurface &surface, const std::vector<double> &way) {
    const std::vector<double> before    = surface.positions;
    const auto                forces_at = [&](const double length) {
      for (std::size_t i = 0; i < way.size(); ++i)
        surface.positions[i] = before[i] + length * way[i];
      touch.energy();
      return touch.slave.forces;
    };
    const std::vector<double> high = forces_at(step), low = forces_at(-step);
    surface.positions = before;
    const std::vector<double> none(&surface == &touch.slave ? touch.master.positions.size()
                                                            : touch.slave.positions.size(),
                                   0.);
    const std::vector<double> expected =
      &surface == &touch.slave ? answer(springs, way, none) : answer(springs, none, way);
    for (std::size_t i = 0; i < high.size(); ++i)
      {
        raise_to(error, std::abs((high[i] - low[i]) / (2. * step) - expected[i]));
        raise_to(largest, std::abs(expected[i]));
      }
  };
  for (unsigned int n = 0; n < touch.slave.surface.positions.size(); ++n)
    for (unsigned int c = 0; c < 3; ++c)
      compare(touch.slave, touch.way_of(touch.slave, n, Vector3::Unit(c)));
  // Of the master all nodes together: single ones turn the directions along their facets.
  for (unsigned int c = 0; c < 3; ++c)
    {
      std::vector<double> way(touch.master.positions.size(), 0.);
      for (std::size_t i = c; i < way.size(); i += 3)
        way[i] = 1.;
      compare(touch.master, way);
    }
  // Round-off of forces of 100 N over 1 um; the exponential law's third derivative,
  // (1e-6/2e-3)^2/6.
  check_below(name + ": springs against differences of the forces", error / largest, 1e-6);
}

/** In the strip that fades the spring's direction is the slope of g sqrt(w), by one point. */
void check_direction()
{
  double error = 0., along = 0.;
  for (const Vector3 &place :
       {Vector3(0.3, 0.25, -0.02), Vector3(1.5, 0.3, -0.02), Vector3(3.1, 2.9, -0.02)})
    {
      ContactOptions options          = options_of(&make_contact_law<LinearLaw>, 0.6);
      options.points_per_facet.number = 1;
      Touch touch(
        plane(1, 1, -0.1, 0.1, -0.1, 0.1, 0., true), master_plane(true), options, place, 0.002);
      touch.energy();
      const std::vector<ContactSpring> springs = touch.contact.springs();
      check("one spring", springs.size() == 1);
      const ContactSpring &spring = springs.at(0);
      check_ratio("its stiffness over eps A", spring.stiffness / (penalty * 0.04), 1e-12);
      // E = k (g sqrt(w))^2/2: -g sqrt(w) = sqrt(2 E/k), with the whole facet moved.
      for (unsigned int c = 0; c < 3; ++c)
        {
          const std::vector<double> before  = touch.slave.positions;
          const auto                root_at = [&](const double length) {
            for (std::size_t i = c; i < before.size(); i += 3)
              touch.slave.positions[i] = before[i] + length;
            return std::sqrt(2. * touch.energy() / spring.stiffness);
          };
          const double slope    = (root_at(step) - root_at(-step)) / (2. * step);
          touch.slave.positions = before;
          raise_to(error, std::abs(slope + spring.direction[c]));
        }
      const Vector3 normal = touch.master.body.rotation.col(2);
      raise_to(along, (spring.direction - normal.dot(spring.direction) * normal).norm());
    }
  check("in the strip a spring leans outwards", along > 0.02);
  check_below("direction of a spring against differences of sqrt(2 E/k)", error, 1e-7);
}

/** A rectangle of 2 x 3 mm and a trapezoid beside it whose side grows from 3 to 5 mm; a wall of 2
 * x 4 mm stands on the rectangle. */
void check_areas()
{
  FacetSurface surface;
  surface.name      = "by hand";
  surface.positions = {
    {0, 0, 0}, {2, 0, 0}, {2, 3, 0}, {0, 3, 0}, {4, 0, 0}, {4, 5, 0}, {2, 0, 4}, {0, 0, 4}};
  for (unsigned int n = 0; n < surface.positions.size(); ++n)
    {
      surface.nodes.push_back(n);
      surface.normals.push_back(n < 2   ? Vector3(0., std::sqrt(.5), std::sqrt(.5))
                                : n < 6 ? Vector3(0., 0., 1.)
                                        : Vector3(0., 1., 0.));
    }
  surface.facets = {{{0, 1, 2, 3}}, {{1, 4, 5, 2}}, {{0, 7, 6, 1}}};
  surface.group  = {0, 0, 0};
  find_neighbours(surface);
  const Contact contact(surface, plane(2, 2, 0., 1., 0., 2., 9., true), with_penalty(penalty));
  // Of the trapezoid's N_k (6 + 4 xi): 1/2 (3 + 2/3) on the short side, 1/2 (3 + 4/3) on the
  // long.
  const std::vector<double> expected = {
    1.5 + 2., 1.5 + 11. / 6. + 2., 1.5 + 11. / 6., 1.5, 13. / 6., 13. / 6., 2., 2.};
  double error = 0., sum = 0.;
  for (unsigned int n = 0; n < expected.size(); ++n)
    {
      raise_to(error, std::abs(contact.node_springs().slave_areas().at(n) - expected[n]));
      sum += contact.node_springs().slave_areas()[n];
    }
  check_below("areas of the nodes [mm^2]", error, 1e-14);
  check_close("their sum", sum, 6. + 8. + 8., 1e-13);
  const auto  &other = contact.node_springs().master_areas();
  const double cell  = 0.5 * 1.;
  check_close("corner of the other surface", other.at(0), 0.25 * cell, 1e-15);
  check_close("its middle", other.at(4), cell, 1e-15);
  // Masses of 2 and 3 mg a node: the least of both sides, m/A of the largest area.
  const std::vector<double> slave_masses(8, 2e-9), master_masses(9, 3e-9);
  check_ratio("least mass over area, of the slave [t/mm^2]",
              contact.node_springs().mass_per_area(slave_masses, master_masses) /
                (2e-9 / expected[1]),
              1e-14);
  check_ratio("least mass over area, of the master [t/mm^2]",
              contact.node_springs().mass_per_area(slave_masses, std::vector<double>(9, 1e-10)) /
                (1e-10 / cell),
              1e-14);
}

int main()
{
  check_slopes("linear, fading", &make_contact_law<LinearLaw>, 0.6);
  check_slopes("linear, no fading", &make_contact_law<LinearLaw>, 0.);
  check_slopes("exponential, fading", &make_contact_law<ExponentialLaw>, 0.6);
  check_leaving();
  check_tangent("linear", &make_contact_law<LinearLaw>);
  check_tangent("exponential", &make_contact_law<ExponentialLaw>);
  check_direction();
  check_areas();
  return 0;
}
