// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/fem/pair/bearing_springs.h>
#include <vfife/model/constraints/supports.h>
#include <vfife/model/model.h>

#include <algorithm>

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

  BearingSprings::BearingSprings(const Model                &model,
                                 const std::vector<Vector3> &centres,
                                 const Eigen::MatrixXd      &linear,
                                 const double                arm)
    : system_(make_bearing_system(model))
    , arm_(arm)
    , n_bodies_(model.bodies.size())
    , driven_(model.only_transmission() ? model.only_transmission()->driven : n_bodies_)
    , motions_known_(Eigen::VectorXd::Zero(linear.rows()))
    , forces_known_(motions_known_)
  {
    // Ways at the arm instead of turns.
    Vector6 scale = Vector6::Ones();
    scale.tail<3>().setConstant(1. / arm);
    Eigen::VectorXd scales(linear.rows());
    for (std::size_t b = 0; b < model.bearings.size(); ++b)
      {
        const Bearing &bearing = model.bearings[b];
        const Body    &body    = model.bodies[bearing.body];
        Spring         spring;
        spring.body             = bearing.body;
        spring.axis             = body.axis.direction;
        spring.reading          = ShaftSeat(bearing.axes).reading() * scale.asDiagonal();
        const Vector3 from_axis = centres[b] - body.axis.point;
        spring.eccentricity     = from_axis - from_axis.dot(spring.axis) * spring.axis;
        spring.damping          = bearing.law->damping();
        springs_.push_back(spring);
        scales.segment<6>(6 * b) = scale;
      }
    linear_ = scales.asDiagonal() * linear * scales.asDiagonal();
  }

  void BearingSprings::Response::add_to(PressedForces &sum, const Eigen::Index row) const
  {
    sum.force.segment(row, force.size()) += force;
    sum.energy += energy;
    sum.torque += torque;
  }

  void BearingSprings::Response::add_to(PressedSprings &springs, const bool turning) const
  {
    const Eigen::Index n = force.size();
    springs.stiffness.topLeftCorner(n, n) += stiffness;
    if (!turning)
      return;
    springs.by_turn.head(n) += by_turn;
    springs.turn_twice += turn_twice;
  }

  bool BearingSprings::has_dampers() const
  {
    return std::any_of(springs_.begin(), springs_.end(), [](const Spring &spring) {
      return !spring.damping.isZero(0.);
    });
  }

  void BearingSprings::set_dampers(const Response &from, const double step)
  {
    step_ = has_dampers() ? step : 0.;
    before_.clear();
    for (const SeatState &state : from.states)
      before_.push_back(state.displacement);
  }

  void BearingSprings::add_dampers(const std::vector<Vector5> &displacements,
                                   Eigen::VectorXd            &loads,
                                   Eigen::MatrixXd            &stiffness,
                                   Response                   &r) const
  {
    for (std::size_t i = 0; i < springs_.size(); ++i)
      {
        const Vector5 way   = displacements[i] - before_[i];
        const Vector5 force = 2. / step_ * springs_[i].damping * way;
        r.energy += .5 * way.dot(force);
        loads.segment<5>(5 * i) -= force;
        stiffness.block<5, 5>(5 * i, 5 * i) += 2. / step_ * springs_[i].damping;
      }
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
    Eigen::MatrixXd      Q       = Eigen::MatrixXd::Zero(5 * n, 6 * n);
    Eigen::MatrixXd      Q_once  = Q;
    Eigen::VectorXd      turning = Eigen::VectorXd::Zero(5 * n), once = turning, twice = turning;
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
        const Matrix3 spin              = cross_matrix(s.axis);
        turning.segment<5>(5 * i)       = s.reading * turned(spin, place);
        if (s.body != driven_)
          continue;
        once.segment<5>(5 * i)               = turning.segment<5>(5 * i);
        twice.segment<5>(5 * i)              = s.reading * turned(spin * spin, place);
        Q_once.block<5, 3>(5 * i, 6 * i)     = s.reading.leftCols<3>() * spin * R;
        Q_once.block<5, 3>(5 * i, 6 * i + 3) = s.reading.rightCols<3>() * spin * R;
      }

    // 2. The bearings, in their housing, and what K0 has of them.
    const BearingSystem::Response system  = system_.evaluate(displacements, turns_of_seats);
    Eigen::MatrixXd               tangent = system.stiffness;
    Eigen::VectorXd               loads(5 * n);
    for (std::size_t i = 0; i < n; ++i)
      loads.segment<5>(5 * i) = system.loads[i];
    Response r;
    r.energy = system.energy;
    if (step_ > 0)
      add_dampers(displacements, loads, tangent, r);
    const Eigen::VectorXd since = d - motions_known_, linear_force = linear_ * since;
    r.energy += forces_known_.dot(d) - .5 * since.dot(linear_force);
    r.force                      = Q.transpose() * loads + linear_force - forces_known_;
    r.stiffness                  = Q.transpose() * tangent * Q - linear_;
    const Eigen::VectorXd change = tangent * once;
    r.torque                     = loads.dot(once);
    r.by_turn                    = Q.transpose() * change - Q_once.transpose() * loads;
    r.turn_twice                 = once.dot(change) - loads.dot(twice);
    r.torques.assign(n_bodies_, 0.);
    r.cage_slopes.assign(n_bodies_, 0.);
    for (std::size_t i = 0; i < n; ++i)
      {
        r.torques[springs_[i].body] += loads.segment<5>(5 * i).dot(turning.segment<5>(5 * i));
        r.cage_slopes[springs_[i].body] += system.turn_slopes[i];
        r.states.push_back({displacements[i], loads.segment<5>(5 * i)});
      }
    return r;
  }

  Eigen::MatrixXd BearingSprings::tangent(const Response &response) const
  {
    Eigen::VectorXd scale(linear_.rows());
    for (std::size_t i = 0; i < springs_.size(); ++i)
      scale.segment<6>(6 * i) << 1., 1., 1., arm_, arm_, arm_;
    return scale.asDiagonal() * (response.stiffness + linear_) * scale.asDiagonal();
  }

  double BearingSprings::set_known(const Eigen::VectorXd      &d,
                                   const std::vector<Matrix3> &rotations,
                                   const std::vector<double>  &turns)
  {
    forces_known_.setZero();
    motions_known_      = d;
    const Response here = evaluate(d, rotations, turns);
    forces_known_       = here.force;
    return here.torque;
  }
} // namespace vfife
