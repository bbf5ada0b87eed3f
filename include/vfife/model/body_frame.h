// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_model_body_frame_h
#define vfife_model_body_frame_h

#include <vfife/model/body.h>

namespace vfife
{
  /**
   * Axes r, theta, z (columns) of a body at the undeformed point @p X, in its body frame: about its
   * axis of rotation; on the axis itself any r is taken.
   */
  Matrix3 compute_cylindrical_axes(const Body &body, const Vector3 &X);

  /**
   * The line about which the sectors of the body's mesh are turned copies of each other, in the
   * fixed frame at time zero: z of the body frame, in whose positive sense they follow each other.
   * What the body turns about is Body::axis, which may be another line.
   */
  Axis compute_sector_axis(const Body &body);

  /** Of Body::axis along that line: 1 or -1. */
  double compute_sector_sense(const Body &body);

  /**
   * Whether the axis of rotation is the line of the sectors, in either sense: to six digits, with
   * which a parameter file may state it. Otherwise no two sectors see the same spin.
   */
  bool turns_about_sector_axis(const Body &body);

  /**
   * Rotation R of a body in bearings from time zero to its mean rigid motion @p now (body frame ->
   * fixed frame), in the fixed frame. Bodies that no bearing holds keep R = 1: their displacement
   * is the whole way, as in statics.
   */
  Matrix3 compute_turn(const Body &body, const RigidMotion &now);

  /**
   * Displacement R^T (x - c) - (X - c) [mm] of a node of the body that is now at @p x, c the axis
   * point and @p turn = R of compute_turn(); axes of the fixed frame at time zero.
   */
  Vector3
  compute_displacement(const Body &body, unsigned int node, const Vector3 &x, const Matrix3 &turn);
} // namespace vfife

#endif
