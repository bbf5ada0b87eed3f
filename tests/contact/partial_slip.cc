// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// Partial slip of a rigid cylinder and of a rigid sphere on an elastic half-space: pressed, then
// pulled sideways, against Cattaneo (1938) and Mindlin (1949), Johnson 1985, section 7.2:
//   q = mu p0 (sqrt(1 - r^2/a^2) - c/a sqrt(1 - r^2/c^2)),
//   cylinder: c/a = (1 - Q/(mu P))^(1/2),
//   sphere:   c/a = (1 - Q/(mu P))^(1/3),   shift = mu d (1 - (1 - Q/(mu P))^(2/3)).
// The half-space yields along the surface as across it (nu = 0), each by its own tractions alone,
// as two like bodies do.
#include "../parts.h"
#include "../tests.h"
#include "surfaces.h"

#include <Eigen/Dense>

using namespace test_surfaces;

constexpr double radius = 500., modulus = 1e5, mu = 0.4; // [mm], E/(1 - nu^2) [MPa]
constexpr double penalty = 1e7;                          // [N/mm^3]

/** A rigid body over a plane of stations nx x ny, which yield along x and along z. */
struct Pressed
{
  MovingSurface                          slave, master;
  Contact                                contact;
  unsigned int                           nx, ny;
  std::vector<std::vector<unsigned int>> nodes;      ///< of the master that move with a station
  Eigen::MatrixXd                        compliance; ///< in either direction
  Eigen::VectorXd                        u;          ///< along x, then along z

  static ContactOptions make_options()
  {
    ContactOptions options          = with_penalty(penalty);
    options.surface                 = ContactSurfaceKind::smooth_patches;
    options.edge_fading             = 0.;
    options.points_per_facet.number = 4;
    options.depth_limit             = 0.1;
    options.friction.coefficient    = mu;
    return options;
  }

  Pressed(const FacetSurface &body,
          const FacetSurface &plane,
          const unsigned int  nx,
          const unsigned int  ny)
    : slave(body)
    , master(plane)
    , contact(slave.surface, master.surface, make_options())
    , nx(nx)
    , ny(ny)
    , nodes(nx * ny)
    , compliance(nx * ny, nx * ny)
    , u(Eigen::VectorXd::Zero(2 * nx * ny))
  {
    contact.set_penalty(penalty, 1e-9);
  }

  Eigen::Index n_stations() const
  {
    return compliance.rows();
  }

  /** Forces on the stations, along x and along z. */
  Eigen::VectorXd forces(const Eigen::VectorXd &displacements)
  {
    const Eigen::Index n = n_stations();
    master.place({});
    for (Eigen::Index s = 0; s < n; ++s)
      for (const unsigned int node : nodes[s])
        MovingSurface::at(master.positions, node) +=
          Vector3(displacements[s], 0., displacements[n + s]);
    slave.clear_forces();
    master.clear_forces();
    add_forces(contact, slave, master);
    Eigen::VectorXd f = Eigen::VectorXd::Zero(2 * n);
    for (Eigen::Index s = 0; s < n; ++s)
      for (const unsigned int node : nodes[s])
        {
          f[s] += master.forces[3 * node];
          f[n + s] += master.forces[3 * node + 2];
        }
    return f;
  }

  Eigen::VectorXd deflect(const Eigen::VectorXd &f) const
  {
    const Eigen::Index n = n_stations();
    Eigen::VectorXd    d(2 * n);
    d << compliance * f.head(n), compliance * f.tail(n);
    return d;
  }

  /** d forces/d u by differences. A station acts no further than on the third beside it: all that
   * are seven apart are moved at once. */
  Eigen::MatrixXd slopes(const Eigen::VectorXd &f)
  {
    constexpr double       step  = 1e-9;
    constexpr unsigned int reach = 3, apart = 2 * reach + 1;
    const auto             n = static_cast<unsigned int>(n_stations());
    Eigen::MatrixXd        J = Eigen::MatrixXd::Zero(2 * n, 2 * n);
    for (unsigned int c = 0; c < 2; ++c)
      for (unsigned int colour = 0; colour < apart * std::min(ny, apart); ++colour)
        {
          Eigen::VectorXd           moved = u;
          std::vector<unsigned int> moving;
          for (unsigned int j = colour / apart; j < ny; j += apart)
            for (unsigned int i = colour % apart; i < nx; i += apart)
              moving.push_back(j * nx + i);
          for (const unsigned int s : moving)
            moved[c * n + s] += step;
          const Eigen::VectorXd change = (forces(moved) - f) / step;
          for (const unsigned int s : moving)
            for (unsigned int t = 0; t < n; ++t)
              if (near(s % nx, t % nx, reach) && near(s / nx, t / nx, reach))
                for (const unsigned int along : {t, n + t})
                  J(along, c * n + s) = change[along];
        }
    return J;
  }

  static bool near(const unsigned int a, const unsigned int b, const unsigned int reach)
  {
    return a <= b + reach && b <= a + reach;
  }

  /** Moves the body there and finds u = C f(u) by Newton's method; takes what has slid. Returns
   * the forces. */
  Eigen::VectorXd move(const double along, const double down)
  {
    slave.place({Matrix3::Identity(), Vector3(along, 0., -down)});
    contact.find_candidates(slave.body, master.body, 1.);
    contact.set_friction_mode(FrictionMode::held);
    const Eigen::Index n    = n_stations();
    bool               done = false;
    for (unsigned int iteration = 0; iteration < 60 && !done; ++iteration)
      {
        const Eigen::VectorXd f = forces(u), r = deflect(f) - u;
        const Eigen::MatrixXd F = slopes(f);
        Eigen::MatrixXd       J = Eigen::MatrixXd::Identity(2 * n, 2 * n);
        J.topRows(n) -= compliance * F.topRows(n);
        J.bottomRows(n) -= compliance * F.bottomRows(n);
        const Eigen::VectorXd du = J.partialPivLu().solve(r);
        // Contact opens and slides at kinks: no larger steps than keep the imbalance falling.
        double part = 1.;
        while (part > 1e-3 && (deflect(forces(u + part * du)) - u - part * du).norm() > r.norm())
          part *= 0.5;
        u += part * du;
        done = part * du.lpNorm<Eigen::Infinity>() < 1e-10;
      }
    check("in equilibrium", done);
    contact.set_friction_mode(FrictionMode::follows);
    return forces(u);
  }
};

/** The station @p middle sticks with 1 - c/a of the limit. */
void check_middle(const std::string     &name,
                  const Eigen::VectorXd &f,
                  const Eigen::Index     middle,
                  const double           c_by_a)
{
  check_ratio(name + "c/a by the traction in the middle",
              (1. + f[middle] / (mu * f[f.size() / 2 + middle])) / c_by_a,
              0.03);
}

void cylinder()
{
  constexpr double       half_width = 1., cell = 0.04, width = 0.6, far = 10.; // [mm]
  constexpr unsigned int n      = 65;
  const auto             normal = [](double, double v) {
    const double x = 2. * (v - 0.5);
    return Vector3(x / radius, 0., -std::sqrt(1. - x * x / (radius * radius)));
  };
  const auto point = [&](const double u, const double v) {
    return Vector3(radius * normal(u, v) + Vector3(0., 0.2 + width * u, radius));
  };
  const double half_length = 0.5 * (n - 1) * cell;
  Pressed      strip(grid(1, 80, point, normal),
                plane(n - 1, 1, -half_length, half_length, 0., 1., 0.),
                n,
                1);
  // -2/(pi E*) ln|r/far| of uniform tractions on cells about the stations.
  const auto integral = [](const double r) {
    return r == 0. ? 0. : r * (std::log(std::abs(r) / far) - 1.);
  };
  for (unsigned int i = 0; i < n; ++i)
    {
      strip.nodes[i] = {i, i + n};
      for (unsigned int j = 0; j < n; ++j)
        {
          const double r         = (static_cast<double>(i) - j) * cell;
          strip.compliance(i, j) = -2. / (pi * modulus * width) *
                                   (integral(r + 0.5 * cell) - integral(r - 0.5 * cell)) / cell;
        }
    }

  // Deep enough for a contact of 2 mm: delta = a^2/(4 R) (2 ln(2 far/a) + 1) with the datum at
  // `far`.
  const double down =
    half_width * half_width / (4. * radius) * (2. * std::log(2. * far / half_width) + 1.);
  Eigen::VectorXd f = strip.move(0., down) / width;
  const double    P = -f.tail(n).sum();
  const double    a = std::sqrt(4. * P * radius / (pi * modulus)), p0 = 2. * P / (pi * a);
  check_ratio("cylinder: normal force over Hertz's",
              P / (pi * modulus * half_width * half_width / (4. * radius)),
              0.02);
  check_below("cylinder: no tangential traction over mu p0",
              f.head(n).lpNorm<Eigen::Infinity>() / (cell * mu * p0),
              0.01);

  // Sideways in steps of the shift that slides, mu times down, as both deflect by one kernel.
  for (unsigned int i = 1; i <= 9; ++i)
    {
      f = strip.move(0.1 * i * mu * down, down) / width;
      if (i % 3 != 0)
        continue;
      const double      c    = a * std::sqrt(1. - f.head(n).sum() / (mu * P));
      const std::string name = "cylinder, step " + std::to_string(i) + ": ";
      check_middle(name, f, n / 2, c / a);
      double error = 0.;
      for (unsigned int j = 0; j < n; ++j)
        {
          const auto root = [r = std::abs(j * cell - half_length)](const double edge) {
            return r < edge ? std::sqrt(1. - r * r / (edge * edge)) : 0.;
          };
          error += std::abs(f[j] - mu * p0 * (root(a) - c / a * root(c)) * cell);
        }
      check_below(name + "tractions, mean error over the mean", error / f.head(n).sum(), 0.03);
      // Where q leaves mu p: a station tells half a cell, the hats of its neighbours reach one
      // more.
      double stick = 0.;
      for (unsigned int j = n / 2; j < n && f[n + j] < 0.; ++j)
        if (f[j] < -0.999 * mu * f[n + j])
          stick = (j - n / 2 + 0.5) * cell;
      check_below(name + "half-width of the stick zone, in cells", (stick - c) / cell, 1.5);
    }
}

/** Displacement at (x, y) of a half-space under unit pressure on a square of half side @p b about
 * the origin, times pi E*: Love 1929, Johnson 1985, equation 3.25. */
double deflection_of_square(const double x, const double y, const double b)
{
  const auto term = [](const double p, const double q, const double r) {
    return p * std::log((q + std::hypot(q, p)) / (r + std::hypot(r, p)));
  };
  return term(x + b, y + b, y - b) + term(y + b, x + b, x - b) + term(x - b, y - b, y + b) +
         term(y - b, x - b, x + b);
}

void sphere()
{
  constexpr double       half_width = 1., cell = 0.15; // [mm]
  constexpr unsigned int n       = 21;
  const double           half    = 0.5 * (n - 1) * cell;
  const auto             outward = [half](const double u, const double v) {
    const double x = 1.9 * half * (v - 0.5), y = 1.9 * half * (u - 0.5);
    return Vector3(x, y, -std::sqrt(radius * radius - x * x - y * y)).normalized();
  };
  const auto point = [&](const double u, const double v) {
    return Vector3(radius * (outward(u, v) + Vector3::UnitZ()));
  };
  Pressed    ball(grid(40, 40, point, outward),
               plane(n - 1, n - 1, -half, half, -half, half, 0.),
               n,
               n);
  const auto at = [=](const unsigned int s) {
    return Eigen::Vector2d((s % n) * cell - half, (s / n) * cell - half);
  };
  for (unsigned int s = 0; s < n * n; ++s)
    {
      ball.nodes[s] = {s};
      for (unsigned int t = 0; t < n * n; ++t)
        {
          const Eigen::Vector2d r = at(s) - at(t);
          ball.compliance(s, t) =
            deflection_of_square(r[0], r[1], 0.5 * cell) / (pi * modulus * cell * cell);
        }
    }

  const double    down = half_width * half_width / radius;
  Eigen::VectorXd f    = ball.move(0., down);
  const double    P = -f.tail(n * n).sum(), a = std::cbrt(0.75 * P * radius / modulus);
  check_ratio("sphere: normal force over Hertz's",
              P / (4. / 3. * modulus * std::pow(half_width, 3) / radius),
              0.03);
  for (const unsigned int i : {3u, 6u, 9u})
    {
      f                      = ball.move(0.1 * i * mu * down, down);
      const double      left = 1. - f.head(n * n).sum() / (mu * P);
      const std::string name = "sphere, step " + std::to_string(i) + ": ";
      check_ratio(name + "shift over Mindlin's for this force",
                  0.1 * i * down / (a * a / radius * (1. - std::pow(left, 2. / 3.))),
                  0.03);
      check_middle(name, f, n * n / 2, std::cbrt(left));
    }
}

int main()
{
  return run_parts({cylinder, sphere});
}
