// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_fem_pair_pressed_pair_parts_h
#define vfife_fem_pair_pressed_pair_parts_h

#include <vfife/contact/contact.h>
#include <vfife/fem/pair/pressed_pair.h>
#include <vfife/mesh/body_mesh.h>
#include <vfife/model/model.h>

#include <Eigen/Cholesky>
#include <Eigen/LU>

namespace vfife
{
  /** One surface of a contact pair, its nodes' places among those of the rows, their motion. */
  struct PressedPair::Surface
  {
    static constexpr unsigned int no_place = static_cast<unsigned int>(-1);

    unsigned int              body;
    const FacetSurface       &facets;
    std::vector<unsigned int> place; ///< of the surface's nodes, or no_place
    std::vector<double>       mass, positions, velocities, forces;
    std::vector<double>       held; ///< displacements without rows, axes of time zero

    Surface(const Model &model, const unsigned int b, const std::string &name)
      : body(b)
      , facets(model.bodies[b].mesh().surfaces.at(name))
      , place(facets.nodes.size(), no_place)
      , positions(3 * facets.nodes.size(), 0.)
      , velocities(3 * facets.nodes.size(), 0.)
      , forces(3 * facets.nodes.size(), 0.)
      , held(3 * facets.nodes.size(), 0.)
    {
      for (const unsigned int node : facets.nodes)
        mass.push_back(model.bodies[b].node_masses()[node]);
    }
  };

  struct PressedPair::Pair
  {
    const ContactPair &definition;
    Surface            slave, master;
    Contact            contact;

    Pair(const ContactPair &pair, const Model &model)
      : definition(pair)
      , slave(model, pair.slave_body, pair.slave_surface)
      , master(model, pair.master_body, pair.master_surface)
      , contact(slave.facets, master.facets, pair.options)
    {
      contact.set_penalty(pair.options.penalty.value,
                          contact.node_springs().mass_per_area(slave.mass, master.mass));
      if (!pair.stiffness.empty())
        contact.set_stiffness(pair.stiffness);
      // Newton's method is one of springs along the normals.
      contact.set_friction_mode(FrictionMode::none);
    }

    const std::vector<unsigned int> &active(const Surface &surface) const
    {
      return &surface == &slave ? contact.active_slave_nodes() : contact.active_master_nodes();
    }
    SurfaceMotion motion(const Surface &surface, const RigidMotion &body) const
    {
      return {surface.positions.data(), surface.velocities.data(), body};
    }
    /** Undeformed flanks may be apart by this and touch under load [mm]. */
    double margin() const
    {
      return contact.search_skin() + contact.depth_limit();
    }
  };

  /** Springs of the contact, force = B f, f = -stiffness h, and behind them the rows behind the
   * nodes', all at those rows alone at which one of them acts. */
  struct PressedPair::Tangent
  {
    std::vector<unsigned int> rows;        ///< at which something acts, ascending
    Eigen::MatrixXd           flexibility; ///< of the bodies at `rows`
    std::vector<Spring>       springs;
    PressedSprings            others;
    double                    arm = 1; ///< scale of the turn [mm]

    /** A spring's directions by place among `rows`. */
    struct Entry
    {
      unsigned int row, spring;
      double       value;
    };
    std::vector<Entry> entries;

    Eigen::VectorXd by_turn;            ///< change of h with the turn as a way at the arm [-]
    double          turn_stiffness = 0; ///< with the turn as a way at the arm [N/mm]

    bool                                 symmetric = false; ///< no rows behind the nodes'
    Eigen::LLT<Eigen::MatrixXd>          factor;            ///< of the springs alone
    Eigen::VectorXd                      turned;            ///< factor^-1 by_turn
    Eigen::PartialPivLU<Eigen::MatrixXd> system;            ///< of all

    Eigen::Index n_springs() const
    {
      return springs.size();
    }
    Eigen::Index n_forces() const
    {
      return springs.size() + others.stiffness.rows();
    }

    /** Ways along the springs of displacements at `rows`, and of the forces that the other rows
     * lose; with the torque that these lose, over the arm, as the last. */
    Eigen::VectorXd respond(const Eigen::Ref<const Eigen::VectorXd> &u) const
    {
      const Eigen::Index n_others = others.stiffness.rows();
      Eigen::VectorXd    x        = Eigen::VectorXd::Zero(n_forces() + 1);
      for (const Entry &entry : entries)
        x[entry.spring] += entry.value * u[entry.row];
      if (n_others > 0)
        {
          const auto d                     = u.tail(n_others);
          x.segment(n_springs(), n_others) = others.stiffness * d;
          x[n_forces()]                    = others.by_turn.dot(d) / arm;
        }
      return x;
    }

    /** Forces at all rows of those of springs and other rows. */
    Eigen::VectorXd spread(const Eigen::VectorXd &f, const Eigen::Index n) const
    {
      Eigen::VectorXd force = Eigen::VectorXd::Zero(n);
      for (const Entry &entry : entries)
        force[rows[entry.row]] += f[entry.spring] * entry.value;
      const Eigen::Index n_others = others.stiffness.rows();
      force.tail(n_others) += f.tail(n_others);
      return force;
    }

    Eigen::VectorXd at_rows(const Eigen::VectorXd &x) const;
    void            factorize();

    /** Change of the springs' and rows' forces (first) and of the turn (second) for an
     * imbalance of displacements at `rows` and of torque. */
    std::pair<Eigen::VectorXd, double> solve(const Eigen::VectorXd &u, double torque) const;
  };
} // namespace vfife

#endif
