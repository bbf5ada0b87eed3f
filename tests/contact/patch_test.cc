// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// Contact patch test (doc/design verification 13): two elastic blocks 10 x 10 x 4 mm without
// Poisson's effect, meshes of 3 x 3 and 5 x 5 elements meeting at z = 0, pressed by 1 MPa: the
// exact stress is -1 MPa everywhere. The error of each discretization goes to the screen's error
// stream, its bound is checked. No point of these rules lies on an edge of the other mesh, where
// the force along the facets jumps and Newton's method with differences would not end.
#include "../tests.h"
#include "surfaces.h"

#include <Eigen/Dense>

using namespace test_surfaces;

constexpr double youngs_modulus = 1000., size = 10., height = 4., pressure = 1., penalty = 1e4;

using Matrix24 = Eigen::Matrix<double, 24, 24>;
using Strain   = Eigen::Matrix<double, 6, 24>;

/** Strain of the brick a x b x c at (x, y, z) in [0,1]^3; nodes x fastest. */
Strain strain_matrix(const Vector3 &edges, const Vector3 &at)
{
  Strain B = Strain::Zero();
  for (unsigned int n = 0; n < 8; ++n)
    {
      Vector3 gradient;
      for (unsigned int d = 0; d < 3; ++d)
        {
          gradient[d] = 1. / edges[d];
          for (unsigned int e = 0; e < 3; ++e)
            {
              const bool upper = (n >> e) & 1;
              gradient[d] *= e == d ? (upper ? 1. : -1.) : (upper ? at[e] : 1. - at[e]);
            }
        }
      for (unsigned int d = 0; d < 3; ++d)
        {
          B(d, 3 * n + d)               = gradient[d];
          B(3 + d, 3 * n + d)           = gradient[(d + 1) % 3];
          B(3 + d, 3 * n + (d + 1) % 3) = gradient[d];
        }
    }
  return B;
}

/** A block of n x n x 2 bricks from z0 up. */
struct Block
{
  Block(const unsigned int n_, const double z0_)
    : n(n_)
    , z0(z0_)
    , edges(size / n, size / n, height / 2)
  {
  }

  unsigned int node(const unsigned int i, const unsigned int j, const unsigned int k) const
  {
    return (k * (n + 1) + j) * (n + 1) + i;
  }
  unsigned int n_dofs() const
  {
    return 3 * 3 * (n + 1) * (n + 1);
  }

  /** Calls @p f(dofs of the element). */
  template <typename F>
  void for_elements(const F &f) const
  {
    for (unsigned int k = 0; k < 2; ++k)
      for (unsigned int j = 0; j < n; ++j)
        for (unsigned int i = 0; i < n; ++i)
          {
            std::array<unsigned int, 24> dofs;
            for (unsigned int c = 0; c < 8; ++c)
              for (unsigned int d = 0; d < 3; ++d)
                dofs[3 * c + d] = 3 * node(i + (c & 1), j + ((c >> 1) & 1), k + (c >> 2)) + d;
            f(dofs);
          }
  }

  static std::vector<Vector3> gauss_points()
  {
    std::vector<Vector3> points;
    std::vector<double>  x, w;
    gauss_legendre(2, x, w);
    for (unsigned int q = 0; q < 8; ++q)
      points.emplace_back(x[q & 1], x[(q >> 1) & 1], x[q >> 2]);
    return points;
  }

  Eigen::MatrixXd stiffness() const
  {
    Matrix24                    element = Matrix24::Zero();
    Eigen::Matrix<double, 6, 1> D;
    D << 1., 1., 1., 0.5, 0.5, 0.5;
    for (const Vector3 &x : gauss_points())
      {
        const Strain B = strain_matrix(edges, x);
        element += B.transpose() * (youngs_modulus * D).asDiagonal() * B * (edges.prod() / 8.);
      }
    Eigen::MatrixXd K = Eigen::MatrixXd::Zero(n_dofs(), n_dofs());
    for_elements([&](const auto &dofs) {
      for (unsigned int a = 0; a < 24; ++a)
        for (unsigned int b = 0; b < 24; ++b)
          K(dofs[a], dofs[b]) += element(a, b);
    });
    return K;
  }

  /** Largest |sigma_zz + pressure| at the Gauss points. */
  double stress_error(const Eigen::VectorXd &u) const
  {
    double error = 0.;
    for_elements([&](const auto &dofs) {
      Eigen::Matrix<double, 24, 1> u_e;
      for (unsigned int a = 0; a < 24; ++a)
        u_e[a] = u[dofs[a]];
      for (const Vector3 &x : gauss_points())
        raise_to(error, std::abs(youngs_modulus * (strain_matrix(edges, x) * u_e)[2] + pressure));
    });
    return error;
  }

  unsigned int n;
  double       z0;
  Vector3      edges;
};

/** Largest error of the stress relative to the pressure. */
double stress_error(const ContactOptions &options)
{
  const Block   upper(3, 0.), lower(5, -height);
  MovingSurface slave(plane(3, 3, 0., size, 0., size, 0., true)),
    master(plane(5, 5, 0., size, 0., size, 0.));
  const unsigned int n_upper = upper.n_dofs(), n = n_upper + lower.n_dofs();
  const unsigned int lower_surface = n_upper + 3 * lower.node(0, 0, 2);

  Eigen::MatrixXd K                             = Eigen::MatrixXd::Zero(n, n);
  K.topLeftCorner(n_upper, n_upper)             = upper.stiffness();
  K.bottomRightCorner(n - n_upper, n - n_upper) = lower.stiffness();

  Eigen::VectorXd   load = Eigen::VectorXd::Zero(n);
  std::vector<bool> held(n, false);
  for (const Block *block : {&upper, &lower})
    for (unsigned int k = 0; k < 3; ++k)
      for (unsigned int j = 0; j <= block->n; ++j)
        for (unsigned int i = 0; i <= block->n; ++i)
          {
            const unsigned int dof = (block == &lower ? n_upper : 0) + 3 * block->node(i, j, k);
            const double       share =
              ((i == 0 || i == block->n) ? 0.5 : 1.) * ((j == 0 || j == block->n) ? 0.5 : 1.);
            held[dof] = i == 0 || i == block->n; // corners must not slip over the master's border
            held[dof + 1] = j == 0 || j == block->n;
            if (block == &lower)
              held[dof + 2] = k == 0;
            else if (k == 2)
              load[dof + 2] = -pressure * share * block->edges[0] * block->edges[1];
          }

  Contact contact(slave.surface, master.surface, options);
  contact.find_candidates(slave.body, master.body, 1.);
  // the slave faces down: plane() runs its nodes in y first
  std::vector<unsigned int> slave_dofs, master_dofs;
  for (unsigned int i = 0; i <= upper.n; ++i)
    for (unsigned int j = 0; j <= upper.n; ++j)
      slave_dofs.push_back(3 * upper.node(i, j, 0));
  for (unsigned int m = 0; m < master.surface.positions.size(); ++m)
    master_dofs.push_back(lower_surface + 3 * m);

  const auto contact_forces = [&](const Eigen::VectorXd &u) {
    Eigen::VectorXd f = Eigen::VectorXd::Zero(n);
    for (auto [surface, dofs] : {std::pair(&slave, &slave_dofs), std::pair(&master, &master_dofs)})
      {
        surface->clear_forces();
        for (unsigned int m = 0; m < dofs->size(); ++m)
          for (unsigned int d = 0; d < 3; ++d)
            surface->positions[3 * m + d] = surface->surface.positions[m][d] + u[(*dofs)[m] + d];
      }
    add_forces(contact, slave, master);
    for (auto [surface, dofs] : {std::pair(&slave, &slave_dofs), std::pair(&master, &master_dofs)})
      for (unsigned int m = 0; m < dofs->size(); ++m)
        for (unsigned int d = 0; d < 3; ++d)
          f[(*dofs)[m] + d] += surface->forces[3 * m + d];
    return f;
  };

  // start with all points pressed; Newton's method with differences of the contact forces
  Eigen::VectorXd u = Eigen::VectorXd::Zero(n);
  for (unsigned int i = 2; i < n_upper; i += 3)
    u[i] = -0.01;
  std::vector<unsigned int> columns;
  for (const auto *dofs : {&slave_dofs, &master_dofs})
    for (const unsigned int dof : *dofs)
      for (unsigned int d = 0; d < 3; ++d)
        if (!held[dof + d])
          columns.push_back(dof + d);
  double change = 1.;
  for (unsigned int iteration = 0; iteration < 10 && change > 1e-12; ++iteration)
    {
      const Eigen::VectorXd f = contact_forces(u);
      Eigen::MatrixXd       A = K;
      for (const unsigned int column : columns)
        {
          Eigen::VectorXd moved = u;
          moved[column] += 1e-7;
          A.col(column) -= (contact_forces(moved) - f) / 1e-7;
        }
      Eigen::VectorXd r = load + f - K * u;
      for (unsigned int i = 0; i < n; ++i)
        if (held[i])
          {
            A.row(i).setZero();
            A(i, i) = 1.;
            r[i]    = -u[i];
          }
      const Eigen::VectorXd du = A.partialPivLu().solve(r);
      u += du;
      change = du.lpNorm<Eigen::Infinity>();
    }
  check("equilibrium", change < 1e-10);
  return largest_of(upper.stress_error(u.head(n_upper)), lower.stress_error(u.tail(n - n_upper))) /
         pressure;
}

ContactOptions options_for(const ContactDiscretization discretization, const unsigned int points)
{
  ContactOptions options          = with_penalty(penalty);
  options.discretization          = discretization;
  options.points_per_facet.number = points;
  options.edge_fading             = 0.;
  return options;
}

void check_error(const std::string &name, const ContactOptions &options, const double bound)
{
  check_below(name + ": largest error of the stress", stress_error(options), bound);
}

int main()
{
  using D = ContactDiscretization;
  // bounds: measured values of doc/verification/contact.md, rounded up
  check_error("nodes", options_for(D::nodes, 3), 0.55);
  check_error("surface points, 2 x 2", options_for(D::surface_points, 2), 0.027);
  check_error("surface points, 3 x 3", options_for(D::surface_points, 3), 0.0052);
  check_error("surface points, 6 x 6", options_for(D::surface_points, 6), 0.0041);
  check_error("two pass, 3 x 3", options_for(D::two_pass, 3), 0.0012);
  check_error("two pass, 6 x 6", options_for(D::two_pass, 6), 0.002);
  ContactOptions fading = options_for(D::surface_points, 3);
  fading.edge_fading    = 0.3;
  check_error("surface points, 3 x 3, edges fading", fading, 0.019);
  return 0;
}
