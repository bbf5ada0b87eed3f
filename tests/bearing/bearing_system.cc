// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// Bearings in a housing: linear ones by springs in series, all loads as slopes of the energy, and
// matrices that are none of a housing.
#include "../parts.h"
#include "../refusal.h"
#include "../tests.h"

#include <vfife/base/parameters/parameter_matrix.h>
#include <vfife/bearing/bearing_system.h>
#include <vfife/bearing/rolling_bearing.h>
#include <vfife/bearing/shaft_seat.h>

#include <Eigen/Cholesky>

#include <fstream>
#include <random>

using namespace vfife;

std::shared_ptr<const BearingLaw> linear(const double radial, const double axial)
{
  Vector5 k;
  k << radial, 1.5 * radial, axial, 4e6, 5e6;
  return std::make_shared<LinearBearing>(Matrix5(k.asDiagonal()),
                                         Matrix5(Matrix5::Zero()),
                                         Vector5(Vector5::Zero()));
}

std::shared_ptr<const BearingLaw> balls()
{
  RollingBearingData data;
  data.n              = 12;
  data.diameter       = 9.;
  data.pitch_diameter = 60.;
  data.contact_angle  = .3;
  data.preload        = 400.;
  return std::make_shared<RollingBearing>(data, Matrix5(Matrix5::Zero()));
}

/** A housing that couples all seats: positive, as its square root is. */
Eigen::MatrixXd housing(const unsigned int n)
{
  std::mt19937                           random(7);
  std::uniform_real_distribution<double> between(-1., 1.);
  Eigen::MatrixXd                        root(6 * n, 6 * n);
  for (unsigned int i = 0; i < 6 * n; ++i)
    for (unsigned int j = 0; j < 6 * n; ++j)
      root(i, j) = between(random) * (i % 6 < 3 ? 150. : 2500.);
  return root * root.transpose() + Eigen::MatrixXd(1e4 * Eigen::MatrixXd::Identity(6 * n, 6 * n));
}

BearingSystem make_system()
{
  return BearingSystem({{axes_along(Vector3(1., 2., -1.).normalized()), linear(2e4, 1e4)},
                        {axes_along(Vector3::UnitX()), balls()},
                        {axes_along(Vector3(0., 1., 1.).normalized()), linear(5e4, 0.)}});
}

std::vector<Vector5> some_displacements(const double size)
{
  std::vector<Vector5> q(3);
  q[0] << .01, -.02, .015, 1e-4, 3e-4;
  q[1] << .004, .006, .008, -2e-4, 1e-4;
  q[2] << -.012, .003, .02, 2e-4, -1e-4;
  for (Vector5 &one : q)
    one *= size;
  return q;
}

void ground()
{
  const BearingSystem system   = make_system();
  const auto          q        = some_displacements(1.);
  const auto          response = system.evaluate(q);
  const auto          alone    = balls()->evaluate(q[1]);
  check("without a housing: the law itself", response.loads[1] == alone.load);
  check("without a housing: no seat feels another",
        response.stiffness.block<5, 5>(5, 5) == alone.stiffness &&
          response.stiffness.block(0, 5, 5, 10).isZero(0.));
}

void series()
{
  // Two linear bearings with one axis: the compliances of both and of the housing add up.
  const Matrix3 axes = axes_along(Vector3(2., -1., 2.).normalized());
  BearingSystem system({{axes, linear(2e4, 1e4)}, {axes, linear(3e4, 4e4)}});
  system.set_housing(housing(2));
  Eigen::MatrixXd reading = Eigen::MatrixXd::Zero(10, 12), bearings(10, 10);
  bearings.setZero();
  for (unsigned int s = 0; s < 2; ++s)
    {
      reading.block<3, 3>(5 * s, 6 * s)         = axes.transpose();
      reading.block<2, 3>(5 * s + 3, 6 * s + 3) = axes.leftCols<2>().transpose();
      bearings.block<5, 5>(5 * s, 5 * s) =
        linear(s == 0 ? 2e4 : 3e4, s == 0 ? 1e4 : 4e4)->linearized().stiffness;
    }
  const Eigen::MatrixXd both =
    (bearings.inverse() + reading * housing(2).inverse() * reading.transpose()).inverse();
  std::vector<Vector5> q = some_displacements(1.);
  q.pop_back();
  Eigen::VectorXd all(10);
  all << q[0], q[1];
  const auto            response = system.evaluate(q);
  const Eigen::VectorXd loads    = -both * all;
  Eigen::VectorXd       found(10);
  found << response.loads[0], response.loads[1];
  check_below("linear bearings: loads by springs in series",
              (found - loads).norm() / loads.norm(),
              1e-10);
  check_below("linear bearings: stiffness, seats coupled",
              (response.stiffness - both).norm() / both.norm(),
              1e-10);
  check_close("linear bearings: energy", response.energy, .5 * all.dot(both * all), 1e-10);
  check("linear bearings: the housing couples them",
        both.block<5, 5>(0, 5).norm() > .02 * both.norm());
  const Eigen::MatrixXd in_space = reading.transpose() * both * reading;
  check_below("linear bearings: stiffness along the fixed axes",
              (system.linearized().stiffness - in_space).norm() / in_space.norm(),
              1e-10);
  // A housing of steel blocks is the ground.
  system.set_housing(1e9 * housing(2));
  check_below("a stiff housing is the ground",
              (system.evaluate(q).loads[0] + bearings.topLeftCorner<5, 5>() * q[0]).norm() /
                (bearings.topLeftCorner<5, 5>() * q[0]).norm(),
              1e-5);
}

/** Few balls with clearance, some of them unloaded, whose cage rolls: the housing follows them.
 */
void rolling_cage()
{
  RollingBearingData data;
  data.n              = 7;
  data.diameter       = 14.;
  data.pitch_diameter = 70.;
  data.clearance      = .02;
  data.cage_rolls     = true;
  BearingSystem system({{axes_along(Vector3(1., 2., -1.).normalized()), linear(2e4, 1e4)},
                        {axes_along(Vector3::UnitX()),
                         std::make_shared<RollingBearing>(data, Matrix5(Matrix5::Zero()))}});
  system.set_housing(1e2 * housing(2));
  std::vector<Vector5> q = some_displacements(1.);
  q.pop_back();
  q[1] << .06, -.02, 0., 1e-4, 0.;
  const auto   energy = [&](const double turn) { return system.evaluate(q, {.2, turn}).energy; };
  const double turn = .7, h = 1e-4;
  const auto   response = system.evaluate(q, {.2, turn});
  check_ratio("rolling cage: slope of the energy over differences",
              response.turn_slopes[1] * 2 * h / (energy(turn + h) - energy(turn - h)),
              1e-4);
  check("rolling cage: the energy changes", std::abs(energy(turn + .5) / energy(turn) - 1) > 1e-5);
  check("rolling cage: a linear bearing does not feel its turn", response.turn_slopes[0] == 0);
}

void slopes()
{
  BearingSystem system = make_system();
  system.set_housing(housing(3));
  // Square roots of stiffnesses of this size [N/mm, N mm].
  const auto unit = [](const unsigned int i) { return i % 5 < 3 ? 100. : 2000.; };
  for (const double size : {.3, 1.})
    {
      const auto q          = some_displacements(size);
      const auto response   = system.evaluate(q);
      double     worst_load = 0, worst_stiffness = 0;
      for (unsigned int i = 0; i < 15; ++i)
        {
          const double step  = i % 5 < 3 ? 1e-6 : 1e-8;
          auto         above = q, below = q;
          above[i / 5][i % 5] += step;
          below[i / 5][i % 5] -= step;
          const auto   a = system.evaluate(above), b = system.evaluate(below);
          const double scale = i % 5 < 3 ? 1000. : 30000.; // N, N mm
          worst_load =
            largest_of(worst_load,
                       std::abs((a.energy - b.energy) / (2 * step) + response.loads[i / 5][i % 5]) /
                         scale);
          for (unsigned int j = 0; j < 15; ++j)
            {
              const double slope = -(a.loads[j / 5][j % 5] - b.loads[j / 5][j % 5]) / (2 * step);
              raise_to(worst_stiffness,
                       std::abs(slope - response.stiffness(j, i)) / (unit(i) * unit(j)));
            }
        }
      const std::string name = size < 1 ? "small: " : "large: ";
      check_below(name + "loads are slopes of the energy", worst_load, 1e-5);
      check_below(name + "stiffness is the slope of the loads", worst_stiffness, 1e-5);
      // What the bearings put on the housing is what it gives back.
      Eigen::VectorXd pushed = housing(3) * response.housing;
      const auto      axes   = {axes_along(Vector3(1., 2., -1.).normalized()),
                                axes_along(Vector3::UnitX()),
                                axes_along(Vector3(0., 1., 1.).normalized())};
      unsigned int    s      = 0;
      for (const Matrix3 &a : axes)
        {
          pushed.segment<3>(6 * s) += a * response.loads[s].head<3>();
          pushed.segment<3>(6 * s + 3) += a.leftCols<2>() * response.loads[s].tail<2>();
          ++s;
        }
      check_below(name + "the housing is in balance", pushed.norm(), 1e-6);
    }
}

void refusals()
{
  BearingSystem   system = make_system();
  Eigen::MatrixXd K      = housing(3);
  print_refusal([&] { system.set_housing(housing(2)); });
  K(2, 5) *= 1.01;
  print_refusal([&] { system.set_housing(K); });
  K = housing(3);
  K.row(4) *= 0.;
  K.col(4) *= 0.;
  print_refusal([&] { system.set_housing(K); });
  K       = Eigen::MatrixXd::Identity(18, 18);
  K(0, 1) = K(1, 0) = 2.;
  print_refusal([&] { system.set_housing(K); });
}

/** The file @p text as a matrix; what is wrong with it is printed. */
void read(const std::string &name, const std::string &text)
{
  std::ofstream("matrix.mtx") << text;
  std::cout << name << ": ";
  print_refusal([] { read_parameter_matrix("matrix.mtx"); });
}

void files()
{
  std::ofstream("by_place.mtx") << "%%MatrixMarket matrix coordinate real symmetric\n% comment\n"
                                   "3 3 4\n1 1 2.5\n2 2 1\n3 3 4e3\n3 1 -7\n";
  std::ofstream("array.mtx") << "%%MatrixMarket matrix array real general\n2 2\n1\n2\n3\n4\n";
  Eigen::Matrix3d expected;
  expected << 2.5, 0, -7, 0, 1, 0, -7, 0, 4e3;
  check("a file by places, symmetric", read_parameter_matrix("by_place.mtx") == expected);
  Eigen::Matrix2d square;
  square << 1, 3, 2, 4;
  check("a file of all entries, column by column", read_parameter_matrix("array.mtx") == square);
  const std::string header = "%%MatrixMarket matrix coordinate real symmetric\n";
  read("no header", "3 3 4\n");
  read("too few entries", header + "3 3 2\n1 1 2.5\n");
  read("too many entries", header + "3 3 1\n1 1 2.5\n2 2 1\n");
  read("a place outside", header + "3 3 1\n4 1 2.5\n");
  read("the upper triangle", header + "3 3 1\n1 2 2.5\n");
  read("no number", header + "3 3 1\n1 1 two\n");
  read("complex", "%%MatrixMarket matrix coordinate complex symmetric\n");
  std::cout << "no file: ";
  print_refusal([] { read_parameter_matrix("nowhere.mtx"); });
}

int main()
{
  return run_parts({ground, series, rolling_cage, slopes, refusals, files});
}
