// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_fem_pair_pair_equilibrium_parts_h
#define vfife_fem_pair_pair_equilibrium_parts_h

#include "bearing_springs.h"

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

  /** What contact and bearings do at a trial state. */
  struct PairEquilibrium::Trial
  {
    Eigen::VectorXd force;              ///< at the compliance's rows, axes of time zero [N]
    double          contact_force  = 0; ///< norm of the contact's [N]
    double          contact_energy = 0; ///< [mJ]
    double          contact_torque = 0; ///< on the driven body about its axis [N mm]
    double          energy         = 0; ///< of contact and bearings [mJ]
    double          torque         = 0; ///< of both [N mm]
  };

  /** Where Newton's method is: forces taken for those of contact and bearings, what they do, the
   * turn. */
  struct PairEquilibrium::Iterate
  {
    Eigen::VectorXd force, deflection; ///< at the compliance's rows
    double          turn     = 0;
    bool            touching = true; ///< otherwise the turn is given and bearings act alone
    double          unit     = 0;    ///< not touching: of forces [N]
    Trial           trial;

    double potential(const double load) const
    {
      return 0.5 * force.dot(deflection) + trial.energy - load * turn;
    }

    /** Forces that the bodies were bent by less those that contact and bearings then exert, over
     * the contact's, or what the torque lacks of the load, over the load. */
    double residual(const double load) const
    {
      const double imbalance = (trial.force - force).norm();
      return touching
               ? std::max(imbalance / trial.contact_force, std::abs((trial.torque + load) / load))
               : imbalance / unit;
    }

    /** Whether something is pressed, where it has to. */
    bool presses() const
    {
      return !touching || trial.contact_energy > 0;
    }
  };

  /** Springs of the contact at the watched points, force = B f, f = -stiffness h, and behind them
   * the rows of bearings and bodies that stand. */
  struct PairEquilibrium::Tangent
  {
    std::vector<std::array<std::pair<unsigned int, Vector3>, 8>> springs; ///< place and direction
    Eigen::VectorXd                                              inverse_stiffness; ///< [mm/N]
    Eigen::VectorXd by_turn; ///< change of h with the turn of the driven body [mm/rad]
    // Of the rows behind the watched points, [N/mm], [N], [N mm]:
    Eigen::MatrixXd stiffness;      ///< beyond that of the compliance
    Eigen::VectorXd rows_by_turn;   ///< change of minus their forces with the turn
    double          turn_twice = 0; ///< change of minus their torque with the turn
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

    Eigen::Index n_forces() const
    {
      return springs.size() + stiffness.rows();
    }

    Eigen::VectorXd spread(const Eigen::VectorXd &f, const std::size_t n) const
    {
      Eigen::VectorXd force = Eigen::VectorXd::Zero(n);
      for (std::size_t i = 0; i < springs.size(); ++i)
        for (const auto &node : springs[i])
          force.segment<3>(3 * node.first) += f[i] * node.second;
      force.tail(stiffness.rows()) = f.tail(stiffness.rows());
      return force;
    }

    /** What displacements @p u at the compliance's rows do: ways along the springs, forces that the
     * other rows lose, and, last, torque that they lose, over the arm. */
    Eigen::VectorXd respond(const Eigen::VectorXd &u) const
    {
      Eigen::VectorXd x                           = Eigen::VectorXd::Zero(n_forces() + 1);
      x.head(springs.size())                      = project(u);
      const auto d                                = u.tail(stiffness.rows());
      x.segment(springs.size(), stiffness.rows()) = stiffness * d;
      x[n_forces()]                               = rows_by_turn.dot(d) / arm;
      return x;
    }

    /** Change of the springs' and rows' forces (first) and of the turn (second) for an
     * imbalance of displacements and of torque. */
    std::pair<Eigen::VectorXd, double> solve(const Eigen::VectorXd &u, const double torque) const
    {
      Eigen::VectorXd right   = respond(u);
      right[n_forces()]       = torque / arm - right[n_forces()];
      const Eigen::VectorXd x = system.solve(right);
      return {-x.head(n_forces()), x[n_forces()] / arm};
    }
  };
} // namespace vfife

#endif
