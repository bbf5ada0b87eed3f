// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// Stiffness of the contact at the master's nodes under slaves of any fineness, placed at random:
// never beyond the bound that the stable step counts with, and near it at the worst place.
#include "../parts.h"
#include "../tests.h"
#include "surfaces.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include <sstream>

using namespace test_surfaces;

constexpr double       depth = 0.01, penalty = 1000.; // [mm], [N/mm^3]
constexpr unsigned int n_placements = 2000;

/** The bound is that of parallel facets; turned ones exceed it by less than this. */
constexpr double turned_excess = 1.2;

ContactOptions make_options(const ContactDiscretization discretization,
                            const double                edge_fading = 0.)
{
  ContactOptions options;
  options.discretization = discretization;
  options.surface        = ContactSurfaceKind::flat_facets;
  options.edge_fading    = edge_fading;
  options.depth_limit    = 10. * depth;
  options.penalty.value  = penalty;
  return options;
}

/** A plane slave of n x m facets over a master of 12 x 12 facets of 1 mm. */
struct Planes
{
  MovingSurface slave, master;
  Contact       contact;

  Planes(const Vector2 &facet, const unsigned int n, const ContactOptions &options)
    : slave(plane(n, n, 0., n * facet[0], 0., n * facet[1], 0., true))
    , master(plane(12, 12, 0., 12., 0., 12., 0.))
    , contact(slave.surface, master.surface, options)
  {
  }

  std::vector<ContactSpring> press(const double angle, const Vector2 &place)
  {
    slave.place({Eigen::AngleAxisd(angle, Vector3::UnitZ()).toRotationMatrix(),
                 Vector3(place[0], place[1], -depth)});
    contact.find_candidates(slave.body, master.body, 1.);
    add_forces(contact, slave, master);
    return contact.springs();
  }
};

/** Largest carried area over the bound, of the nodes of the master and of the slave. */
std::pair<double, double>
largest_loads(Planes &planes, const double largest_angle, std::mt19937 &random)
{
  std::uniform_real_distribution<double> any(0., 1.);
  const auto                             bounds = planes.contact.node_springs().carried_areas();
  const std::vector<double>              slave_bounds = bounds[0], master_bounds = bounds[1];
  std::pair<double, double>              largest = {0., 0.};
  for (unsigned int i = 0; i < n_placements; ++i)
    {
      std::vector<double> on_slave(slave_bounds.size(), 0.), on_master(master_bounds.size(), 0.);
      for (const ContactSpring &s :
           planes.press(largest_angle * any(random), {2. + any(random), 2. + any(random)}))
        {
          const double stiffness = s.stiffness * s.direction.squaredNorm();
          for (unsigned int k = 0; k < 4; ++k)
            {
              (s.swapped ? on_master : on_slave)[s.slave_nodes[k]] +=
                s.slave_weights[k] * stiffness / penalty;
              (s.swapped ? on_slave : on_master)[s.master_nodes[k]] +=
                s.master_weights[k] * stiffness / penalty;
            }
        }
      for (std::size_t k = 0; k < on_master.size(); ++k)
        raise_to(largest.first, on_master[k] / master_bounds[k]);
      for (std::size_t k = 0; k < on_slave.size(); ++k)
        raise_to(largest.second, on_slave[k] / slave_bounds[k]);
    }
  return largest;
}

void bounds()
{
  std::mt19937 random(7);
  for (const Vector2 &facet : {Vector2(0.7, 0.7),
                               Vector2(1., 1.),
                               Vector2(1.4, 1.4),
                               Vector2(2.5, 2.5),
                               Vector2(6., 1.),
                               Vector2(6., 6.)})
    for (const bool turned : {false, true})
      {
        Planes planes(facet,
                      facet[1] > 5. ? 1 : 3,
                      make_options(ContactDiscretization::surface_points));
        const auto [load, unused] = largest_loads(planes, turned ? pi : 0., random);
        std::ostringstream name;
        name << "slave " << facet.transpose() << (turned ? " turned" : " parallel")
             << ": master's nodes ";
        check(name.str() + "within the bound", load <= (turned ? turned_excess : 1. + 1e-9));
        if (!turned)
          check(name.str() + "near it at the worst place", load > 0.9);
      }
  for (const double width : {1., 2.5})
    {
      Planes             planes(Vector2(width, width),
                    3,
                    make_options(ContactDiscretization::surface_points, 0.15));
      std::ostringstream name;
      name << "edges fade, slave " << width << ": ";
      const double load = largest_loads(planes, pi, random).first;
      check(name.str() + "within the bound", load <= turned_excess);
    }
  for (const auto discretization : {ContactDiscretization::two_pass, ContactDiscretization::nodes})
    {
      Planes planes(Vector2(2.5, 2.5), 3, make_options(discretization));
      const auto [master, slave] = largest_loads(planes, pi, random);
      const std::string name     = word_of(discretization, contact_discretizations()) + ": ";
      check(name + "master's nodes within the bound", master <= turned_excess);
      check(name + "slave's nodes within the bound", slave <= turned_excess);
    }
}

/** Bounds of two passes at the bodies' start are the mean of both single passes' there, and not
 * those of any direction. */
void check_places()
{
  // The long sides of the facets lie along each other; across, the nodes would have more.
  const FacetSurface slave  = plane(3, 3, 0., 5.1, 0., 7.5, 0., true),
                     master = plane(12, 4, 0., 12., 0., 12., 0.);
  const auto options        = make_options(ContactDiscretization::surface_points);
  Contact    one(slave, master, options), other(master, slave, options),
    both(slave, master, make_options(ContactDiscretization::two_pass));
  RigidMotion motion;
  motion.rotation     = rotation_about(Vector3::UnitZ(), 0.1);
  motion.translation  = Vector3(3., 3., 0.);
  const auto anywhere = both.node_springs().carried_areas()[1];
  one.place(motion, {});
  other.place({}, motion);
  both.place(motion, {});
  const auto compare = [](const std::string         &name,
                          const std::vector<double> &mean,
                          const std::vector<double> &one,
                          const std::vector<double> &other) {
    double worst = 0.;
    for (std::size_t i = 0; i < mean.size(); ++i)
      raise_to(worst, std::abs(mean[i] - (one[i] + other[i]) / 2.));
    check_below("two passes at their start: " + name, worst, 1e-13);
  };
  compare("slave's nodes",
          both.node_springs().carried_areas()[0],
          one.node_springs().carried_areas()[0],
          other.node_springs().carried_areas()[1]);
  compare("master's nodes",
          both.node_springs().carried_areas()[1],
          one.node_springs().carried_areas()[1],
          other.node_springs().carried_areas()[0]);
  check("two passes at their start: the direction counts",
        both.node_springs().carried_areas()[1] != anywhere);
}

/** Largest square of the frequency of free nodes on the springs alone. */
double largest_square(const std::vector<ContactSpring> &springs,
                      const std::vector<double>        &slave_masses,
                      const std::vector<double>        &master_masses)
{
  // Directions are all the same: one unknown a node.
  const Eigen::Index n = slave_masses.size();
  Eigen::MatrixXd    K = Eigen::MatrixXd::Zero(n + master_masses.size(), n + master_masses.size());
  for (const ContactSpring &s : springs)
    {
      Eigen::VectorXd b = Eigen::VectorXd::Zero(K.rows());
      for (unsigned int k = 0; k < 4; ++k)
        {
          b[s.slave_nodes[k]] += s.slave_weights[k];
          b[n + s.master_nodes[k]] -= s.master_weights[k];
        }
      K += s.stiffness * b * b.transpose();
    }
  for (Eigen::Index i = 0; i < K.rows(); ++i)
    {
      const double scale = 1. / std::sqrt(i < n ? slave_masses[i] : master_masses[i - n]);
      K.row(i) *= scale;
      K.col(i) *= scale;
    }
  return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(K, Eigen::EigenvaluesOnly)
    .eigenvalues()
    .maxCoeff();
}

void frequencies()
{
  // Masses of a layer of cells as thick as the facets are wide, half of it at the surface.
  const auto masses = [](const std::vector<double> &areas, const double width) {
    std::vector<double> masses = areas;
    for (double &m : masses)
      m *= 7.85e-9 * width / 2.;
    return masses;
  };
  for (const double width : {0.5, 1., 2.5, 6.})
    {
      Planes            planes(Vector2(width, width),
                    width > 5. ? 1 : 3,
                    make_options(ContactDiscretization::surface_points));
      const NodeSprings springs = planes.contact.node_springs();
      const auto        slave   = masses(springs.slave_areas(), width),
                 master         = masses(springs.master_areas(), 1.);
      const double bound        = 2. * penalty / springs.carried_mass_per_area(slave, master);
      double       square       = 0.;
      // Anywhere inside, and with the heaviest point of a facet on the master's corner.
      for (const double place : {3., 3.1, 3.25, 3.5, 1e-6 - 0.5 * width})
        raise_to(square, largest_square(planes.press(0., {place, place}), slave, master));
      std::ostringstream name;
      name << "slave of " << width << " mm: ";
      check(name.str() + "square of the frequency within the bound", square <= bound);
      check(name.str() + "and above a third of it", square > bound / 3.);
    }
}

int main()
{
  return run_parts({bounds, frequencies, check_places});
}
