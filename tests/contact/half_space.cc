// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// Pressures on their own grid: influence of a rectangle and of a layer, and contacts whose pressure
// is known.
#include "../parts.h"
#include "../tests.h"

#include <vfife/contact/half_space/cell_flexibility.h>
#include <vfife/contact/half_space/cell_forces.h>
#include <vfife/contact/law/hertz.h>

#include <functional>

using namespace vfife;

const ElasticLayer steel{206000., 0.29, {}}, bronze{110000., 0.34, {}};
const double       modulus = contact_modulus(206000., 0.29, 110000., 0.34);

void check_rectangle()
{
  check_close("square, middle: 4 ln(1 + sqrt 2) of its side",
              integrate_inverse_distance(Vector2(0., 0.), Vector2(2., 2.)),
              8. * std::log(1. + std::sqrt(2.)),
              1e-13);
  double sum = 0.;
  for (unsigned int i = 0; i < 400; ++i)
    for (unsigned int j = 0; j < 400; ++j)
      sum += 0.6 / 160000. /
             Vector2(1. - 0.3 * ((i + .5) / 200. - 1.), 0.7 - 0.5 * ((j + .5) / 200. - 1.)).norm();
  check_close("rectangle, beside it, against a sum of points",
              integrate_inverse_distance(Vector2(1., 0.7), Vector2(0.6, 1.)),
              sum,
              1e-6);
  check_close("rectangle, level with its side, against a whole of two",
              integrate_inverse_distance(Vector2(.5, .1), Vector2(1., 2.)) * 2.,
              integrate_inverse_distance(Vector2(0., .1), Vector2(2., 2.)),
              1e-12);
}

void check_layer()
{
  for (const double nu : {0., 0.29, 0.45})
    {
      const BondedLayer layer(nu);
      // Under a uniform pressure p a layer gives way by p d (1 + nu)(1 - 2 nu)/(E (1 - nu)).
      double sum = 0.;
      for (unsigned int i = 0; i < 20000; ++i)
        {
          const double r = (i + .5) * 1e-3;
          sum += 2. * pi * r * 1e-3 * (1. / r + layer.correction(r, 1.5));
        }
      check_close("layer, nu = " + std::to_string(nu).substr(0, 4) + ", uniform pressure",
                  sum / pi * (1. - nu * nu),
                  1.5 * (1. + nu) * (1. - 2. * nu) / (1. - nu),
                  1e-3);
      check_close("layer, nothing moves far away", 19.5 * layer.correction(19.5, 1.5), -1., 1e-3);
      check_below("a deep layer", layer.correction(1., 1e6), 1e-5);
    }
}

struct Contact
{
  double               peak = 0., closing = 0.; ///< [MPa], [mm]
  Vector2              half_widths;             ///< by second moments, of Hertz's pressures [mm]
  double               force      = 0.;         ///< [N]
  unsigned int         iterations = 0;
  std::vector<Vector2> points;
  std::vector<double>  pressures; ///< [MPa]
};

/** A grid of 2 n x 2 n cells over the rectangle of half sides @p half. */
Contact press(const std::function<double(const Vector2 &)> &gap,
              const Vector2                                &half,
              const unsigned int                            n,
              const double                                  load,
              const double                                  depth = 0.)
{
  std::vector<std::array<int, 2>> places;
  std::vector<Vector2>            points;
  const Vector2                   sides = half / n;
  std::vector<double>             gaps;
  for (int i = -int(n); i < int(n); ++i)
    for (int j = -int(n); j < int(n); ++j)
      {
        const Vector2 x((i + .5) * sides[0], (j + .5) * sides[1]);
        if (!std::isfinite(gap(x)))
          continue;
        places.push_back({{i, j}});
        points.push_back(x);
        gaps.push_back(gap(x));
      }
  std::array<ElasticLayer, 2> bodies{{steel, bronze}};
  if (depth > 0.)
    for (ElasticLayer &body : bodies)
      body.depths.assign(points.size(), depth);
  const Eigen::MatrixXd A = compute_cell_flexibility(places, sides, bodies);
  const CellForces      result =
    find_cell_forces([&A](const Eigen::VectorXd &f) -> Eigen::VectorXd { return A * f; },
                     Eigen::Map<const Eigen::VectorXd>(gaps.data(), gaps.size()),
                     Eigen::VectorXd::Ones(gaps.size()),
                     load);
  Contact found;
  Vector2 moment = Vector2::Zero();
  for (std::size_t i = 0; i < points.size(); ++i)
    {
      found.points.push_back(points[i]);
      found.pressures.push_back(result.forces[i] / (sides[0] * sides[1]));
      raise_to(found.peak, found.pressures.back());
      found.force += result.forces[i];
      moment += result.forces[i] * points[i].cwiseAbs2();
    }
  found.half_widths = (5. * moment / found.force).cwiseSqrt();
  found.closing     = result.closing;
  found.iterations  = result.iterations;
  return found;
}

double hertz_pressure(const Vector2 &x, const Vector2 &axes, const double peak)
{
  const double rest = 1. - x.cwiseQuotient(axes).squaredNorm();
  return rest > 0. ? peak * std::sqrt(rest) : 0.;
}

/** Errors of force, peak, half axes, closing and of the pressure anywhere over Hertz's, over
 * theirs. */
Contact check_hertz(const std::string &name,
                    const Vector2     &curvatures,
                    const double       load,
                    const unsigned int n,
                    const double       depth = 0.)
{
  const HertzContact hertz(curvatures, modulus);
  const Vector2      axes = hertz.semi_axes(load);
  const double       peak = hertz.largest_pressure(load);
  // 1.25: the cells' borders do not fall on the contact's.
  const Contact found = press([&](const Vector2 &x) { return .5 * curvatures.dot(x.cwiseAbs2()); },
                              1.25 * axes,
                              n,
                              load,
                              depth);
  check_ratio(name + ", force", found.force / load, 1e-12);
  check_ratio(name + ", largest pressure", found.peak / peak, 0.006);
  for (unsigned int d = 0; d < 2; ++d)
    check_ratio(name + ", half axis", found.half_widths[d] / axes[d], 0.006);
  if (depth == 0.)
    check_ratio(name + ", approach", found.closing / hertz.approach(load), 0.003);
  check("... few iterations", found.iterations < 150);
  return found;
}

void check_contacts()
{
  // The error at a fixed place falls with the cells; along the border, where the pressure is a
  // root, it is largest.
  const HertzContact hertz(Vector2(.02, .02), modulus);
  double             before = 0.;
  for (const unsigned int n : {6, 12, 24})
    {
      const Contact found = press([](const Vector2 &x) { return .01 * x.squaredNorm(); },
                                  Vector2::Constant(1.25 * hertz.semi_axes(500.)[0]),
                                  n,
                                  500.);
      double        sum   = 0.;
      for (std::size_t i = 0; i < found.points.size(); ++i)
        sum += std::abs(found.pressures[i] - hertz_pressure(found.points[i],
                                                            hertz.semi_axes(500.),
                                                            hertz.largest_pressure(500.)));
      const double error = sum / found.points.size() / hertz.largest_pressure(500.);
      if (before > 0.)
        check("pressures of a sphere converge", error < .6 * before);
      before = error;
    }
  check_hertz("sphere", Vector2(.02, .02), 500., 16);
  check_hertz("crossed cylinders", Vector2(.01, .06), 500., 16);
  check_hertz("teeth", Vector2(4.0749e-4, 6.0966e-2), 8881., 16);
  // A layer of three widths has the half-space's pressures, nearly.
  const double width = HertzContact(Vector2(.02, .02), modulus).semi_axes(500.)[0];
  check_hertz("sphere on layers", Vector2(.02, .02), 500., 16, 6. * width);
}

/** Flat, round punch, rigid but for its own half-space: p = F/(2 pi a sqrt(a^2 - r^2)), approach
 * F/(2 a E*). */
void check_punch()
{
  const double  a = 1., load = 1000.;
  const Contact found = press([&](const Vector2 &x) { return x.norm() < a ? 0. : std::nan(""); },
                              Vector2::Constant(a),
                              20,
                              load);
  double        worst = 0.;
  for (std::size_t i = 0; i < found.points.size(); ++i)
    if (found.points[i].norm() < .8 * a)
      raise_to(worst,
               std::abs(found.pressures[i] * 2. * pi * a / load *
                          std::sqrt(a * a - found.points[i].squaredNorm()) -
                        1.));
  check_below("punch, pressure within four fifths of its radius", worst, 0.02);
  check_ratio("punch, approach", found.closing / (load / (2. * a * modulus)), 0.01);
}

/** A cylinder that ends: every row across it has the pressure of a line contact of its own
 * load, and the rows at the ends, beyond which the half-space goes on, carry more. */
void check_line()
{
  const double  load = 1000., length = 12., radius = 20.;
  const double  half  = std::sqrt(4. * load / length * radius / (pi * modulus));
  constexpr int n     = 20;
  const Contact found = press([&](const Vector2 &x) { return x[0] * x[0] / (2. * radius); },
                              Vector2(1.4 * half, length / 2.),
                              n,
                              load);
  const auto    row   = [&](const double y) {
    double peak = 0., density = 0.;
    for (std::size_t i = 0; i < found.points.size(); ++i)
      if (std::abs(found.points[i][1] - y) < length / (4. * n))
        {
          raise_to(peak, found.pressures[i]);
          density += found.pressures[i] * 1.4 * half / n;
        }
    return Vector2(peak / std::sqrt(density * modulus / (pi * radius)), density * length / load);
  };
  const double cell = length / (2. * n);
  check_ratio("cylinder, middle, pressure over a line's", row(.5 * cell)[0], 0.006);
  check_ratio("cylinder, a quarter from its end", row(3. + .5 * cell)[0], 0.006);
  check("cylinder, its end carries more",
        row(6. - .5 * cell)[1] > 1.2 && row(.5 * cell)[1] < 1. && row(.5 * cell)[1] > 0.9);
}

/** Cells of different arms share a load as their closing says. */
void check_arms()
{
  const Eigen::Vector3d arms(1., 2., 4.), gaps(0., 1e-3, 9e-3);
  const double          flexibility = 1e-5;
  const CellForces      found       = find_cell_forces(
    [&](const Eigen::VectorXd &f) -> Eigen::VectorXd { return flexibility * f; }, gaps, arms, 700.);
  // Two of three carry: f = (closing arm - gap)/flexibility.
  const double closing = (700. * flexibility + 2. * 1e-3) / 5.;
  check_ratio("arms, closing", found.closing / closing, 1e-7);
  check_ratio("arms, force of the first", found.forces[0] / (closing / flexibility), 1e-7);
  check_ratio("arms, load", found.forces.dot(arms) / 700., 1e-12);
  check("arms, the third does not touch",
        found.forces[2] == 0. && std::abs(found.gaps[2] - (9e-3 - 4. * closing)) < 1e-9);
}

/** Made-up flexibilities that couple all cells: those that were let go on the way come back where
 * they belong. */
void check_return()
{
  double     seed = .5, worst = 0.;
  const auto number = [&seed] {
    seed = std::fmod(997. * seed + .1234567, 1.);
    return seed;
  };
  for (unsigned int i = 0; i < 40; ++i)
    {
      const Eigen::Index    n = 12;
      const Eigen::MatrixXd B = Eigen::MatrixXd::NullaryExpr(n, n, [&] { return number() - .5; });
      const Eigen::MatrixXd flexibility = B * B.transpose() + .2 * Eigen::MatrixXd::Identity(n, n);
      const Eigen::VectorXd gaps        = Eigen::VectorXd::NullaryExpr(n, number);
      const CellForces      found =
        find_cell_forces([&](
                           const Eigen::VectorXd &f) -> Eigen::VectorXd { return flexibility * f; },
                         gaps,
                         Eigen::VectorXd::Ones(n),
                         1.);
      const Eigen::VectorXd h =
        gaps + flexibility * found.forces - Eigen::VectorXd::Constant(n, found.closing);
      raise_to(worst, std::abs(found.forces.sum() - 1.));
      for (Eigen::Index k = 0; k < n; ++k)
        raise_to(worst, found.forces[k] > 0. ? std::abs(h[k]) : -h[k]);
    }
  check_below("cells of made-up flexibilities: gap of one that carries, penetration", worst, 1e-6);
}
/** A flexibility whose eigenvalues span seven decades: gradients stall, sets of loaded cells are
 * solved directly. The answer is the only one with closed loaded cells and no penetration. */
void check_ill_conditioned()
{
  const Eigen::Index n      = 800;
  double             seed   = .5;
  const auto         number = [&seed] {
    seed = std::fmod(997. * seed + .1234567, 1.);
    return seed - .5;
  };
  const Eigen::VectorXd v = Eigen::VectorXd::NullaryExpr(n, number).normalized();
  const Eigen::MatrixXd Q = Eigen::MatrixXd::Identity(n, n) - 2. * v * v.transpose();
  Eigen::VectorXd       values(n);
  for (Eigen::Index i = 0; i < n; ++i)
    values[i] = std::pow(10., -7. * i / (n - 1.));
  const Eigen::MatrixXd flexibility = Q * values.asDiagonal() * Q.transpose();
  // Gaps that a load on 100 cells closes, half of them with little force; elsewhere they are
  // open, some by little.
  Eigen::VectorXd wanted = Eigen::VectorXd::Zero(n), gaps = Eigen::VectorXd::Zero(n);
  for (Eigen::Index i = 0; i < 100; ++i)
    wanted[8 * i] = i % 2 == 0 ? 1.5 + number() : 1e-4 * (1. + number());
  gaps = 2. * Eigen::VectorXd::Ones(n) - flexibility * wanted;
  for (Eigen::Index i = 0; i < n; ++i)
    if (wanted[i] == 0.)
      gaps[i] += i % 8 == 1 ? 1e-6 : .6 + number();

  unsigned int     n_products = 0;
  const CellForces found      = find_cell_forces(
    [&](const Eigen::VectorXd &f) -> Eigen::VectorXd {
      ++n_products;
      return flexibility * f;
    },
    gaps,
    Eigen::VectorXd::Ones(n),
    wanted.sum());
  check("ill-conditioned cells: by sets", n_products > 600 + n && found.iterations > 0);
  check_close("ill-conditioned cells: closing", found.closing, 2., 1e-8);
  check_ratio("ill-conditioned cells: load", found.forces.sum() / wanted.sum(), 1e-8);
  // A penetration within 1e-8 of the deflections is none: cells with a gap of 1e-6 may be loaded
  // that much, which the flexible directions amplify.
  check_below("ill-conditioned cells: forces", (found.forces - wanted).lpNorm<1>() / n, 1e-6);
  double penetration = 0.;
  for (Eigen::Index i = 0; i < n; ++i)
    raise_to(penetration, wanted[i] > 0. ? std::abs(found.gaps[i]) : -found.gaps[i]);
  check_below("ill-conditioned cells: penetration", penetration, 1e-8);
}

int main()
{
  return run_parts({check_rectangle,
                    check_layer,
                    check_contacts,
                    check_punch,
                    check_line,
                    check_arms,
                    check_return,
                    check_ill_conditioned});
}
