// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/gear/newton.h>
#include <vfife/gear/spiral_bevel/flank_contact.h>

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>

namespace vfife
{
  RigidMotion pinion_frame(const double shaft_angle)
  {
    const double c = std::cos(shaft_angle), s = std::sin(shaft_angle);
    RigidMotion  frame;
    frame.rotation << -c, 0., s, //
      0., -1., 0.,               //
      s, 0., c;
    return frame;
  }

  RigidMotion gear_frame()
  {
    return {};
  }

  RigidMotion turned_frame(const RigidMotion &frame, const double rotation)
  {
    return {frame.rotation * rotation_about(Vector3::UnitZ(), rotation), frame.translation};
  }

  bool find_meshing_rotation(const GeneratedPoint &gear_point,
                             const RigidMotion    &pinion_frame,
                             const RigidMotion    &gear_frame,
                             const double          speed_ratio,
                             double               &rotation)
  {
    const Vector3 pinion_axis = pinion_frame.rotation.col(2),
                  gear_axis   = gear_frame.rotation.col(2);
    // normal component of the relative velocity, pinion at rate 1, gear at - speed ratio
    const auto f = [&](const double angle) {
      const RigidMotion placement = turned_frame(gear_frame, angle);
      const Vector3     P         = placement(gear_point.position);
      return (placement.rotation * gear_point.normal)
        .dot(pinion_axis.cross(P - pinion_frame.translation) +
             speed_ratio * gear_axis.cross(P - gear_frame.translation));
    };
    // P and n are linear in cosine and sine of the rotation, and the product of both enters with
    // the turning of the arm about the pinion's axis only: n . (a x P) = a . (P x n). Hence
    // f = c + a cos + b sin exactly.
    // Three values give c, a and b; of the two roots, crest +- width, the nearer one counts.
    const double f0 = f(0.), f_half = f(pi), f_quarter = f(pi / 2);
    const double c = (f0 + f_half) / 2, a = (f0 - f_half) / 2, b = f_quarter - c;
    const double amplitude = std::hypot(a, b);
    if (!(std::abs(c) < amplitude))
      return false;
    const double crest = std::atan2(b, a), width = std::acos(-c / amplitude);
    const double one = std::remainder(crest + width - rotation, 2. * pi);
    const double two = std::remainder(crest - width - rotation, 2. * pi);
    rotation += std::abs(one) < std::abs(two) ? one : two;
    return true;
  }

  FlankContact::FlankContact(const Flank       &pinion,
                             const Flank       &gear,
                             const RigidMotion &pinion_frame,
                             const RigidMotion &gear_frame,
                             const double       speed_ratio,
                             const double       length)
    : pinion_(pinion)
    , gear_(gear)
    , pinion_frame_(pinion_frame)
    , gear_frame_(gear_frame)
    , speed_ratio_(speed_ratio)
    , length_(length)
  {
  }

  const Flank &FlankContact::pinion() const
  {
    return pinion_;
  }

  const Flank &FlankContact::gear() const
  {
    return gear_;
  }

  const RigidMotion &FlankContact::pinion_frame() const
  {
    return pinion_frame_;
  }

  const RigidMotion &FlankContact::gear_frame() const
  {
    return gear_frame_;
  }

  namespace
  {
    /** Position, normal and their derivatives by (t, phi, rotation) of a mounted flank, in the
     * fixed frame. */
    struct MountedPoint
    {
      Vector3 position, normal, axis,
        arm; ///< arm: from the origin of the frame, which lies on the axis
      Matrix3 d_position, d_normal;

      MountedPoint(const Flank       &flank,
                   const RigidMotion &frame,
                   const double       t,
                   const double       phi,
                   const double       rotation)
      {
        const SurfaceDerivatives surface   = flank.derivatives(t, phi);
        const RigidMotion        placement = turned_frame(frame, rotation);
        const Matrix3           &R         = placement.rotation;
        axis                               = R.col(2);
        arm                                = R * surface.point.position;
        position                           = arm + placement.translation;
        normal                             = R * surface.point.normal;
        d_position << R * surface.position_t, R * surface.position_phi, axis.cross(arm);
        d_normal << R * surface.normal_t, R * surface.normal_phi, axis.cross(normal);
      }
    };
  } // namespace

  void FlankContact::evaluate(const Unknowns &x, Unknowns &residual, Jacobian &jacobian) const
  {
    const MountedPoint pinion(pinion_, pinion_frame_, x[t1], x[phi1], x[rot1]);
    const MountedPoint gear(gear_, gear_frame_, x[t2], x[phi2], x[rot2]);

    // rows 0-2: x1 - x2 = 0
    residual.head<3>()         = (pinion.position - gear.position) / length_;
    jacobian.block<3, 3>(0, 0) = pinion.d_position / length_;
    jacobian.block<3, 3>(0, 3) = -gear.d_position / length_;

    // rows 3, 4: n1 + n2 = 0 in two directions normal to the gear's normal. They are held fixed in
    // the derivatives: at the solution the sum of normals vanishes and so does their contribution.
    const Vector3 u = gear.normal.unitOrthogonal(), v = gear.normal.cross(u);
    const Vector3 sum = pinion.normal + gear.normal;
    unsigned int  row = 3;
    for (const Vector3 &direction : {u, v})
      {
        residual[row]                = direction.dot(sum);
        jacobian.block<1, 3>(row, 0) = direction.transpose() * pinion.d_normal;
        jacobian.block<1, 3>(row, 3) = direction.transpose() * gear.d_normal;
        ++row;
      }

    // row 5: n . (a1 x arm1 + ratio a2 x arm2) = 0 with each arm taken to its own flank's point
    const Vector3 velocity =
      pinion.axis.cross(pinion.arm) + speed_ratio_ * gear.axis.cross(gear.arm);
    residual[5] = gear.normal.dot(velocity) / length_;
    jacobian.block<1, 3>(5, 0) =
      gear.normal.cross(pinion.axis).transpose() * pinion.d_position / length_;
    jacobian.block<1, 3>(5, 3) =
      (velocity.transpose() * gear.d_normal +
       speed_ratio_ * gear.normal.cross(gear.axis).transpose() * gear.d_position) /
      length_;
  }

  bool FlankContact::solve_at_rotation(Unknowns &x) const
  {
    // rot1 is held, row 5 left out: five equations for the five others
    constexpr Unknown free[5] = {t1, phi1, t2, phi2, rot2};
    using Five                = Eigen::Matrix<double, 5, 1>;
    const auto equations =
      [&](const Five &y, Five &residual, Eigen::Matrix<double, 5, 5> &jacobian) {
        Unknowns trial = x, all;
        Jacobian all_derivatives;
        for (unsigned int i = 0; i < 5; ++i)
          trial[free[i]] = y[i];
        evaluate(trial, all, all_derivatives);
        residual = all.head<5>();
        for (unsigned int i = 0; i < 5; ++i)
          jacobian.col(i) = all_derivatives.col(free[i]).head<5>();
      };
    Five y;
    for (unsigned int i = 0; i < 5; ++i)
      y[i] = x[free[i]];
    if (!solve_newton<5>(equations, y))
      return false;
    for (unsigned int i = 0; i < 5; ++i)
      x[free[i]] = y[i];
    // the equations of the normals are satisfied by equal ones too
    const Vector3 n1 =
      turned_frame(pinion_frame_, x[rot1]).rotation * pinion_.evaluate(x[t1], x[phi1]).normal;
    const Vector3 n2 =
      turned_frame(gear_frame_, x[rot2]).rotation * gear_.evaluate(x[t2], x[phi2]).normal;
    return n1.dot(n2) < 0.;
  }

  bool FlankContact::follow(const double rotation, Unknowns &x) const
  {
    // With few teeth longer steps jump to another solution of the equations [rad].
    constexpr double   longest_step = 0.05;
    const double       start        = x[rot1];
    const unsigned int n_steps =
      std::max(1u, static_cast<unsigned int>(std::ceil(std::abs(rotation - start) / longest_step)));
    // Secant prediction; before the first step the gear is taken to follow at the exact ratio.
    const auto go = [&](const unsigned int n, Unknowns &y) {
      const double step     = (rotation - start) / n;
      Unknowns     previous = y;
      previous[rot2] += speed_ratio_ * step;
      for (unsigned int i = 1; i <= n; ++i)
        {
          const Unknowns last = y;
          y += y - previous;
          y[rot1] = start + i * step;
          if (!solve_at_rotation(y))
            return false;
          previous = last;
        }
      return true;
    };
    // Where a step finds no solution the same way is gone in smaller ones.
    for (const unsigned int parts : {1u, 3u, 9u})
      {
        Unknowns trial = x;
        if (go(n_steps * parts, trial))
          {
            x = trial;
            return true;
          }
      }
    return false;
  }

  ContactEllipse FlankContact::ellipse(const Unknowns &x, const double separation) const
  {
    // each flank bends to its own metal: the gap opens with the sum of both curvatures
    const GeneratedPoint one = pinion_.evaluate(x[t1], x[phi1]),
                         two = gear_.evaluate(x[t2], x[phi2]);
    const Matrix3 R1         = turned_frame(pinion_frame_, x[rot1]).rotation;
    const Matrix3 R2         = turned_frame(gear_frame_, x[rot2]).rotation;
    const Matrix3 relative   = R1 * pinion_.curvature_tensor(one) * R1.transpose() +
                             R2 * gear_.curvature_tensor(two) * R2.transpose();

    // principal curvatures of the gap in the tangent plane, smaller one first
    const Vector3               normal = -(R2 * two.normal);
    const Vector3               u = normal.unitOrthogonal(), v = normal.cross(u);
    Eigen::Matrix<double, 3, 2> tangents;
    tangents << u, v;
    Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> eigen;
    eigen.computeDirect(tangents.transpose() * relative * tangents);

    // gap = k s^2 / 2 along each principal direction
    ContactEllipse ellipse;
    ellipse.relative_curvatures = eigen.eigenvalues();
    ellipse.semi_axes           = (2. * separation / eigen.eigenvalues().array()).sqrt();
    ellipse.major_direction     = tangents * eigen.eigenvectors().col(0);
    return ellipse;
  }
} // namespace vfife
