// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// A seat on a shaft that has turned far and is tilted: displacements, tilts and twist read from its
// nodes, and forces that work on nothing else.
#include "../parts.h"
#include "../tests.h"

#include <vfife/bearing/shaft_seat.h>

using namespace vfife;

/** Twelve nodes of a slanted ring. */
struct Ring
{
  Matrix3              axes = rotation_about(Vector3(1., 2., -1.).normalized(), .7);
  std::vector<Vector3> places, way;
  MeanMotion           set;
  ShaftSeat            seat;

  Ring()
    : places(make_places(axes))
    , set(std::vector<double>(places.size(), 2.), places, "ring")
    , seat(axes)
  {
    for (std::size_t i = 0; i < places.size(); ++i)
      way.emplace_back(std::cos(2. * i), std::sin(11. * i), std::cos(13. * i + 2.));
  }

  static std::vector<Vector3> make_places(const Matrix3 &axes)
  {
    std::vector<Vector3> places;
    for (unsigned int i = 0; i < 12; ++i)
      {
        const double angle = pi / 6. * i;
        places.push_back(Vector3(100., 50., -20.) + axes * Vector3(20. * std::cos(angle),
                                                                   20. * std::sin(angle),
                                                                   i % 2 == 0 ? 5. : -5.));
      }
    return places;
  }

  /** Where the nodes are after @p turn of the ring about its centre, moved and strained. */
  std::vector<Vector3> moved(const Matrix3 &turn, const Vector3 &shift, const double part) const
  {
    std::vector<Vector3> there;
    for (std::size_t i = 0; i < places.size(); ++i)
      there.push_back(Vector3(100., 50., -20.) + shift +
                      turn * (places[i] - Vector3(100., 50., -20.)) + part * way[i]);
    return there;
  }

  MeanMotion::Motion motion(const std::vector<Vector3> &there) const
  {
    std::vector<double> sums = MeanMotion::make_sums();
    for (std::size_t i = 0; i < there.size(); ++i)
      set.add(i, there[i], way[i], sums);
    return set.solve(sums);
  }

  /** Power on the rates `way`. */
  double power(const Wrench &wrench, const MeanMotion::Motion &motion) const
  {
    double power = 0;
    for (std::size_t i = 0; i < way.size(); ++i)
      power += set.force(i, motion, wrench.force, wrench.moment).dot(way[i]);
    return power;
  }
};

void reads_what_was_done()
{
  const Ring ring;
  // Ten turns and a bit, then a tilt by the shortest way to a' = z + 0.03 x - 0.02 y.
  const double             angle = 20. * pi + .4;
  const Vector3            z     = ring.axes.col(2);
  const Vector3            moved = (z + ring.axes * Vector3(.03, -.02, 0.)).normalized();
  const Matrix3            tilt  = Eigen::Quaterniond::FromTwoVectors(z, moved).toRotationMatrix();
  const MeanMotion::Motion motion =
    ring.motion(ring.moved(tilt * rotation_about(z, angle), ring.axes * Vector3(.1, .2, -.3), 0.));
  const Vector5 q = ring.seat.displacement(motion);
  check_below("displacement along x, y, z [mm]",
              (q.head<3>() - Vector3(.1, .2, -.3)).norm(),
              1e-12);
  // z x a' = (.02, .03, 0)/|a'|
  const double length = std::sqrt(1. + .03 * .03 + .02 * .02);
  check_below("tilt about x, y [rad]", (q.tail<2>() - Vector2(.02, .03) / length).norm(), 1e-12);
  check_close("twist of ten turns and a bit [rad]",
              ring.seat.twist(motion, angle + 2.),
              angle,
              1e-12);
}

void forces_are_conjugate()
{
  const Ring               ring;
  const Matrix3            turn = rotation_about(Vector3(1., -1., 2.).normalized(), 2.);
  const Vector3            shift(1., 2., 3.);
  const MeanMotion::Motion now = ring.motion(ring.moved(turn, shift, .3));

  // Displacements and twist a little later, by differences, beside their rates.
  const double             h      = 1e-5;
  const MeanMotion::Motion before = ring.motion(ring.moved(turn, shift, .3 - h)),
                           after  = ring.motion(ring.moved(turn, shift, .3 + h));
  const Vector5 change =
    (ring.seat.displacement(after) - ring.seat.displacement(before)) / (2. * h);
  const double twist = (ring.seat.twist(after, 0.) - ring.seat.twist(before, 0.)) / (2. * h);
  check_below("rate of the displacements less differences [mm/s, rad/s]",
              (ring.seat.rate(now) - change).norm(),
              1e-8);
  check_below("rate of the twist less differences [rad/s]",
              std::abs(ring.seat.twist_rate(now) - twist),
              1e-8);

  Vector5 load;
  load << 300., -200., 50., 4000., -9000.;
  check_ratio("power of a load over load times rate",
              ring.power(ring.seat.of_load(load, now), now) / load.dot(change),
              1e-7);
  check_ratio("power of a torque over torque times rate of the twist",
              ring.power(ring.seat.of_torque(7000., now), now) / (7000. * twist),
              1e-7);
}

void linear_law()
{
  // A positive matrix, symmetric and full.
  Matrix5 root;
  for (unsigned int i = 0; i < 5; ++i)
    for (unsigned int j = 0; j < 5; ++j)
      root(i, j) = std::sin(1. + 3. * i + 7. * j);
  const Matrix5 K = root * root.transpose();
  Vector5       preload, q;
  preload << 5., -3., 2., 0., 0.;
  q << .1, -.2, .05, .3, .1;
  const LinearBearing law(K, Matrix5::Zero(), preload);
  double              deviation = 0;
  for (unsigned int i = 0; i < 5; ++i)
    {
      const Vector5 step  = 1e-3 * Vector5::Unit(i);
      const double  slope = (law.evaluate(q + step).energy - law.evaluate(q - step).energy) / 2e-3;
      raise_to(deviation, std::abs(law.evaluate(q).load[i] + slope));
    }
  check_below("load is minus the slope of the energy [N, N mm]", deviation, 1e-9);
}

int main()
{
  return run_parts({reads_what_was_done, forces_are_conjugate, linear_law});
}
