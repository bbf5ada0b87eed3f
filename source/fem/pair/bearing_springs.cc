// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include "bearing_springs.h"

#include <vfife/model/constraints/supports.h>

namespace vfife
{
  namespace
  {
    /** A x of displacement and turn alike. */
    BearingSprings::Vector6 turned(const Matrix3 &A, const BearingSprings::Vector6 &x)
    {
      BearingSprings::Vector6 result;
      result << A * x.head<3>(), A * x.tail<3>();
      return result;
    }

    Matrix3 cross_matrix(const Vector3 &a)
    {
      Matrix3 m;
      for (unsigned int c = 0; c < 3; ++c)
        m.col(c) = a.cross(Vector3::Unit(c));
      return m;
    }
  } // namespace

  BearingSprings::BearingSprings(const Model &model, const BearingRings &rings, const double arm)
    : system_(make_bearing_system(model))
    , arm_(arm)
  {
    const std::size_t     first = first_bearing(model);
    const Eigen::MatrixXd K =
      rings.stiffness([&model](const unsigned int body) { return model.bodies[body].rate; });
    for (std::size_t r = 0; r < rings.list().size(); ++r)
      {
        const BearingRing &ring = rings.list()[r];
        if (ring.support >= first + model.bearings.size())
          continue; // A coupling is linear, and the same in all axes that turn about its own.
        const Body &body = model.bodies[ring.body];
        Spring      spring;
        spring.body             = ring.body;
        spring.motion           = ring;
        spring.axis             = body.axis.direction;
        spring.is_driven        = model.transmission && ring.body == model.transmission->driven;
        spring.reading          = ShaftSeat(model.bearings[ring.support - first].axes).reading();
        const Vector3 from_axis = ring.centre - body.axis.point;
        spring.eccentricity     = from_axis - from_axis.dot(spring.axis) * spring.axis;
        // Ways at the arm instead of turns.
        Vector6 scale = Vector6::Ones();
        scale.tail<3>().setConstant(1. / arm);
        spring.motion.motion.bottomRows<3>() *= arm;
        spring.linear = scale.asDiagonal() * K.block<6, 6>(6 * r, 6 * r) * scale.asDiagonal();
        spring.reading *= scale.asDiagonal();
        springs_.push_back(spring);
      }
  }

  std::vector<PointMotion> BearingSprings::motions() const
  {
    std::vector<PointMotion> motions;
    for (const Spring &spring : springs_)
      motions.push_back(spring.motion);
    return motions;
  }

  BearingSprings::Response BearingSprings::evaluate(const Eigen::VectorXd      &d,
                                                    const std::vector<Matrix3> &rotations,
                                                    const std::vector<double>  &turns) const
  {
    const std::size_t n = springs_.size();
    // 1. Displacements in the bearings' axes, and their change with the motions, q = Q d, Q = P R,
    // and with the turn, which takes the place along: q' = P [a]x (place).
    std::vector<Vector5> displacements;
    std::vector<double>  turns_of_seats;
    Eigen::MatrixXd      Q      = Eigen::MatrixXd::Zero(5 * n, 6 * n);
    Eigen::MatrixXd      Q_once = Q;
    Eigen::VectorXd      once = Eigen::VectorXd::Zero(5 * n), twice = once;
    for (std::size_t i = 0; i < n; ++i)
      {
        const Spring  &s = springs_[i];
        const Matrix3 &R = rotations[s.body];
        // Of a ring beside the axis those of its centre, which the turn takes along.
        Vector6 place = turned(R, d.segment<6>(6 * i));
        place.head<3>() += R * s.eccentricity;
        Vector6 moved = place;
        moved.head<3>() -= s.eccentricity;
        displacements.emplace_back(s.reading * moved);
        turns_of_seats.push_back(turns[s.body]);
        Q.block<5, 3>(5 * i, 6 * i)     = s.reading.leftCols<3>() * R;
        Q.block<5, 3>(5 * i, 6 * i + 3) = s.reading.rightCols<3>() * R;
        if (!s.is_driven)
          continue;
        const Matrix3 spin                   = cross_matrix(s.axis);
        once.segment<5>(5 * i)               = s.reading * turned(spin, place);
        twice.segment<5>(5 * i)              = s.reading * turned(spin * spin, place);
        Q_once.block<5, 3>(5 * i, 6 * i)     = s.reading.leftCols<3>() * spin * R;
        Q_once.block<5, 3>(5 * i, 6 * i + 3) = s.reading.rightCols<3>() * spin * R;
      }

    // 2. The bearings, in their housing, and what K0 has of them.
    const BearingSystem::Response system = system_.evaluate(displacements, turns_of_seats);
    Eigen::VectorXd               loads(5 * n);
    for (std::size_t i = 0; i < n; ++i)
      loads.segment<5>(5 * i) = system.loads[i];
    Response r;
    r.energy                     = system.energy;
    r.force                      = Q.transpose() * loads;
    r.stiffness                  = Q.transpose() * system.stiffness * Q;
    const Eigen::VectorXd change = system.stiffness * once;
    r.torque                     = loads.dot(once);
    r.by_turn                    = Q.transpose() * change - Q_once.transpose() * loads;
    r.turn_twice                 = once.dot(change) - loads.dot(twice);
    for (std::size_t i = 0; i < n; ++i)
      {
        const Spring &s            = springs_[i];
        const Vector6 own          = d.segment<6>(6 * i);
        const Vector6 since        = own - s.motion_known;
        const Vector6 linear_force = s.linear * since;
        r.energy += s.force_known.dot(own) - .5 * since.dot(linear_force);
        r.force.segment<6>(6 * i) += linear_force - s.force_known;
        r.stiffness.block<6, 6>(6 * i, 6 * i) -= s.linear;
        r.states.push_back({displacements[i], system.loads[i]});
      }
    return r;
  }

  Eigen::MatrixXd BearingSprings::tangent(const Response &response) const
  {
    Eigen::MatrixXd K = response.stiffness;
    Eigen::VectorXd scale(K.rows());
    for (std::size_t i = 0; i < springs_.size(); ++i)
      {
        K.block<6, 6>(6 * i, 6 * i) += springs_[i].linear;
        scale.segment<6>(6 * i) << 1., 1., 1., arm_, arm_, arm_;
      }
    return scale.asDiagonal() * K * scale.asDiagonal();
  }

  double BearingSprings::set_known(const Eigen::VectorXd      &d,
                                   const std::vector<Matrix3> &rotations,
                                   const std::vector<double>  &turns)
  {
    for (std::size_t i = 0; i < springs_.size(); ++i)
      {
        springs_[i].force_known  = Vector6::Zero();
        springs_[i].motion_known = d.segment<6>(6 * i);
      }
    const Response here = evaluate(d, rotations, turns);
    for (std::size_t i = 0; i < springs_.size(); ++i)
      springs_[i].force_known = here.force.segment<6>(6 * i);
    return here.torque;
  }
} // namespace vfife
