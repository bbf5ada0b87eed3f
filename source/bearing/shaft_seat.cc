// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/bearing/shaft_seat.h>

#include <cmath>

namespace vfife
{
  Matrix3 axes_along(const Vector3 &z, const Vector3 &x)
  {
    const Vector3 across = x - x.dot(z) * z;
    Matrix3       axes;
    axes.col(0) = across.norm() > 0 ? Vector3(across.normalized()) : z.unitOrthogonal();
    axes.col(1) = z.cross(axes.col(0));
    axes.col(2) = z;
    return axes;
  }

  Vector5 ShaftSeat::displacement(const MeanMotion::Motion &motion) const
  {
    Vector5 q;
    q.head<3>() = axes_.transpose() * motion.displacement;
    q.tail<2>() = axes_.leftCols<2>().transpose() * axes_.col(2).cross(moved_axis(motion));
    return q;
  }

  Vector5 ShaftSeat::rate(const MeanMotion::Motion &motion) const
  {
    Vector5 rate;
    rate.head<3>() = axes_.transpose() * motion.velocity;
    rate.tail<2>() =
      axes_.leftCols<2>().transpose() * axes_.col(2).cross(motion.spin.cross(moved_axis(motion)));
    return rate;
  }

  Wrench ShaftSeat::of_load(const Vector5 &load, const MeanMotion::Motion &motion) const
  {
    // m . (z x (w x a')) = w . (a' x (m x z))
    const Vector3 m = axes_.leftCols<2>() * load.tail<2>();
    return {axes_ * load.head<3>(), moved_axis(motion).cross(m.cross(axes_.col(2)))};
  }

  double ShaftSeat::twist(const MeanMotion::Motion &motion, const double expected) const
  {
    // R as a quaternion: its part about z is that of the twist, the rest the shortest turn.
    const Eigen::Quaterniond turn(motion.rotation);
    const double             twist = 2. * std::atan2(turn.vec().dot(axes_.col(2)), turn.w());
    return expected + std::remainder(twist - expected, 2. * pi);
  }

  Vector3 ShaftSeat::twist_direction(const MeanMotion::Motion &motion) const
  {
    const Vector3 moved = moved_axis(motion);
    return (axes_.col(2) + moved) / (1. + axes_.col(2).dot(moved));
  }

  double ShaftSeat::twist_rate(const MeanMotion::Motion &motion) const
  {
    return motion.spin.dot(twist_direction(motion));
  }

  Wrench ShaftSeat::of_torque(const double torque, const MeanMotion::Motion &motion) const
  {
    return {Vector3::Zero(), torque * twist_direction(motion)};
  }

  Eigen::Matrix<double, 5, 6> ShaftSeat::reading() const
  {
    Eigen::Matrix<double, 5, 6> rows = Eigen::Matrix<double, 5, 6>::Zero();
    rows.topLeftCorner<3, 3>()       = axes_.transpose();
    rows.bottomRightCorner<2, 3>()   = axes_.leftCols<2>().transpose();
    return rows;
  }

  Eigen::Matrix<double, 6, 6> ShaftSeat::in_space(const Matrix5 &matrix, const double torsion) const
  {
    const Eigen::Matrix<double, 5, 6> rows = reading();
    Eigen::Matrix<double, 6, 6>       all  = rows.transpose() * matrix * rows;
    all.bottomRightCorner<3, 3>() += torsion * axes_.col(2) * axes_.col(2).transpose();
    return all;
  }
} // namespace vfife
