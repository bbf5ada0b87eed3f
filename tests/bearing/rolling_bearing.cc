// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// Rolling bearings: loads and stiffness as slopes of the energy, closed forms of Stribeck and
// Harris, usual estimates of stiffness.
#include "../refusal.h"
#include "../tests.h"

#include <vfife/bearing/rolling_bearing.h>

#include <Eigen/Eigenvalues>

using namespace vfife;

RollingBearingData balls(const unsigned int n = 16)
{
  RollingBearingData data;
  data.n              = n;
  data.diameter       = 10;
  data.pitch_diameter = 60;
  return data;
}

RollingBearingData rollers(const unsigned int n = 20)
{
  RollingBearingData data = balls(n);
  data.element            = RollingElement::roller;
  data.diameter           = 8;
  data.length             = 12;
  return data;
}

RollingBearing make(const RollingBearingData &data)
{
  return {data, Matrix5::Zero()};
}

/** Load against slopes of the energy and stiffness against slopes of the load, at a displacement
 * under which some elements carry and others do not. */
void slopes(const std::string &name, const RollingBearingData &data)
{
  const RollingBearing bearing = make(data);
  Vector5              q;
  q << .012, -.007, .009 * data.sense, 4e-4, -2e-4;
  const BearingResponse here = bearing.evaluate(q);
  double                load = 0, stiffness = 0;
  for (unsigned int i = 0; i < 5; ++i)
    {
      const double          h    = i < 3 ? 1e-6 : 1e-8;
      const BearingResponse plus = bearing.evaluate(q + h * Vector5::Unit(i)),
                            less = bearing.evaluate(q - h * Vector5::Unit(i));
      // By the energy of a way on the stiffness: a cylindrical bearing has no axial load at all.
      const double scale = std::sqrt(2 * here.energy * bearing.stiffness_bound()(i, i));
      raise_to(load, std::abs((plus.energy - less.energy) / (2 * h) + here.load[i]) / scale);
      const Vector5 column = -(plus.load - less.load) / (2 * h);
      for (unsigned int j = 0; j < 5; ++j)
        raise_to(stiffness,
                 std::abs(column[j] - here.stiffness(j, i)) /
                   std::sqrt(bearing.stiffness_bound()(i, i) * bearing.stiffness_bound()(j, j)));
    }
  check_below(name + ": load less the slope of the energy", load, 1e-6);
  check_below(name + ": stiffness less the slope of the load", stiffness, 1e-4);
  const auto   forces = bearing.element_forces(q);
  const double least  = *std::min_element(forces.begin(), forces.end()),
               most   = *std::max_element(forces.begin(), forces.end());
  check(name + ": some elements carry nothing", least == 0 && most > 0);
  Eigen::SelfAdjointEigenSolver<Matrix5> bound(bearing.stiffness_bound() - here.stiffness);
  check(name + ": the bound is stiffer", bound.eigenvalues().minCoeff() > 0);
}

/** A cage that rolls: the slope of the energy with the turn, the same after a pitch of the
 * elements and another half-way, at the speed of elements between a turning inner and a fixed
 * outer ring. */
void cage(const std::string &name, RollingBearingData data)
{
  const RollingBearing fixed = make(data);
  data.cage_rolls            = true;
  const RollingBearing rolls = make(data);
  Vector5              q;
  q << .012, -.007, .009 * data.sense, 4e-4, -2e-4;
  const double turn = .3, h = 1e-5;
  check_ratio(name + ": slope of the energy with the turn, over differences",
              rolls.evaluate(q, turn).turn_slope * 2 * h /
                (rolls.evaluate(q, turn + h).energy - rolls.evaluate(q, turn - h).energy),
              1e-5);
  // Without slip: middle of an element at half the speed of the inner race's contact, on a circle
  // of the pitch diameter.
  const double race = data.pitch_diameter - data.diameter * std::cos(data.contact_angle);
  check_close(name + ": share of the shaft's turn",
              rolls.cage_share(),
              .5 * race / data.pitch_diameter,
              1e-14);
  const double pitch = 2 * pi / data.n / rolls.cage_share();
  const auto   apart = [&](const double further) {
    return (rolls.evaluate(q, turn + further).stiffness - rolls.evaluate(q, turn).stiffness)
             .topLeftCorner<3, 3>()
             .norm() /
           rolls.evaluate(q, turn).stiffness.topLeftCorner<3, 3>().norm();
  };
  check_below(name + ": stiffness after a pitch of the elements", apart(pitch), 1e-10);
  check(name + ": another half-way", apart(.5 * pitch) > 1e-4);
  check(name + ": a fixed cage leaves all alike",
        fixed.evaluate(q, turn).load == fixed.evaluate(q).load &&
          fixed.evaluate(q, turn).turn_slope == 0 && fixed.cage_share() == 0);
}

/** F = n Q_max J, J = 1/(2 pi) int cos^(1 + e) over half the circle, without clearance (Stribeck,
 * 4.37 for balls and 4.08 for rollers as 1/J); many elements stand for the integral. */
void stribeck(const std::string &name, const RollingBearingData &data, const double exponent)
{
  const RollingBearing bearing = make(data);
  const double         F       = 2000;
  const Vector3        way     = bearing.displacement_under(Vector3(F, 0., 0.));
  Vector5              q;
  q << way, 0., 0.;
  const auto   forces = bearing.element_forces(q);
  const double p      = exponent + 1;
  const double J      = std::tgamma(.5 * (p + 1)) / (2 * std::sqrt(pi) * std::tgamma(.5 * p + 1));
  check_ratio(name + ": largest force over F/(n J)",
              *std::max_element(forces.begin(), forces.end()) * data.n * J / F,
              2e-3);
  check_below(name + ": the shaft moves along the force [mm]", std::hypot(way[1], way[2]), 1e-9);
}

/** Axial load of an angular contact bearing (Harris): F/(n K A0^1.5) = sin a (cos a0/cos a -
 * 1)^1.5, the way is A0 sin(a - a0)/cos a. K from the same bearing's single ball. */
void axial()
{
  RollingBearingData data      = balls();
  data.contact_angle           = 40 * pi / 180;
  data.sense                   = -1;
  const RollingBearing bearing = make(data);
  const double         F       = 5000;
  const Vector3        way     = bearing.displacement_under(Vector3(0., 0., -F));
  Vector5              q;
  q << way, 0., 0.;
  const double A0 = .04 * data.diameter, a0 = data.contact_angle;
  // The angle at which the groove centres have come to lie, from the way.
  const double a = std::atan2(A0 * std::sin(a0) - way[2], A0 * std::cos(a0));
  check_ratio("axial: force of a ball over F/(n sin a)",
              bearing.element_forces(q)[3] * data.n * std::sin(a) / F,
              1e-8);
  const double depth = A0 * (std::cos(a0) / std::cos(a) - 1);
  // Hertz's constant from a small radial way of a bearing without contact angle is another one,
  // as the races' curvatures go with cos a0: here by the force alone, at half the load.
  const Vector3 half   = bearing.displacement_under(Vector3(0., 0., -.5 * F));
  const double  a2     = std::atan2(A0 * std::sin(a0) - half[2], A0 * std::cos(a0));
  const double  depth2 = A0 * (std::cos(a0) / std::cos(a2) - 1);
  check_close("axial: two loads by the closed form",
              std::sin(a2) * std::pow(depth2, 1.5) / (std::sin(a) * std::pow(depth, 1.5)),
              .5,
              1e-8);
  check("axial: the angle has grown", a > a0 + .01);
  check_below("axial: held the other way by nothing [N]", bearing.evaluate(-q).load.norm(), 1e-300);
}

void estimates()
{
  // Palmgren for steel balls in usual grooves: way = 4.36e-4 (Q^2/D)^(1/3) [N, mm].
  RollingBearingData data = balls();
  data.inner_conformity = data.outer_conformity = .515;
  const RollingBearing ball                     = make(data);
  const double         F                        = 3000;
  Vector5              q;
  q << ball.displacement_under(Vector3(F, 0., 0.)), 0., 0.;
  const double Q = ball.element_forces(q)[0];
  check_ratio("estimates: way of a ball bearing over Palmgren's",
              q[0] / (4.36e-4 * std::cbrt(Q * Q / data.diameter)),
              .08);
  // Radial stiffness as rotor dynamics estimates it, 13e6 n^(2/3) d^(1/3) F^(1/3) and
  // 1e9 n^0.9 l^0.8 F^0.1 [N/m; m, N].
  check_ratio("estimates: radial stiffness of the ball bearing",
              ball.evaluate(q).stiffness(0, 0) /
                (13e3 * std::pow(16., 2. / 3.) * std::cbrt(.01 * F)),
              .15);
  const RollingBearing roller = make(rollers());
  q << roller.displacement_under(Vector3(F, 0., 0.)), 0., 0.;
  check_ratio("estimates: radial stiffness of the roller bearing",
              roller.evaluate(q).stiffness(0, 0) /
                (1e6 * std::pow(20., .9) * std::pow(.012, .8) * std::pow(F, .1)),
              .15);
}

void preload()
{
  RollingBearingData data      = rollers();
  data.contact_angle           = 15 * pi / 180;
  data.preload                 = 700;
  const RollingBearing tapered = make(data);
  const Vector5        load    = tapered.evaluate(Vector5::Zero()).load;
  check_close("preload: axial force [N]", load[2], -700., 1e-8);
  check_below("preload: nothing else [N, N mm]",
              std::max(load.head<2>().norm(), load.tail<2>().norm()),
              1e-6);
  // n Q sin a = F, and the line's depth is the way times sin a: closed.
  const double Q = 700 / (20 * std::sin(data.contact_angle));
  check_ratio("preload: force of a roller over F/(n sin a)",
              tapered.element_forces(Vector5::Zero())[7] / Q,
              1e-8);
  check_close("preload: axial stiffness over 10/9 F/way",
              tapered.evaluate(Vector5::Zero()).stiffness(2, 2) * 7.68e-5 * std::pow(Q, .9) /
                std::pow(12., .8) / std::sin(data.contact_angle) / 700,
              10. / 9.,
              1e-8);
  // Linearized under a load: at that load it stands still.
  data.working_load                = Vector3(1500., 0., 900.);
  const RollingBearing  working    = make(data);
  const BearingResponse linearized = working.linearized();
  Vector5               q, at_load = Vector5::Zero();
  q << working.displacement_under(data.working_load), 0., 0.;
  at_load = linearized.load - linearized.stiffness * q;
  check_below("working load: the linear law has it there [N]",
              (at_load.head<3>() + data.working_load).norm(),
              1e-5);
}

void refusals()
{
  const auto refuse = [](const auto &change) {
    RollingBearingData data = balls();
    change(data);
    print_refusal([&] { make(data); });
  };
  refuse([](auto &data) { data.n = 2; });
  refuse([](auto &data) { data.n = 19; });
  refuse([](auto &data) { data.pitch_diameter = 9; });
  refuse([](auto &data) { data.inner_conformity = .5; });
  refuse([](auto &data) { data.element = RollingElement::roller; });
  refuse([](auto &data) { data.preload = 100; });
  refuse([](auto &data) {
    data.contact_angle = .3;
    data.preload       = 1e9;
  });
  refuse([](auto &data) {
    data              = rollers();
    data.working_load = Vector3(0., 0., 10.);
  });
}

int main()
{
  RollingBearingData angular = balls();
  angular.contact_angle      = .4;
  RollingBearingData tapered = rollers();
  tapered.contact_angle      = .25;
  tapered.sense              = -1;
  slopes("deep groove", balls());
  slopes("angular contact", angular);
  slopes("cylindrical", rollers());
  slopes("tapered", tapered);
  cage("cage of the deep groove bearing", balls(9));
  cage("cage of the angular contact bearing", angular);
  cage("cage of the cylindrical bearing", rollers(11));
  cage("cage of the tapered bearing", tapered);
  RollingBearingData many = balls(18), more = rollers(23);
  stribeck("balls", many, 1.5);
  stribeck("rollers", more, 10. / 9.);
  axial();
  estimates();
  preload();
  refusals();
  return 0;
}
