// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/gear/newton.h>
#include <vfife/gear/spiral_bevel/flank.h>

#include <Eigen/LU>

#include <cmath>

namespace vfife
{
  namespace
  {
    /** @p v turned about z by the angle of cosine @p c and sine @p s. */
    Vector3 rotate_about_z(const double c, const double s, const Vector3 &v)
    {
      return {c * v[0] - s * v[1], s * v[0] + c * v[1], v[2]};
    }

    /** z x v: the velocity of v that turns about z at unit rate. */
    Vector3 z_cross(const Vector3 &v)
    {
      return {-v[1], v[0], 0.};
    }
  } // namespace

  struct Flank::Cutter
  {
    Vector3 center, center_phi; ///< of the circle of blade tips, from the machine centre [mm]
    Matrix3 tilt, tilt_phi;     ///< turns vectors of the upright cutter
    double  ratio, ratio_phi;   ///< of roll, and its rate
    double  cos_blank, sin_blank;

    /** A vector of the upright cutter (and its derivative by t) in the machine. */
    Moving carry(const Vector3 &v, const Vector3 &v_t) const;
  };

  struct Flank::Moving
  {
    Vector3 value, t, phi;

    Moving operator+(const Moving &other) const
    {
      return {value + other.value, t + other.t, phi + other.phi};
    }
  };

  struct Flank::Meshing
  {
    double value, t, phi;
  };

  struct Flank::EdgePoint
  {
    Moving  position, normal;
    Meshing meshing;
  };

  Flank::Moving Flank::Cutter::carry(const Vector3 &v, const Vector3 &v_t) const
  {
    return {tilt * v, tilt * v_t, tilt_phi * v};
  }

  Flank::Flank(const MachineSettings &settings, const double pitch_angle)
    : settings_(settings)
    , cos_pitch_(std::cos(pitch_angle))
    , sin_pitch_(std::sin(pitch_angle))
    , sin_blade_(std::sin(settings.blade_angle))
    , cos_blade_(std::cos(settings.blade_angle))
    , sin_root_(std::sin(settings.machine_root_angle))
    , cos_root_(std::cos(settings.machine_root_angle))
    , apex_(settings.machine_center_to_back * cos_root_,
            settings.blank_offset,
            -settings.sliding_base - settings.machine_center_to_back * sin_root_)
  {
    if (!(settings.ratio_of_roll > 0.))
      throw InputError("a flank cannot be generated without a ratio of roll");
    if (!(settings.point_radius > 0.))
      throw InputError("a flank cannot be generated without a point radius");
  }

  const MachineSettings &Flank::settings() const
  {
    return settings_;
  }

  FlankSide Flank::side() const
  {
    return settings_.blade == Blade::outside ? FlankSide::concave : FlankSide::convex;
  }

  Vector3 Flank::into_blank_frame(const Vector3 &v) const
  {
    return {sin_root_ * v[0] + cos_root_ * v[2], -v[1], cos_root_ * v[0] - sin_root_ * v[2]};
  }

  // Machine frame, seen along the cradle axis z; the upright cutter's axis is z as well.
  //
  //      y ^         C  cutter centre; round it the blade tips, radius r_p, at the angles t
  //        |      . '
  //        |  S . '        the blank's axis a lies in the plane of x and z, its apex at O
  //        |  . '  q + phi
  //        +-----------------> x, along the root generatrix
  Flank::Cutter Flank::cutter_at(const double phi) const
  {
    // Centre of the blade tips' circle, carried round the cradle axis:
    //   C = S (cos(q + phi), sin(q + phi), 0),   dC/dphi = z x C
    const double Q = settings_.cradle_angle + phi, S = settings_.radial_distance;
    Cutter       cutter;
    cutter.center     = {S * std::cos(Q), S * std::sin(Q), 0.};
    cutter.center_phi = z_cross(cutter.center);
    // The direction of the tilt turns with the cradle: dT/dphi v = z x T v - T (z x v).
    const Vector3 direction =
      rotate_about_z(std::cos(phi), std::sin(phi), settings_.tilt_direction());
    cutter.tilt = rotation_about(direction, settings_.cutter_tilt);
    for (unsigned int d = 0; d < 3; ++d)
      cutter.tilt_phi.col(d) =
        z_cross(cutter.tilt.col(d)) - cutter.tilt * z_cross(Vector3::Unit(d));
    // The blank turns by psi(phi); psi' is the ratio of roll at this position.
    cutter.ratio     = settings_.roll_rate(phi);
    cutter.ratio_phi = settings_.roll_acceleration(phi);
    const double psi = settings_.blank_rotation(phi);
    cutter.cos_blank = std::cos(psi);
    cutter.sin_blank = std::sin(psi);
    return cutter;
  }

  Flank::Moving Flank::relative_to_apex(const Cutter &cutter, const Moving &from_center) const
  {
    return Moving{cutter.center - apex_, Vector3::Zero(), cutter.center_phi} + from_center;
  }

  Flank::Moving Flank::into_body(const Cutter &cutter, const Moving &v) const
  {
    // X = Rz(psi) R v,   dX/dphi = Rz(psi) R dv/dphi + psi' z x X
    const auto turned = [&](const Vector3 &x) {
      return rotate_about_z(cutter.cos_blank, cutter.sin_blank, into_blank_frame(x));
    };
    const Vector3 value = turned(v.value);
    return {value, turned(v.t), turned(v.phi) + cutter.ratio * z_cross(value)};
  }

  Flank::Meshing Flank::meshing(const Cutter  &cutter,
                                const Moving  &normal,
                                const Moving  &position,
                                const Vector3 &apex) const
  {
    // f = n . v,   v = z x r + psi' a x (r - O): velocity of the cutter's point relative to the
    // blank; r from the machine centre, r - O from the apex, a the axis of the blank.
    // Derivatives by the product rule; psi' depends on phi alone.
    const Vector3 axis(cos_root_, 0., -sin_root_);
    const auto    velocity = [&](const Vector3 &from_machine, const Vector3 &from_apex) -> Vector3 {
      return z_cross(from_machine) + cutter.ratio * axis.cross(from_apex);
    };
    const Vector3 v = velocity(position.value + apex, position.value);
    const Vector3 v_phi =
      velocity(position.phi, position.phi) + cutter.ratio_phi * axis.cross(position.value);
    return {normal.value.dot(v),
            normal.t.dot(v) + normal.value.dot(velocity(position.t, position.t)),
            normal.phi.dot(v) + normal.value.dot(v_phi)};
  }

  // Blade in the plane of e and z; sigma = +1 outside, -1 inside, where it leans the other way.
  //
  //      z ^         /
  //        |        /  al, to the cutter axis
  //        |       / s
  //        +------/----------> e
  //          r_p   tip plane z = 0
  SurfaceDerivatives Flank::generate(const double t, const double phi) const
  {
    const double  sigma  = settings_.sigma();
    const Cutter  cutter = cutter_at(phi);
    const Vector3 e(std::cos(t), std::sin(t), 0.), e_t = z_cross(e), z = Vector3::UnitZ();

    // The straight blade at the angle t about the cutter axis, s from its tip, seen from the apex:
    //   r = P0 + s P1,   P0 = C - O + r_p T e,   P1 = T (sigma sin al e + cos al z)
    //   n = T (sigma cos al e - sin al z), which does not depend on s
    const Moving P0 =
      relative_to_apex(cutter,
                       cutter.carry(settings_.point_radius * e, settings_.point_radius * e_t));
    const Moving P1 =
      cutter.carry(sigma * sin_blade_ * e + cos_blade_ * z, sigma * sin_blade_ * e_t);
    const Moving n =
      cutter.carry(sigma * cos_blade_ * e - sin_blade_ * z, sigma * cos_blade_ * e_t);

    // The equation of meshing is linear in s: f0 + s f1 = 0 gives the point that generates,
    //   s = -f0 / f1,   ds = -(df0 + s df1) / f1
    const Meshing constant = meshing(cutter, n, P0, apex_);
    const Meshing linear   = meshing(cutter, n, P1, Vector3::Zero());
    const double  s        = -constant.value / linear.value;
    const double  s_t      = -(constant.t + s * linear.t) / linear.value;
    const double  s_phi    = -(constant.phi + s * linear.phi) / linear.value;

    // Position and normal in the frame of the turned blank; s depends on t and phi.
    const Moving       position = into_body(cutter,
                                      {P0.value + s * P1.value,
                                             P0.t + s * P1.t + s_t * P1.value,
                                             P0.phi + s * P1.phi + s_phi * P1.value});
    const Moving       normal   = into_body(cutter, n);
    SurfaceDerivatives result;
    result.point.position = position.value;
    result.point.normal   = normal.value;
    result.point.t        = t;
    result.point.phi      = phi;
    result.point.s        = s;
    result.position_t     = position.t;
    result.position_phi   = position.phi;
    result.normal_t       = normal.t;
    result.normal_phi     = normal.phi;
    return result;
  }

  Vector2 Flank::cone_coordinates(const Vector3 &position) const
  {
    const double r = std::hypot(position[0], position[1]), z = position[2];
    return {z * cos_pitch_ + r * sin_pitch_, r * cos_pitch_ - z * sin_pitch_};
  }

  Flank::EdgePoint Flank::edge_point(const double t, const double phi, const double lambda) const
  {
    // The rounded edge touches the blade at the distance edge_width() from the sharp tip and the
    // tip plane below it:
    //   radius  r_p - sigma w + sigma rf sin(lambda),   height  rf (1 - cos(lambda))
    //   n = T (sigma sin(lambda) e - cos(lambda) z)
    const double sigma = settings_.sigma(), sin_l = std::sin(lambda), cos_l = std::cos(lambda);
    const double radius = settings_.point_radius - sigma * settings_.edge_width() +
                          sigma * settings_.edge_radius * sin_l;
    const double  height = settings_.edge_radius * (1. - cos_l);
    const Cutter  cutter = cutter_at(phi);
    const Vector3 e(std::cos(t), std::sin(t), 0.), e_t = z_cross(e), z = Vector3::UnitZ();

    const Moving position =
      relative_to_apex(cutter, cutter.carry(radius * e + height * z, radius * e_t));
    const Moving normal = cutter.carry(sigma * sin_l * e - cos_l * z, sigma * sin_l * e_t);
    return {into_body(cutter, position),
            into_body(cutter, normal),
            meshing(cutter, normal, position, apex_)};
  }

  GeneratedPoint Flank::fillet_at(const double L, const double lambda) const
  {
    // Two equations for (t, phi): the edge's point at lambda generates, f = 0, and stands at L.
    const auto equations = [&](const Vector2 &x, Vector2 &residual, Eigen::Matrix2d &jacobian) {
      const EdgePoint point = edge_point(x[0], x[1], lambda);
      const Vector3  &X     = point.position.value;
      const double    r     = std::hypot(X[0], X[1]);
      const auto      dL    = [&](const Vector3 &dX) {
        return dX[2] * cos_pitch_ + (X[0] * dX[0] + X[1] * dX[1]) / r * sin_pitch_;
      };
      residual = Vector2(point.meshing.value, X[2] * cos_pitch_ + r * sin_pitch_ - L);
      jacobian << point.meshing.t, point.meshing.phi, dL(point.position.t), dL(point.position.phi);
    };
    Vector2 x = start(L);
    if (!solve_newton<2>(equations, x))
      refuse("fillet", L, "blade edge angle lambda [rad]", lambda);

    const EdgePoint point = edge_point(x[0], x[1], lambda);
    GeneratedPoint  result;
    result.position = point.position.value;
    result.normal   = point.normal.value;
    result.t        = x[0];
    result.phi      = x[1];
    result.s        = lambda;
    return result;
  }

  Vector2 Flank::principal_curvatures(const GeneratedPoint &point) const
  {
    const SurfaceDerivatives    surface = derivatives(point.t, point.phi);
    Eigen::Matrix<double, 3, 2> X, N;
    X << surface.position_t, surface.position_phi;
    N << surface.normal_t, surface.normal_phi;
    // Weingarten: second derivatives times N are minus first derivatives times those of N, so the
    // shape operator is -I^-1 (X_i . N_j), I_ij = X_i . X_j
    const Eigen::Matrix2d shape  = -(X.transpose() * X).inverse() * (X.transpose() * N);
    const double          mean   = shape.trace() / 2;
    const double half_difference = std::sqrt(std::max(0., mean * mean - shape.determinant()));
    return {mean - half_difference, mean + half_difference};
  }

  Matrix3 Flank::curvature_tensor(const GeneratedPoint &point) const
  {
    const SurfaceDerivatives    surface = derivatives(point.t, point.phi);
    Eigen::Matrix<double, 3, 2> X, N;
    X << surface.position_t, surface.position_phi;
    N << surface.normal_t, surface.normal_phi;
    // K = -X^i (X_i . N_j) X^j with the dual base X^i of the tangents
    const Eigen::Matrix<double, 3, 2> dual = X * (X.transpose() * X).inverse();
    const Matrix3                     K    = -dual * (X.transpose() * N) * dual.transpose();
    return (K + K.transpose()) / 2; // symmetric but for round-off
  }

  double Flank::spiral_angle(const GeneratedPoint &point) const
  {
    // the trace on the pitch-parallel cone is normal to both the flank's and the cone's normals
    const Vector3 radial     = Vector3(point.position[0], point.position[1], 0.).normalized();
    const Vector3 tangential = z_cross(radial);
    const Vector3 generatrix = sin_pitch_ * radial + cos_pitch_ * Vector3::UnitZ();
    return std::atan2(std::abs(point.normal.dot(generatrix)),
                      std::abs(point.normal.dot(tangential)));
  }

  double Flank::ratio_of_roll_at(const MachineSettings &settings, const double t, const double s)
  {
    // f = n . (z x r) + Ra n . (a x (r - O)) = 0 solved for Ra; any ratio of roll serves to make
    // the frames
    MachineSettings trial = settings;
    trial.ratio_of_roll   = 1.;
    const Flank   flank(trial, pi / 4);
    const Cutter  cutter = flank.cutter_at(0.);
    const double  sigma  = settings.sigma();
    const Vector3 e(std::cos(t), std::sin(t), 0.), axis(flank.cos_root_, 0., -flank.sin_root_);
    const Vector3 n =
      cutter.tilt * (sigma * flank.cos_blade_ * e - flank.sin_blade_ * Vector3::UnitZ());
    const Vector3 r =
      cutter.center + cutter.tilt * ((settings.point_radius + sigma * s * flank.sin_blade_) * e +
                                     s * flank.cos_blade_ * Vector3::UnitZ());
    return -n.dot(z_cross(r)) / n.dot(axis.cross(r - flank.apex_));
  }

  double Flank::angle_of_normal(const MachineSettings &settings, const double axial)
  {
    // (T n) . a = n . b with b = T^-1 a: sigma cos al (b_x cos t + b_y sin t) - sin al b_z
    const double  g = settings.machine_root_angle, al = settings.blade_angle;
    const Vector3 b = rotation_about(settings.tilt_direction(), -settings.cutter_tilt) *
                      Vector3(std::cos(g), 0., -std::sin(g));
    const double cosine =
      (axial + std::sin(al) * b[2]) / (settings.sigma() * std::cos(al) * std::hypot(b[0], b[1]));
    return polar_angle(b) +
           std::copysign(std::acos(std::max(-1., std::min(1., cosine))), -settings.cradle_angle);
  }

  double Flank::straight_start() const
  {
    return settings_.edge_width();
  }
} // namespace vfife
