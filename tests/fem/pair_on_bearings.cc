// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// The loaded pair in linear bearings: rigid bodies on springs by hand, balance of forces and
// moments, coupled modes, a series of stiffness against ideal bores, bearings that differ along x
// and y.
#include "../parts.h"
#include "pair_in_bearings.h"

#include <vfife/fem/pair/coupled_modes.h>
#include <vfife/mesh/primitives/primitives.h>

#include <Eigen/Dense>

using namespace vfife;

constexpr double load = 8e5; ///< [N mm]

using Matrix12 = Eigen::Matrix<double, 12, 12>;
using Vector12 = Eigen::Matrix<double, 12, 1>;
using Matrix6  = Eigen::Matrix<double, 6, 6>;

Matrix3 cross_matrix(const Vector3 &a)
{
  Matrix3 m;
  m << 0., -a[2], a[1], a[2], 0., -a[0], -a[1], a[0], 0.;
  return m;
}

/** Of bearings that do not know each other. */
Eigen::MatrixXd apart(const std::vector<Matrix5> &stiffness)
{
  Eigen::MatrixXd K = Eigen::MatrixXd::Zero(5 * stiffness.size(), 5 * stiffness.size());
  for (std::size_t b = 0; b < stiffness.size(); ++b)
    K.block<5, 5>(5 * b, 5 * b) = stiffness[b];
  return K;
}

/** Two rigid bodies on springs: of each a way of its axis point and a turn about it, along the
 * fixed frame, the driver first. */
class RigidPair
{
public:
  RigidPair(const Model                   &model,
            const std::vector<Vector3>    &ring_centres,
            const Eigen::MatrixXd         &stiffness, ///< of all bearings
            const double                   driver_turn,
            const FemSpace                &points,
            const std::vector<ContactTie> &ties)
    : model_(model)
  {
    const Transmission &t    = *model.only_transmission();
    Eigen::MatrixXd     ways = Eigen::MatrixXd::Zero(stiffness.rows(), 12);
    for (std::size_t b = 0; b < model.bearings.size(); ++b)
      {
        // q: x, y, z of the ring's centre, turns about x, y; the way there is d + turn x arm.
        const Bearing              &bearing = model.bearings[b];
        const Vector3               arm = ring_centres[b] - model.bodies[bearing.body].axis.point;
        Eigen::Matrix<double, 5, 6> q   = Eigen::Matrix<double, 5, 6>::Zero();
        q.block<3, 3>(0, 0)             = bearing.axes.transpose();
        q.block<3, 3>(0, 3)             = -bearing.axes.transpose() * cross_matrix(arm);
        q.block<2, 3>(3, 3)             = bearing.axes.leftCols<2>().transpose();
        ways.block<5, 6>(5 * b, at(bearing.body)) = q;
      }
    stiffness_ += ways.transpose() * stiffness * ways;
    for (const Coupling &coupling : model.couplings)
      {
        const Vector3 &a = model.bodies[coupling.body].axis.direction;
        stiffness_.block<3, 3>(at(coupling.body) + 3, at(coupling.body) + 3) +=
          coupling.stiffness * a * a.transpose();
      }
    for (const ContactTie &tie : ties)
      {
        Vector12 way = Vector12::Zero();
        for (const auto &[point, direction] : tie.points)
          {
            const unsigned int body  = points.part_of_point(point).body;
            const Axis        &axis  = model.bodies[body].axis;
            const double       angle = body == t.driver ? t.driver_sense * driver_turn
                                                        : t.driven_sense * t.ratio() * driver_turn;
            const Matrix3      R     = rotation_about(axis.direction, angle);
            const Vector3      d     = R * direction;
            way.segment<3>(at(body)) += d;
            way.segment<3>(at(body) + 3) += (R * (points.points()[point] - axis.point)).cross(d);
          }
        stiffness_ += tie.stiffness * way * way.transpose();
      }
  }

  /** Under the torque on the driven body. */
  Vector12 solve() const
  {
    Vector12           force  = Vector12::Zero();
    const unsigned int driven = model_.only_transmission()->driven;
    force.segment<3>(at(driven) + 3) =
      model_.torques.front().value * model_.bodies[driven].axis.direction;
    return stiffness_.fullPivLu().solve(force);
  }

  /** Turn of a body about its axis. */
  double turn(const unsigned int body, const Vector12 &x) const
  {
    return model_.bodies[body].axis.direction.dot(x.segment<3>(at(body) + 3));
  }

  double transmission_error(const Vector12 &x) const
  {
    const Transmission &t = *model_.only_transmission();
    return t.driven_sense * turn(t.driven, x) - t.ratio() * t.driver_sense * turn(t.driver, x);
  }

  /** Natural frequencies [Hz], ascending. */
  std::vector<double> frequencies() const
  {
    Matrix12 mass = Matrix12::Zero();
    for (unsigned int b = 0; b < 2; ++b)
      for (unsigned int i = 0; i < model_.bodies[b].n_nodes(); ++i)
        {
          const Body                 &body = model_.bodies[b];
          Eigen::Matrix<double, 3, 6> way;
          way << Matrix3::Identity(),
            -cross_matrix(body.placement(body.node_positions()[i]) - body.axis.point);
          mass.block<6, 6>(at(b), at(b)) += body.node_masses()[i] * way.transpose() * way;
        }
    const Eigen::GeneralizedSelfAdjointEigenSolver<Matrix12> modes(stiffness_, mass);
    std::vector<double>                                      frequencies;
    for (unsigned int k = 0; k < 12; ++k)
      frequencies.push_back(std::sqrt(modes.eigenvalues()[k]) / (2 * pi));
    return frequencies;
  }

private:
  static unsigned int at(const unsigned int body)
  {
    return 6 * body;
  }

  const Model &model_;
  Matrix12     stiffness_ = Matrix12::Zero();
};

std::vector<Vector3> ring_centres(const Compliance &compliance)
{
  std::vector<Vector3> centres;
  for (const BearingRing &ring : compliance.rings().list())
    centres.push_back(ring.centre);
  return centres;
}

/** Moments about the fixed origin of bearings, coupling and load, over the load. */
double unbalanced_moment(const Model                 &model,
                         const Compliance            &compliance,
                         const PairEquilibriumResult &result,
                         const double                 factor)
{
  const Transmission &t = *model.only_transmission();
  Vector3    sum     = factor * model.torques.front().value * model.bodies[t.driven].axis.direction;
  const auto centres = ring_centres(compliance);
  for (std::size_t b = 0; b < model.bearings.size(); ++b)
    {
      const Matrix3 &axes = model.bearings[b].axes;
      const Vector5 &on   = result.bearings[b].load;
      sum += centres[b].cross(axes * on.head<3>()) + axes.leftCols<2>() * on.tail<2>();
    }
  const BearingRing    &drive = compliance.rings().list().back();
  const Eigen::MatrixXd K     = compliance.rings().stiffness(constant_rate(0.));
  sum -= K.bottomRightCorner<3, 3>() * drive.displacement(result.displacements).tail<3>();
  return sum.norm() / (factor * load);
}

/** Bodies far stiffer than their bearings and the coupling. */
Model make_softly_held(Communicator &world)
{
  Model model = make_held_pair(world, rigid_steel);
  hang_in_bearings(model,
                   {linear_bearing(soft_front),
                    linear_bearing(soft_back),
                    linear_bearing(soft_back),
                    linear_bearing(soft_front)},
                   5e8);
  return model;
}

/** Rigid bodies: all that gives way are bearings, coupling and the contact's springs. */
void rigid_bodies(Communicator &world)
{
  Model            model = make_softly_held(world);
  const FemOptions fem   = lumped_masses();
  Compliance       compliance(model, fem, false, world);
  PairEquilibrium  equilibrium(model, compliance, {0.});
  const auto       result = equilibrium.solve(0., 1.);
  const RigidPair  hand(model,
                       ring_centres(compliance),
                       apart({soft_front, soft_back, soft_back, soft_front}),
                       0.,
                       compliance.space(),
                       result.ties);
  const Errors     errors = transmission_errors(compliance.space(), result);
  check_ratio("slope of the transmission error",
              errors.slope / hand.transmission_error(hand.solve()),
              1e-2);
  check_below("forces of each body", unbalanced(model, result), 1e-6);
  check_close("contact torque", result.contact_torque, load, 1e-8 * load);
  check("few iterations", result.iterations <= 8);

  // The driver on its coupling, the driven body on the contact, both in their bearings.
  const CoupledModes modes =
    find_coupled_modes(compliance, fem, false, result.ties, result.bearing_tangent, 6, world);
  const std::vector<double> frequencies = hand.frequencies();
  double                    apart       = 0;
  for (unsigned int k = 0; k < 6; ++k)
    raise_to(apart, std::abs(modes.turning[k].frequency / frequencies[k] - 1));
  check_below("six lowest coupled modes", apart, 1e-2);
  check("modes are counted", modes.counted);
  check_ratio("tangent stiffness of the modes",
              modes.stiffness *
                std::abs(hand.turn(model.only_transmission()->driven, hand.solve())) / load,
              1e-2);
}

/** All bearings in one housing that joins both bodies: at rest, and spinning so slowly that what
 * stands in space is as at rest. In axes that turn with the bodies there is but a mean. */
void housing(Communicator &world)
{
  Model            model = make_softly_held(world);
  const FemOptions fem   = lumped_masses();
  Eigen::MatrixXd  root(24, 24);
  for (unsigned int i = 0; i < 24; ++i)
    for (unsigned int j = 0; j < 24; ++j)
      root(i, j) = std::sin(1. + 3. * i + 7. * j + .3 * i * j) * (i % 6 < 3 ? 2e2 : 5e3);
  model.housing =
    root * root.transpose() + Eigen::MatrixXd(3e4 * Eigen::MatrixXd::Identity(24, 24));
  const Eigen::MatrixXd springs = apart({soft_front, soft_back, soft_back, soft_front});
  Eigen::MatrixXd       reading = Eigen::MatrixXd::Zero(20, 24);
  for (unsigned int b = 0; b < 4; ++b)
    {
      const Matrix3 &axes                       = model.bearings[b].axes;
      reading.block<3, 3>(5 * b, 6 * b)         = axes.transpose();
      reading.block<2, 3>(5 * b + 3, 6 * b + 3) = axes.leftCols<2>().transpose();
    }
  // In series.
  const Eigen::MatrixXd joined =
    (springs.inverse() + reading * model.housing.inverse() * reading.transpose()).inverse();
  Eigen::MatrixXd own = joined;
  for (unsigned int i = 0; i < 20; ++i)
    for (unsigned int j = 0; j < 20; ++j)
      own(i, j) *= i / 10 == j / 10;
  for (const double rate : {0., .01})
    {
      for (Body &body : model.bodies)
        body.rate = std::copysign(rate, body.rate);
      Compliance      compliance(model, fem, rate > 0, world);
      PairEquilibrium equilibrium(model, compliance, {0.});
      const auto      result      = equilibrium.solve(0., 1.);
      const auto      frequencies = [&](const Eigen::MatrixXd &stiffness) {
        return RigidPair(
                 model, ring_centres(compliance), stiffness, 0., compliance.space(), result.ties)
          .frequencies();
      };
      const std::vector<double> expected = frequencies(joined), without = frequencies(own);
      const CoupledModes        modes = find_coupled_modes(
        compliance, fem, rate > 0, result.ties, result.bearing_tangent, 6, world);
      const auto &list  = rate > 0 ? modes.standing : modes.turning;
      double      worst = 0, joint = 0;
      for (unsigned int k = 0; k < 6; ++k)
        {
          raise_to(worst, std::abs(list[k].frequency / expected[k] - 1));
          raise_to(joint, std::abs(without[k] / expected[k] - 1));
        }
      check_below("housing: six lowest coupled modes", worst, 1e-2);
      check("housing: it joins both bodies", joint > 3e-2);
      check_below("housing: forces of each body", unbalanced(model, result), 1e-6);
    }
}

/** A rigid shaft that is shifted and tilted in its bearings spins on where it is, at no force:
 * the slope of the transmission error is that at rest. Bearings softened by m Omega^2 change it
 * by 2 % and do not balance the contact. */
void spinning_bodies(Communicator &world)
{
  Model model = make_softly_held(world);
  for (Body &body : model.bodies)
    body.rate *= 2;
  std::vector<double> slopes;
  for (const bool spinning : {false, true})
    {
      Compliance      compliance(model, lumped_masses(), spinning, world);
      PairEquilibrium equilibrium(model, compliance, {0.});
      const auto      result = equilibrium.solve(0., 1.);
      slopes.push_back(transmission_errors(compliance.space(), result).slope);
      check("spinning bodies: few iterations", result.iterations <= 8);
      check_below("spinning bodies: forces of each body", unbalanced(model, result), 1e-6);
    }
  check_ratio("spinning bodies: slope", slopes[1] / slopes[0], 1e-3);
}

/** Moments are taken about undisplaced axes in the bodies and displaced ones in the balance of
 * the torque: the smaller displacements are, the less they differ. */
void moments(Communicator &world)
{
  Model         model = make_held_pair(world, rigid_steel);
  const Matrix5 front = 1e4 * soft_front, back = 1e4 * soft_back;
  hang_in_bearings(
    model,
    {linear_bearing(front), linear_bearing(back), linear_bearing(back), linear_bearing(front)},
    5e12);
  Compliance      compliance(model, lumped_masses(), false, world);
  PairEquilibrium equilibrium(model, compliance, {0.});
  double          before = 0;
  for (const double factor : {.1, .01})
    {
      const double moment =
        unbalanced_moment(model, compliance, equilibrium.solve(0., factor), factor);
      if (before > 0)
        {
          check_below("moments", moment, 1e-6);
          check_close("the less, the less is displaced", before / moment, 10., 1.);
        }
      before = moment;
    }
}

/** Bearings alike that become stiffer; what is left are the bodies. */
void stiff_limit(Communicator &world)
{
  double ideal = 0;
  {
    const Model     model = make_held_pair(world, rigid_steel);
    Compliance      compliance(model, lumped_masses(), false, world);
    PairEquilibrium equilibrium(model, compliance, {0.});
    const auto      result = equilibrium.solve(0., 1.);
    const Errors    errors = transmission_errors(compliance.space(), result);
    ideal                  = errors.loaded - errors.unloaded;
  }
  std::vector<double> windup, energy;
  for (const double stiffness : {1e7, 2e7, 4e7})
    {
      Model      model = make_held_pair(world, rigid_steel);
      const auto law   = linear_bearing(bearing_stiffness(stiffness, stiffness, 1e3 * stiffness));
      hang_in_bearings(model, {law, law, law, law}, 1e3 * stiffness);
      Compliance      compliance(model, lumped_masses(), false, world);
      PairEquilibrium equilibrium(model, compliance, {0.});
      const auto      result = equilibrium.solve(0., 1.);
      const Errors    errors = transmission_errors(compliance.space(), result);
      windup.push_back(errors.loaded - errors.unloaded);
      // Twice the energy of the bearings over the torque, as a turn. What the coupling is wound
      // up by turns the driver's bore, and is no error.
      double sum = 0;
      for (std::size_t b = 0; b < 4; ++b)
        sum -= result.bearings[b].load.dot(result.bearings[b].displacement);
      energy.push_back(sum / load);
    }
  const double limit = 2 * windup[2] - windup[1];
  check_close("what bearings give halves",
              (windup[0] - windup[1]) / (windup[1] - windup[2]),
              2.,
              2e-3);
  check_ratio("and is their energy", (windup[2] - windup[1]) / (.5 * energy[1]), 1e-2);
  // Rigid hubs keep their rings round, in bearings the steel, stiff as it is, does.
  check_ratio("stiff ones against ideal bores", limit / ideal, 2e-2);
}

/** A driver whose bearings differ along x and y, at two places a quarter of a turn apart. */
void unlike_axes(Communicator &world)
{
  Model   model  = make_held_pair(world, rigid_steel);
  Matrix5 unlike = bearing_stiffness(1e5, 3e5, 1e8);
  unlike(1, 1)   = 6e5;
  unlike(0, 1) = unlike(1, 0) = 5e4;
  unlike(4, 4)                = 3e8;
  hang_in_bearings(model,
                   {linear_bearing(unlike),
                    linear_bearing(unlike),
                    linear_bearing(soft_back),
                    linear_bearing(unlike)},
                   5e8);
  for (Body &body : model.bodies)
    check("its bodies turn", body.rate != 0);
  const Matrix5             in_mean = bearing_stiffness(3.5e5, 3e5, 2e8);
  Compliance                compliance(model, lumped_masses(), false, world);
  const std::vector<double> turns = {0., .5 * pi};
  PairEquilibrium           equilibrium(model, compliance, turns);
  for (const double turn : turns)
    {
      const auto      result = equilibrium.solve(turn, 1.);
      const Errors    errors = transmission_errors(compliance.space(), result);
      const RigidPair hand(model,
                           ring_centres(compliance),
                           apart({unlike, unlike, soft_back, unlike}),
                           turn,
                           compliance.space(),
                           result.ties);
      const RigidPair mean(model,
                           ring_centres(compliance),
                           apart({in_mean, in_mean, soft_back, in_mean}),
                           turn,
                           compliance.space(),
                           result.ties);
      check_ratio("unlike axes: slope of the transmission error",
                  errors.slope / hand.transmission_error(hand.solve()),
                  1e-2);
      check("not that of bearings in the mean",
            std::abs(errors.slope / mean.transmission_error(mean.solve()) - 1) > 3e-2);
      check_below("unlike axes: forces of each body", unbalanced(model, result), 1e-6);
      // About the axis of the driven body: a bearing that is displaced and pushes askew turns it.
      const Transmission &t     = *model.only_transmission();
      double              moved = 0;
      for (std::size_t b = 0; b < model.bearings.size(); ++b)
        if (model.bearings[b].body == t.driven)
          {
            const Vector5 &q = result.bearings[b].displacement, &f = result.bearings[b].load;
            moved += q[0] * f[1] - q[1] * f[0] + q[3] * f[4] - q[4] * f[3];
          }
      check("bearings have a torque", std::abs(moved) > 1e-6 * load);
      check_ratio("unlike axes: torques on the driven body",
                  (t.driven_sense * result.contact_torque + moved) / -model.torques.front().value,
                  1e-8);
      check("unlike axes: few iterations", result.iterations <= 8);
    }
}

/** A ring whose three circles of nodes turn by angles of their own: masses as radii times half
 * the widths beside them. */
void turned_circles(Communicator &)
{
  Model model;
  Body  ring("ring", make_ring(10., 30., 2., {{2, 48, 1}}), Material());
  ring.placement.rotation    = rotation_about(Vector3(1., -2., 1.).normalized(), .7);
  ring.placement.translation = Vector3(4., 1., -9.);
  ring.axis = {ring.placement(Vector3(0., 0., 5.)), ring.placement.rotation.col(2)};
  model.add_body(std::move(ring));
  const FemSpace            d(model, {0}, FemElement::full);
  const Body               &body = model.bodies[0];
  std::vector<double>       u;
  std::vector<unsigned int> nodes;
  double                    sum = 0, mass = 0;
  for (unsigned int n = 0; n < body.n_nodes(); ++n)
    {
      const Vector3 r      = d.points()[n] - body.axis.point,
                    across = r - r.dot(body.axis.direction) * body.axis.direction;
      const double radius  = across.norm();
      const double turn    = radius < 15. ? 1e-3 : radius < 25. ? -4e-3 : 2e-3;
      // Motion along the axis and away from it turns nothing.
      const Vector3 way =
        turn * body.axis.direction.cross(r) + .01 * across / radius + .02 * body.axis.direction;
      u.insert(u.end(), way.data(), way.data() + 3);
      nodes.push_back(n);
      sum += body.node_masses()[n] * turn;
      mass += body.node_masses()[n];
    }
  check_ratio("mean rotation of circles", mean_rotation(d, 0, nodes, u) / (sum / mass), 1e-12);
  check("they differ", std::abs(sum / mass) > 1e-4);
}

int main(int argc, char **argv)
{
  return run_parts(
    argc,
    argv,
    {rigid_bodies, housing, spinning_bodies, moments, stiff_limit, unlike_axes, turned_circles});
}
