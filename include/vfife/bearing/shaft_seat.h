// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_bearing_shaft_seat_h
#define vfife_bearing_shaft_seat_h

#include <vfife/bearing/bearing_law.h>
#include <vfife/bearing/mean_motion.h>

namespace vfife
{
  /** Force [N] and moment about the centre [N mm], fixed frame. */
  struct Wrench
  {
    Vector3 force = Vector3::Zero(), moment = Vector3::Zero();
  };

  /** What a bearing's shaft does in it, along the bearing's axes: displacement of the seat [mm,
   * rad] and load on the shaft [N, N mm]. */
  struct SeatState
  {
    Vector5 displacement = Vector5::Zero(), load = Vector5::Zero();
  };

  /** Columns x, y, z of axes with the unit vector @p z; x is the direction @p x made square to it,
   * any one where it has no length across z. */
  Matrix3 axes_along(const Vector3 &z, const Vector3 &x = Vector3::Zero());

  /**
   * The seat of a bearing or coupling on a shaft: a ring of nodes whose mean motion is read in axes
   * at rest, x and y across the undeformed axis z. With a' = R z the tilt is z x a', and the twist
   * about the moving axis is what is left of R when the shortest turn from z to a' is undone. Both
   * are exact for any turn of the shaft; moments are put on the ring by the transposed derivatives,
   * d(tilt) = z x (w x a') and d(twist) = w . (z + a')/(1 + z . a'), so power is conjugate.
   */
  class ShaftSeat
  {
  public:
    /** Columns of @p axes: x, y, z in the fixed frame. */
    explicit ShaftSeat(const Matrix3 &axes)
      : axes_(axes)
    {
    }

    /** x, y, z [mm] of the centre, tilt about x, y [rad]. */
    Vector5 displacement(const MeanMotion::Motion &motion) const;
    /** The rate of that [mm/s, rad/s]. */
    Vector5 rate(const MeanMotion::Motion &motion) const;
    /** Loads of a bearing [N, N mm] as force and moment in the fixed frame. */
    Wrench of_load(const Vector5 &load, const MeanMotion::Motion &motion) const;

    /** About the moving axis, in (-pi, pi] beyond the turn @p expected [rad]. */
    double twist(const MeanMotion::Motion &motion, double expected) const;
    /** The rate of the twist [rad/s]. */
    double twist_rate(const MeanMotion::Motion &motion) const;
    /** A torque that works on the twist [N mm]. */
    Wrench of_torque(double torque, const MeanMotion::Motion &motion) const;

    /** What small displacements and turns of the centre along the fixed frame's axes are in those
     * of the bearing: x, y, z, tilts about x and y. */
    Eigen::Matrix<double, 5, 6> reading() const;

    /** A matrix of a bearing as one of small displacements and turns of the centre along the fixed
     * frame's axes; @p torsion: of the turn about z. */
    Eigen::Matrix<double, 6, 6> in_space(const Matrix5 &matrix, double torsion) const;

  private:
    Vector3 moved_axis(const MeanMotion::Motion &motion) const
    {
      return motion.rotation * axes_.col(2);
    }
    /** d(twist)/d(turn). */
    Vector3 twist_direction(const MeanMotion::Motion &motion) const;

    Matrix3 axes_;
  };
} // namespace vfife

#endif
