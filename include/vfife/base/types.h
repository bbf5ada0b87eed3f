// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_base_types_h
#define vfife_base_types_h

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <cmath>
#include <complex>
#include <limits>

/**
 * All of vfife. Internal units everywhere: mm, s, t, N, MPa (hence mJ for energy, N mm for
 * torque, rad and rad/s for angles and speeds); only files and the screen use others, and say so.
 */
namespace vfife
{
  using Vector2 = Eigen::Vector2d;
  using Vector3 = Eigen::Vector3d;
  using Matrix3 = Eigen::Matrix3d;
  using Complex = std::complex<double>;

  constexpr Complex imaginary_unit(0., 1.);

  constexpr double pi = 3.14159265358979323846;

  /** Of a number that nobody knows: it is no number in tables either. */
  constexpr double not_known = std::numeric_limits<double>::quiet_NaN();

  /** One degree [rad]. */
  constexpr double degree = pi / 180.;

  /** One second of arc [rad]. */
  constexpr double arcsecond = pi / (180. * 3600.);

  /** [mm] */
  constexpr double micrometre = 1e-3;

  /** Rigid placement y = rotation * x + translation. */
  struct RigidMotion
  {
    Matrix3 rotation    = Matrix3::Identity();
    Vector3 translation = Vector3::Zero();

    Vector3 operator()(const Vector3 &x) const
    {
      return rotation * x + translation;
    }
  };

  /** Of a point about the axis z, in (-pi, pi]. */
  inline double polar_angle(const Vector3 &x)
  {
    return std::atan2(x[1], x[0]);
  }

  /** An angle that is known but for whole turns, with as many of them as bring it nearest to what
   * it was a moment ago, @p before [rad]. Without any it keeps its last digit. */
  inline double count_turns(const double angle, const double before)
  {
    return angle + 2. * pi * std::nearbyint((before - angle) / (2. * pi));
  }

  /** Rotation by @p angle [rad] about the unit vector @p axis (right-hand rule). */
  inline Matrix3 rotation_about(const Vector3 &axis, const double angle)
  {
    return Eigen::AngleAxisd(angle, axis).toRotationMatrix();
  }
} // namespace vfife

#endif
