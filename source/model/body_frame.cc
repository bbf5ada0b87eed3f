// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/mesh/body_mesh.h>
#include <vfife/model/body_frame.h>

#include <algorithm>
#include <cmath>

namespace vfife
{
  Matrix3 compute_cylindrical_axes(const Body &body, const Vector3 &X)
  {
    // The axis, given in the fixed frame, as it lies in the body frame.
    const Matrix3 back  = body.placement.rotation.transpose();
    const Vector3 z     = back * body.axis.direction;
    const Vector3 point = back * (body.axis.point - body.placement.translation);
    Vector3       r     = X - point;
    r -= r.dot(z) * z;
    // On the axis (to round-off of the coordinates) r has no direction of its own.
    if (r.norm() <= 1e-12 * (X - point).norm() || r.norm() == 0)
      r = z.unitOrthogonal();
    r.normalize();
    Matrix3 axes;
    axes << r, z.cross(r), z;
    return axes;
  }

  Axis compute_sector_axis(const Body &body)
  {
    return {body.placement.translation, body.placement.rotation.col(2)};
  }

  double compute_sector_sense(const Body &body)
  {
    return body.axis.direction.dot(compute_sector_axis(body).direction) < 0 ? -1. : 1.;
  }

  bool turns_about_sector_axis(const Body &body)
  {
    constexpr double tolerance = 1e-6;
    double           size      = 0;
    for (const Vector3 &X : body.node_positions())
      size = std::max(size, X.norm());
    // Sine of the angle between both lines, and how far the one passes by the other's origin.
    const Axis    sectors = compute_sector_axis(body);
    const Vector3 between = body.axis.point - sectors.point;
    return sectors.direction.cross(body.axis.direction).norm() <= tolerance &&
           sectors.direction.cross(between).norm() <= tolerance * size;
  }

  Matrix3 compute_turn(const Body &body, const RigidMotion &now)
  {
    if (!body.turns_on_axis)
      return Matrix3::Identity();
    // Both lead from the body frame to the fixed frame, now and at time zero.
    const Matrix3 turn = now.rotation * body.placement.rotation.transpose();
    if (!body.floats)
      return turn;
    // Tilts are displacements like all others: what is left is the part of the quaternion about the
    // axis.
    const Eigen::Quaterniond quaternion(turn);
    const double             about_axis = quaternion.vec().dot(body.axis.direction);
    return rotation_about(body.axis.direction, 2. * std::atan2(about_axis, quaternion.w()));
  }

  Vector3 compute_displacement(const Body        &body,
                               const unsigned int node,
                               const Vector3     &x,
                               const Matrix3     &turn)
  {
    // u = R^T (x - c) - (X - c), in axes of the fixed frame that turn with the body
    return turn.transpose() * (x - body.axis.point) -
           (body.placement(body.node_positions()[node]) - body.axis.point);
  }
} // namespace vfife
