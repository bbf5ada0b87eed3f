// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_fem_pair_pair_equilibrium_parts_h
#define vfife_fem_pair_pair_equilibrium_parts_h

#include <vfife/contact/contact.h>
#include <vfife/fem/pair/pair_equilibrium.h>
#include <vfife/mesh/body_mesh.h>

#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cmath>

namespace vfife
{
  constexpr unsigned int not_watched = static_cast<unsigned int>(-1);

  /** One surface of a contact pair, its nodes' places among the watched points, their motion. */
  struct PairEquilibrium::Surface
  {
    unsigned int              body;
    const FacetSurface       &facets;
    unsigned int              first_point; ///< of the body
    std::vector<unsigned int> place;       ///< among the watched points, or not_watched
    std::vector<double>       mass, positions, velocities, forces;

    Surface(const Model          &model,
            const Discretization &d,
            const unsigned int    b,
            const std::string    &name)
      : body(b)
      , facets(model.bodies[b].mesh().surfaces.at(name))
      , first_point(d.find_part(b)->first_point)
      , place(facets.nodes.size(), not_watched)
      , positions(3 * facets.nodes.size(), 0.)
      , velocities(3 * facets.nodes.size(), 0.)
      , forces(3 * facets.nodes.size(), 0.)
    {
      for (const unsigned int node : facets.nodes)
        mass.push_back(model.bodies[b].node_masses()[node]);
    }
  };

  struct PairEquilibrium::Pair
  {
    const ContactPair &definition;
    Surface            slave, master;
    Contact            contact;

    Pair(const ContactPair &pair, const Model &model, const Discretization &d, const double penalty)
      : definition(pair)
      , slave(model, d, pair.slave_body, pair.slave_surface)
      , master(model, d, pair.master_body, pair.master_surface)
      , contact(slave.facets, master.facets, pair.options)
    {
      contact.set_penalty(penalty, contact.mass_per_area(slave.mass, master.mass));
      // Newton's method is one of springs along the normals.
      contact.set_friction_mode(FrictionMode::none);
    }

    const std::vector<unsigned int> &active(const Surface &surface) const
    {
      return &surface == &slave ? contact.active_slave_nodes() : contact.active_master_nodes();
    }
    /** Undeformed flanks may be apart by this and touch under load [mm]. */
    double margin() const
    {
      return contact.search_skin() + contact.depth_limit();
    }
  };

  /** What the contact does at a trial state. */
  struct PairEquilibrium::Trial
  {
    Eigen::VectorXd force;      ///< at the watched points, axes of time zero [N]
    double          energy = 0; ///< of the contact [mJ]
    double          torque = 0; ///< on the driven body about its axis [N mm]
  };

  /** Where Newton's method is: forces taken for those of the contact, what they do, the turn. */
  struct PairEquilibrium::Iterate
  {
    Eigen::VectorXd force, deflection; ///< at the watched points
    double          turn = 0;
    Trial           trial;

    double potential(const double load) const
    {
      return 0.5 * force.dot(deflection) + trial.energy - load * turn;
    }

    /** Forces that the bodies were bent by less those that the contact then exerts, over these, or
     * what its torque lacks of the load, over the load. */
    double residual(const double load) const
    {
      return std::max((trial.force - force).norm() / trial.force.norm(),
                      std::abs((trial.torque + load) / load));
    }
  };

  /** Springs of the contact at the watched points: force = B f, f = -stiffness h. */
  struct PairEquilibrium::Tangent
  {
    std::vector<std::array<std::pair<unsigned int, Vector3>, 8>> springs; ///< place and direction
    Eigen::VectorXd                                              inverse_stiffness; ///< [mm/N]
    Eigen::VectorXd by_turn; ///< change of h with the turn of the driven body [mm/rad]
    Eigen::PartialPivLU<Eigen::MatrixXd> system;
    double                               arm = 1; ///< scale of the turn [mm]

    Eigen::VectorXd project(const Eigen::VectorXd &u) const
    {
      Eigen::VectorXd h = Eigen::VectorXd::Zero(springs.size());
      for (std::size_t i = 0; i < springs.size(); ++i)
        for (const auto &node : springs[i])
          h[i] += node.second.dot(u.segment<3>(3 * node.first));
      return h;
    }

    Eigen::VectorXd spread(const Eigen::VectorXd &f, const std::size_t n) const
    {
      Eigen::VectorXd force = Eigen::VectorXd::Zero(n);
      for (std::size_t i = 0; i < springs.size(); ++i)
        for (const auto &node : springs[i])
          force.segment<3>(3 * node.first) += f[i] * node.second;
      return force;
    }

    /** Change of the springs' forces (first) and of the turn (second) for an imbalance of
     * displacements and of torque. */
    std::pair<Eigen::VectorXd, double> solve(const Eigen::VectorXd &u, const double torque) const
    {
      Eigen::VectorXd right(springs.size() + 1);
      right << project(u), torque / arm;
      const Eigen::VectorXd x = system.solve(right);
      return {-x.head(springs.size()), x[springs.size()] / arm};
    }
  };
} // namespace vfife

#endif
