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

  BearingSprings::BearingSprings(const Model                    &model,
                                 const std::vector<BearingRing> &rings,
                                 const double                    arm)
  {
    const std::size_t first = first_bearing(model);
    for (const BearingRing &ring : rings)
      {
        if (ring.support >= first + model.bearings.size())
          continue; // A coupling is linear, and the same in all axes that turn about its own.
        const Body &body = model.bodies[ring.body];
        Spring      spring;
        spring.bearing          = &model.bearings[ring.support - first];
        spring.motion           = ring;
        spring.axis             = body.axis.direction;
        spring.is_driven        = model.transmission && ring.body == model.transmission->driven;
        spring.reading          = ShaftSeat(spring.bearing->axes).reading();
        const Vector3 from_axis = ring.centre - body.axis.point;
        spring.eccentricity     = from_axis - from_axis.dot(spring.axis) * spring.axis;
        // Ways at the arm instead of turns.
        Vector6 scale = Vector6::Ones();
        scale.tail<3>().setConstant(1. / arm);
        spring.motion.motion.bottomRows<3>() *= arm;
        spring.linear = scale.asDiagonal() * ring.stiffness_at(body.rate) * scale.asDiagonal();
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

  BearingSprings::Response BearingSprings::evaluate(const std::size_t           i,
                                                    const Vector6              &d,
                                                    const std::vector<Matrix3> &rotations) const
  {
    const Spring  &s = springs_[i];
    const Matrix3 &R = rotations[s.bearing->body];
    // 1. Displacements in the bearing's axes: of a ring beside the axis those of its centre, which
    // the turn takes along.
    Vector6 place = turned(R, d);
    place.head<3>() += R * s.eccentricity;
    Vector6 moved = place;
    moved.head<3>() -= s.eccentricity;
    Response r;
    r.state.displacement       = s.reading * moved;
    const BearingResponse law  = s.bearing->law->evaluate(r.state.displacement);
    r.state.load               = law.load;
    const Vector6 since        = d - s.motion_known;
    const Vector6 linear_force = s.linear * since;

    // 2. Derivatives with d: q = Q d, Q = P R.
    Eigen::Matrix<double, 5, 6> Q;
    Q << s.reading.leftCols<3>() * R, s.reading.rightCols<3>() * R;
    r.energy    = law.energy - .5 * since.dot(linear_force) + s.force_known.dot(d);
    r.force     = Q.transpose() * law.load + linear_force - s.force_known;
    r.stiffness = Q.transpose() * law.stiffness * Q - s.linear;
    if (!s.is_driven)
      return r;

    // 3. Derivatives with the turn, which takes the place along: q' = P [a]x (place).
    const Matrix3               spin   = cross_matrix(s.axis);
    const Vector5               once   = s.reading * turned(spin, place);
    const Vector5               twice  = s.reading * turned(spin * spin, place);
    const Vector5               change = law.stiffness * once;
    Eigen::Matrix<double, 5, 6> Q_once;
    Q_once << s.reading.leftCols<3>() * spin * R, s.reading.rightCols<3>() * spin * R;
    r.torque     = law.load.dot(once);
    r.by_turn    = Q.transpose() * change - Q_once.transpose() * law.load;
    r.turn_twice = once.dot(change) - law.load.dot(twice);
    return r;
  }

  double BearingSprings::set_known(const std::vector<Vector6> &d,
                                   const std::vector<Matrix3> &rotations)
  {
    double torque = 0;
    for (std::size_t i = 0; i < springs_.size(); ++i)
      {
        Spring &spring      = springs_[i];
        spring.force_known  = Vector6::Zero();
        spring.motion_known = d[i];
        const Response here = evaluate(i, d[i], rotations);
        spring.force_known  = here.force;
        torque += here.torque;
      }
    return torque;
  }
} // namespace vfife
