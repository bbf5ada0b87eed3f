// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_tests_contact_pressed_blocks_h
#define vfife_tests_contact_pressed_blocks_h

#include "elastic_block.h"

#include <Eigen/Dense>

namespace test_surfaces
{
  inline Material soft_material()
  {
    Material material;
    material.youngs_modulus = 20000.;
    material.poissons_ratio = 0.3;
    return material;
  }

  /** Two blocks whose far surfaces approach each other: Newton's method on the compliances. */
  struct Pressed
  {
    const ElasticBlock &upper, &lower;
    MovingSurface       slave, master;
    Contact             contact;
    bool                converged = false;
    double force = 0., largest_pressure = 0.; ///< of the modelled part [N], of a point [MPa]
    double half_width = 0., peak = 0.;        ///< [mm], nodal pressure in the middle [MPa]

    Pressed(const ElasticBlock   &upper_,
            const ElasticBlock   &lower_,
            const ContactOptions &options,
            const double          approach)
      : upper(upper_)
      , lower(lower_)
      , slave(upper_.surface)
      , master(lower_.surface)
      , contact(slave.surface, master.surface, options)
    {
      slave.place({Matrix3::Identity(), Vector3(0., 0., -0.5 * approach)});
      master.place({Matrix3::Identity(), Vector3(0., 0., 0.5 * approach)});
      contact.find_candidates(slave.body, master.body, 2. * approach + contact.search_skin());
      solve();
      evaluate();
    }

  private:
    /** Forces on the condensed unknowns when these are displaced by @p u. */
    Eigen::VectorXd forces(const Eigen::VectorXd &u)
    {
      Eigen::VectorXd f(u.size());
      Eigen::Index    first = 0;
      for (auto side : {std::pair(&slave, &upper), std::pair(&master, &lower)})
        {
          side.first->clear_forces();
          side.first->place(side.first->body);
          for (unsigned int i = 0; i < side.second->columns.size(); ++i)
            side.first->positions[side.second->columns[i]] += u[first + i];
          first += side.second->columns.size();
        }
      add_forces(contact, slave, master);
      first = 0;
      for (auto side : {std::pair(&slave, &upper), std::pair(&master, &lower)})
        {
          for (unsigned int i = 0; i < side.second->columns.size(); ++i)
            f[first + i] = side.first->forces[side.second->columns[i]];
          first += side.second->columns.size();
        }
      return f;
    }

    /** u = flexibility f: by the forces themselves, and by the far surface that yields to their
     * resultant as in a half-space of which a quarter is modelled. */
    Eigen::MatrixXd flexibility() const
    {
      const Eigen::Index n = upper.columns.size(), m = lower.columns.size();
      Eigen::MatrixXd    C      = Eigen::MatrixXd::Zero(n + m, n + m);
      C.topLeftCorner(n, n)     = upper.compliance;
      C.bottomRightCorner(m, m) = lower.compliance;
      for (Eigen::Index i = 0; i < n; ++i)
        if (upper.columns[i] % 3 == 2)
          C.col(i).head(n) += 4. * upper.into * upper.of_far_surface;
      for (Eigen::Index i = 0; i < m; ++i)
        if (lower.columns[i] % 3 == 2)
          C.col(n + i).tail(m) += 4. * lower.into * lower.of_far_surface;
      return C;
    }

    void solve()
    {
      constexpr double      step = 1e-8; // [mm], of difference quotients of piecewise linear forces
      const Eigen::MatrixXd C    = flexibility();
      Eigen::VectorXd       u    = Eigen::VectorXd::Zero(C.rows());
      for (unsigned int iteration = 0; iteration < 40 && !converged; ++iteration)
        {
          const Eigen::VectorXd f = forces(u);
          Eigen::MatrixXd       slopes(C.rows(), C.rows());
          for (Eigen::Index i = 0; i < C.rows(); ++i)
            {
              Eigen::VectorXd moved = u;
              moved[i] += step;
              slopes.col(i) = (forces(moved) - f) / step;
            }
          const Eigen::MatrixXd J  = Eigen::MatrixXd::Identity(C.rows(), C.rows()) - C * slopes;
          const Eigen::VectorXd du = J.partialPivLu().solve(C * f - u);
          u += du;
          converged = du.lpNorm<Eigen::Infinity>() < 1e-7; // of 1e-3 mm penetration
        }
      forces(u);
    }

    void evaluate()
    {
      force                         = slave.force()[2];
      const GroupPairResult &result = contact.results().front();
      largest_pressure              = result.largest_pressure;
      peak                          = slave.forces[2] / contact.node_springs().slave_areas()[0];
      // Second moment of the nodal forces. Cells of length h share a force between nodes whose x^2
      // is by h^2/6 larger on average.
      double       moment = 0.;
      const double cell   = upper.x[1];
      for (unsigned int n = 0; n < upper.surface.nodes.size(); ++n)
        moment += slave.forces[3 * n + 2] * std::pow(upper.surface.positions[n][0], 2);
      const double square = moment / force - cell * cell / 6.;
      // Of Hertz's pressures: <x^2> = a^2/5 on a circle, b^2/4 on a strip.
      half_width = std::sqrt((upper.plane_strain ? 4. : 5.) * square);
    }
  };

  /** A body of this radius of curvature, symmetric about the middle or an extruded section, with
   * cells that grow from the middle on up to @p width and @p growth; @p in_cell: the middle is that
   * of a cell. */
  inline ElasticBlock round_body(const bool   is_cylinder,
                                 const double curvature_radius,
                                 const double into,
                                 const double cell,
                                 const double width,
                                 const double growth)
  {
    ElasticBlock block;
    block.x            = graded(cell, 1.5, width, growth);
    block.y            = is_cylinder ? std::vector<double>{0., 0.25} : block.x;
    block.depth        = graded(cell, 1., width, growth);
    block.radius       = curvature_radius;
    block.into         = into;
    block.reach        = is_cylinder ? 1.9 : 1.6;
    block.plane_strain = is_cylinder;
    block.material     = soft_material();
    block.build();
    return block;
  }

} // namespace test_surfaces

#endif
