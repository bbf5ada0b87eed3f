// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// Shafts whose bearings share a housing, beside dense equations in which the housing's seats have
// unknowns of their own: displacements, reactions and modes. Two shafts, one with the other held.
#include "../parts.h"
#include "../tests.h"

#include <vfife/bearing/shaft_seat.h>
#include <vfife/fem/modes/rotating_body.h>
#include <vfife/fem/statics/nodal_solution.h>
#include <vfife/fem/statics/static_solver.h>
#include <vfife/mesh/body_mesh.h>
#include <vfife/mesh/primitives/primitives.h>
#include <vfife/model/constraints/supports.h>
#include <vfife/model/load_shares.h>

#include <Eigen/Dense>

#include <random>

using namespace vfife;

using Matrix6 = Eigen::Matrix<double, 6, 6>;

/** A positive matrix that joins all of 6 n displacements [mm] and turns [rad]. */
Eigen::MatrixXd make_housing(const unsigned int n)
{
  std::mt19937                           random(7);
  std::uniform_real_distribution<double> between(-1., 1.);
  Eigen::MatrixXd                        root(6 * n, 6 * n);
  for (unsigned int i = 0; i < 6 * n; ++i)
    for (unsigned int j = 0; j < 6 * n; ++j)
      root(i, j) = between(random) * (i % 6 < 3 ? 100. : 3000.);
  return root * root.transpose() + Eigen::MatrixXd(3e3 * Eigen::MatrixXd::Identity(6 * n, 6 * n));
}

std::vector<unsigned int> outer_nodes(const Body &body, const double from, const double to)
{
  std::vector<unsigned int> nodes;
  for (const unsigned int node : body.node_set("outer"))
    if (body.node_positions()[node].z() > from - 1e-6 &&
        body.node_positions()[node].z() < to + 1e-6)
      nodes.push_back(node);
  return nodes;
}

void add_bearing(
  Model &model, const double from, const double to, const double radial, const Vector5 &preload)
{
  const unsigned int b = model.bodies.size() - 1;
  Matrix5            K = Vector5(radial, 1.7 * radial, .6 * radial, 4e6, 7e6).asDiagonal();
  K(0, 3) = K(3, 0) = 2e2 * std::sqrt(radial);
  Bearing bearing;
  bearing.name  = "bearing " + std::to_string(model.bearings.size());
  bearing.body  = b;
  bearing.nodes = outer_nodes(model.bodies[b], from, to);
  bearing.axes  = axes_along(model.bodies[b].axis.direction);
  bearing.law   = std::make_shared<LinearBearing>(K, Matrix5::Zero(), preload);
  model.bearings.push_back(bearing);
}

/** Hollow shafts of 80 mm side by side, each driven at its end. */
Model make_shafts(const unsigned int n)
{
  Vector5 preload;
  preload << 300., -200., 500., 4000., -1000.;
  Model model;
  for (unsigned int b = 0; b < n; ++b)
    {
      Body shaft("shaft " + std::to_string(b), make_ring(6., 12., 80., {{1, 8, 8}}), {});
      shaft.placement.translation = Vector3(60. * b, 0., 0.);
      if (b == 1)
        shaft.placement.rotation = rotation_about(Vector3::UnitX(), .5);
      shaft.axis   = {shaft.placement.translation, shaft.placement.rotation.col(2)};
      shaft.floats = true;
      model.add_body(std::move(shaft));
      add_bearing(model, 10., 20., 2e4 * (b + 1), preload);
      if (n == 1)
        add_bearing(model, 60., 70., 5e4, Vector5::Zero());
      model.couplings.push_back(
        {"drive", b, outer_nodes(model.bodies[b], 75., 80.), 3e6 * (b + 1), 0.});
    }
  model.housing = make_housing(model.bearings.size());
  return model;
}

/** All displacements of all bodies, then those of the housing's seats. */
class Dense
{
public:
  Dense(const Model &model, const FemSpace &points)
    : model_(model)
    , n_(3 * points.n_points())
    , K(Eigen::MatrixXd::Zero(n_ + 6 * model.bearings.size(), n_ + 6 * model.bearings.size()))
    , M(Eigen::MatrixXd::Zero(n_, n_))
    , load(Eigen::VectorXd::Zero(K.rows()))
  {
    for (unsigned int e = 0; e < points.n_elements(); ++e)
      {
        const Eigen::MatrixXd
          k = compute_fem_stiffness(points.element_nodes(e), points.material(e), points.element()),
          m = expand_coefficients(compute_mass_coefficients(points.element_nodes(e),
                                                            points.material(e).density,
                                                            MassKind::consistent),
                                  Matrix3::Identity());
        const auto row = [&](const unsigned int i) {
          return 3 * points.element_points(e)[i / 3] + i % 3;
        };
        for (unsigned int i = 0; i < 24; ++i)
          for (unsigned int j = 0; j < 24; ++j)
            {
              K(row(i), row(j)) += k(i, j);
              M(row(i), row(j)) += m(i, j);
            }
      }
    K.bottomRightCorner(model.housing.rows(), model.housing.cols()) += model.housing;
    for (std::size_t s = 0; s < model.bearings.size(); ++s)
      {
        // q = P (B u - h)
        const Bearing              &bearing = model.bearings[s];
        const BearingResponse       law     = bearing.law->linearized();
        Eigen::Matrix<double, 5, 6> P       = Eigen::Matrix<double, 5, 6>::Zero();
        P.topLeftCorner<3, 3>()             = bearing.axes.transpose();
        P.bottomRightCorner<2, 3>()         = bearing.axes.leftCols<2>().transpose();
        Eigen::MatrixXd q                   = P * motion(points, bearing.body, bearing.nodes);
        q.middleCols<6>(n_ + 6 * s) -= P;
        K += q.transpose() * law.stiffness * q;
        load += q.transpose() * law.load;
        ways.push_back(q);
      }
    for (const Coupling &coupling : model.couplings)
      {
        const Eigen::RowVectorXd turn = model.bodies[coupling.body].axis.direction.transpose() *
                                        motion(points, coupling.body, coupling.nodes).bottomRows(3);
        K += coupling.stiffness * turn.transpose() * turn;
      }
  }

  /** Without the rows of a body. */
  Eigen::VectorXd solve(const Eigen::VectorXd &nodal, const unsigned int held_from) const
  {
    Eigen::VectorXd f = load;
    f.head(n_) += nodal;
    std::vector<int> rows;
    for (int i = 0; i < K.rows(); ++i)
      if (i < int(held_from) || i >= n_)
        rows.push_back(i);
    const Eigen::VectorXd found = K(rows, rows).ldlt().solve(f(rows));
    Eigen::VectorXd       x     = Eigen::VectorXd::Zero(K.rows());
    x(rows)                     = found;
    return x;
  }

  /** Natural frequencies [Hz]; the housing has no mass. */
  Eigen::VectorXd frequencies() const
  {
    const auto            h = K.rows() - n_;
    const Eigen::MatrixXd condensed =
      K.topLeftCorner(n_, n_) -
      K.topRightCorner(n_, h) * K.bottomRightCorner(h, h).ldlt().solve(K.bottomLeftCorner(h, n_));
    const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> modes(condensed, M);
    return modes.eigenvalues().cwiseSqrt() / (2 * pi);
  }

  Vector5 load_of(const std::size_t bearing, const Eigen::VectorXd &x) const
  {
    const BearingResponse law = model_.bearings[bearing].law->linearized();
    return law.load - law.stiffness * ways[bearing] * x;
  }

private:
  /** Of the ring's centre, six rows over all unknowns. */
  Eigen::MatrixXd
  motion(const FemSpace &points, const unsigned int b, const std::vector<unsigned int> &nodes) const
  {
    const Body                &body   = model_.bodies[b];
    const std::vector<double>  areas  = compute_area_shares(body, nodes);
    const std::vector<Vector3> places = find_undeformed_places(body, nodes);
    Vector3                    centre = Vector3::Zero();
    for (std::size_t i = 0; i < nodes.size(); ++i)
      centre += areas[i] * places[i];
    Matrix3         J   = Matrix3::Zero();
    Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(6, K.cols());
    for (std::size_t i = 0; i < nodes.size(); ++i)
      {
        const Vector3 r = places[i] - centre;
        Matrix3       cross;
        cross << 0., -r[2], r[1], r[2], 0., -r[0], -r[1], r[0], 0.;
        J += areas[i] * (r.squaredNorm() * Matrix3::Identity() - r * r.transpose());
        const auto column = 3 * (points.find_part(b)->first_point + nodes[i]);
        sum.block<3, 3>(0, column) += areas[i] * Matrix3::Identity();
        sum.block<3, 3>(3, column) += areas[i] * cross;
      }
    sum.bottomRows<3>() = (J.inverse() * sum.bottomRows<3>()).eval();
    return sum;
  }

  const Model                 &model_;
  int                          n_;
  Eigen::MatrixXd              K, M;
  Eigen::VectorXd              load;
  std::vector<Eigen::MatrixXd> ways;
};

/** A force askew on some nodes of the first shaft. */
std::vector<Vector3> make_forces(const Model &model)
{
  std::vector<Vector3> forces(model.n_nodes(), Vector3::Zero());
  for (const unsigned int node : outer_nodes(model.bodies[0], 40., 50.))
    forces[node] = Vector3(30., -70., 20.);
  return forces;
}

void compare(const std::string               &name,
             const Model                     &model,
             const std::vector<unsigned int> &bodies,
             const Communicator              &world)
{
  FemOptions fem;
  fem.linear_solver = LinearSolverKind::direct;
  const StaticSolver solver(model, bodies, fem, world);
  StaticLoads        loads;
  loads.nodal_forces        = make_forces(model);
  const StaticResult result = solver.solve(loads);

  std::vector<unsigned int> all(model.bodies.size());
  for (unsigned int b = 0; b < all.size(); ++b)
    all[b] = b;
  const FemSpace  points(model, all, FemElement::incompatible_modes);
  const Dense     dense(model, points);
  Eigen::VectorXd nodal(3 * points.n_points());
  for (unsigned int i = 0; i < points.n_points(); ++i)
    nodal.segment<3>(3 * i) = loads.nodal_forces[i];
  const int             n = result.displacements.size();
  const Eigen::VectorXd x = dense.solve(nodal, n);
  check_below(
    name + ": displacements",
    (Eigen::Map<const Eigen::VectorXd>(result.displacements.data(), n) - x.head(n)).norm() /
      x.head(n).norm(),
    1e-8);
  const auto reactions = compute_reactions(solver.space(), result);
  const auto first     = first_bearing(model);
  double     apart = 0, largest = 0;
  for (std::size_t s = 0; s < model.bearings.size(); ++s)
    if (model.bearings[s].body < bodies.size())
      {
        const Vector3 force = model.bearings[s].axes * dense.load_of(s, x).head<3>();
        raise_to(apart, (reactions[first + s].force - force).norm());
        largest = std::max(largest, force.norm());
      }
  // A shaft that nothing loads is held by none.
  check_below(name + ": forces of the bearings", apart / largest, 1e-8);
}

void beam(Communicator &world)
{
  Model model = make_shafts(1);
  compare("two bearings", model, {0}, world);

  const FemSpace points(model, {0}, FemElement::incompatible_modes);
  FemOptions     fem;
  fem.n_modes                        = 6;
  const Eigen::VectorXd     expected = Dense(model, points).frequencies();
  const ModesAtSpeed        found    = RotatingBody(model, 0, fem, world).find_modes(0.);
  const std::vector<double> kept     = {expected[0], expected[5]};
  double                    apart    = 0;
  for (unsigned int k = 0; k < 6; ++k)
    raise_to(apart, std::abs(found.modes[k].frequency / expected[k] - 1));
  check_below("two bearings: six lowest modes", apart, 1e-7);
  model.housing.resize(0, 0);
  const ModesAtSpeed rigid = RotatingBody(model, 0, fem, world).find_modes(0.);
  check("a rigid housing makes other modes", std::abs(rigid.modes[0].frequency / kept[0] - 1) > .1);
}

void two_shafts(Communicator &world)
{
  const Model model = make_shafts(2);
  compare("two shafts", model, {0, 1}, world);
  compare("one, the other held", model, {0}, world);
}

/** One sector of a shaft whose bearings, alike across the axis, share a housing that is. */
void sector(Communicator &world)
{
  Model model = make_shafts(1);
  for (Bearing &bearing : model.bearings)
    {
      const Matrix5 K = Vector5(3e4, 3e4, 1e4, 4e6, 4e6).asDiagonal();
      bearing.law     = std::make_shared<LinearBearing>(K, Matrix5::Zero(), Vector5::Zero());
    }
  model.housing.setZero();
  for (unsigned int i = 0; i < 12; ++i)
    for (const unsigned int j : {i, (i + 6) % 12})
      model.housing(i, j) = (i % 6 < 3 ? 2e4 : 3e6) * (i % 3 == 2 ? 2. : 1.) * (i == j ? 1. : -.6);
  FemOptions fem;
  fem.n_modes           = 10;
  const auto whole      = RotatingBody(model, 0, fem, world).find_modes(0.);
  fem.cyclic_symmetry   = true;
  const auto of_sectors = RotatingBody(model, 0, fem, world).find_modes(0.);
  double     apart      = 0;
  for (unsigned int k = 0; k < 10; ++k)
    raise_to(apart, std::abs(of_sectors.modes[k].frequency / whole.modes[k].frequency - 1));
  check_below("one sector: frequencies", apart, 1e-8);
}

/** The mean by many turns: of one body with both its rings, of two bodies each by itself. */
void mean(Communicator &)
{
  Model model = make_shafts(2);
  add_bearing(model, 60., 70., 5e4, Vector5::Zero());
  model.housing = make_housing(3);
  const FemSpace         points(model, {0, 1}, FemElement::incompatible_modes);
  const BearingRings     rings(points);
  const auto             at_rest = [](unsigned int) { return 0.; };
  const Eigen::MatrixXd  K       = rings.stiffness(at_rest);
  constexpr unsigned int n       = 9;
  Eigen::MatrixXd        both = Eigen::MatrixXd::Zero(K.rows(), K.cols()), one = both;
  for (unsigned int i = 0; i < n; ++i)
    for (unsigned int j = 0; j < n; ++j)
      {
        Eigen::MatrixXd T = Eigen::MatrixXd::Identity(K.rows(), K.cols());
        for (unsigned int r = 0; r < rings.list().size(); ++r)
          {
            const unsigned int b = rings.list()[r].body;
            for (const unsigned int half : {0u, 3u})
              T.block<3, 3>(6 * r + half, 6 * r + half) =
                rotation_about(model.bodies[b].axis.direction, 2 * pi / n * (b == 0 ? i : j));
          }
        both += T * K * T.transpose() / (n * n);
        if (i == 0)
          one += T * K * T.transpose() / n;
      }
  check_below("mean over turns of both",
              (rings.stiffness([](unsigned int) { return 1.; }) - both).norm() / K.norm(),
              1e-12);
  check_below("mean over turns of the second",
              (rings.stiffness([](const unsigned int b) { return double(b); }) - one).norm() /
                K.norm(),
              1e-12);
  check("bodies that turn feel each other along their axes",
        both.block<3, 3>(0, 6).norm() > .01 * K.block<3, 3>(0, 6).norm() &&
          both.block<3, 3>(0, 6).norm() < .9 * K.block<3, 3>(0, 6).norm());
  // Undisplaced seats in balance with their housing, as found by Newton's method.
  const BearingSystem   system = make_bearing_system(model);
  const auto            exact  = system.evaluate(std::vector<Vector5>(3, Vector5::Zero()));
  const Eigen::VectorXd load   = system.linearized().load;
  double                apart  = 0;
  for (std::size_t s = 0; s < 3; ++s)
    raise_to(apart,
             (load.segment<3>(6 * s) - model.bearings[s].axes * exact.loads[s].head<3>()).norm());
  check_below("loads of undisplaced shafts [N]", apart, 1e-8);
}

int main(int argc, char **argv)
{
  run_parts<Communicator>(argc, argv, {beam, two_shafts, sector, mean});
  return 0;
}
