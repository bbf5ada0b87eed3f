// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/gear/flank.h>
#include <vfife/gear/newton.h>

#include <Eigen/LU>

#include <cmath>
#include <sstream>

namespace vfife
{
  namespace
  {
    Vector3 rotate_about_z(const double c, const double s, const Vector3 &v)
    {
      return {c * v[0] - s * v[1], s * v[0] + c * v[1], v[2]};
    }

    /** z x v */
    Vector3 z_cross(const Vector3 &v)
    {
      return {-v[1], v[0], 0.};
    }

    [[noreturn]] void refuse(
      const Blade blade, const char *surface, const double L, const char *name, const double value)
    {
      std::ostringstream message;
      message << "the machine settings generate no "
              << (blade == Blade::outside ? "concave " : "convex ") << surface
              << " at cone distance L = " << L << " mm, " << name << " = " << value;
      throw InputError(message.str());
    }
  } // namespace

  struct Flank::BlankFramePoint
  {
    Vector3 position, position_t, position_phi; ///< [mm], [mm/rad]
    Vector3 normal;
    double  meshing, meshing_t, meshing_phi; ///< equation of meshing f [mm] and its derivatives
  };

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

  SurfacePoint Flank::evaluate(const double t, const double phi) const
  {
    return derivatives(t, phi).point;
  }

  SurfaceDerivatives Flank::derivatives(const double t, const double phi) const
  {
    const double sigma = settings_.sigma(), S = settings_.radial_distance,
                 ratio = settings_.ratio_of_roll;
    const double Q     = settings_.cradle_angle + phi;
    const double cos_t = std::cos(t), sin_t = std::sin(t), cos_Q = std::cos(Q), sin_Q = std::sin(Q);
    const Vector3 axis(cos_root_, 0., -sin_root_);
    const Vector3 e(cos_t, sin_t, 0.), e_t(-sin_t, cos_t, 0.);

    // r = P0 + s P1 in the machine frame, from the apex; n does not depend on s
    const Vector3 center(S * cos_Q, S * sin_Q, 0.), center_phi(-S * sin_Q, S * cos_Q, 0.);
    const Vector3 P0   = center + settings_.point_radius * e - apex_,
                  P0_t = settings_.point_radius * e_t;
    const Vector3 P1(sigma * sin_blade_ * cos_t, sigma * sin_blade_ * sin_t, cos_blade_);
    const Vector3 P1_t = sigma * sin_blade_ * e_t;
    const Vector3 n(sigma * cos_blade_ * cos_t, sigma * cos_blade_ * sin_t, -sin_blade_);
    const Vector3 n_t = sigma * cos_blade_ * e_t;

    // Equation of meshing, numerator + s denominator = 0. Terms of z x r other than z x C vanish:
    // the cutter is a surface of revolution about z.
    const Vector3 m = n.cross(axis), m_t = n_t.cross(axis);
    const double  sin_tQ = sin_t * cos_Q - cos_t * sin_Q, cos_tQ = cos_t * cos_Q + sin_t * sin_Q;
    const double  numerator = sigma * cos_blade_ * S * sin_tQ + ratio * m.dot(P0);
    const double  numerator_t =
      sigma * cos_blade_ * S * cos_tQ + ratio * (m_t.dot(P0) + m.dot(P0_t));
    const double numerator_phi = -sigma * cos_blade_ * S * cos_tQ + ratio * m.dot(center_phi);
    const double denominator   = ratio * m.dot(P1);
    const double denominator_t = ratio * (m_t.dot(P1) + m.dot(P1_t));
    const double s             = -numerator / denominator;
    const double s_t           = -(numerator_t + s * denominator_t) / denominator;
    const double s_phi         = -numerator_phi / denominator;

    const double c_psi = std::cos(ratio * phi), s_psi = std::sin(ratio * phi);
    const auto   to_body = [&](const Vector3 &v) {
      return rotate_about_z(c_psi, s_psi, into_blank_frame(v));
    };
    SurfaceDerivatives result;
    result.point.position = to_body(P0 + s * P1);
    result.point.normal   = to_body(n);
    result.point.t        = t;
    result.point.phi      = phi;
    result.point.s        = s;
    result.position_t     = to_body(P0_t + s * P1_t + s_t * P1);
    result.position_phi = to_body(center_phi + s_phi * P1) + ratio * z_cross(result.point.position);
    result.normal_t     = to_body(n_t);
    result.normal_phi   = ratio * z_cross(result.point.normal);
    return result;
  }

  Vector2 Flank::cone_coordinates(const Vector3 &position) const
  {
    const double r = std::hypot(position[0], position[1]), z = position[2];
    return {z * cos_pitch_ + r * sin_pitch_, r * cos_pitch_ - z * sin_pitch_};
  }

  Vector2 Flank::start(const double L) const
  {
    const double S = settings_.radial_distance, q = settings_.cradle_angle;
    return {std::atan2(-S * std::sin(q), L - S * std::cos(q)), 0.};
  }

  SurfacePoint Flank::point_at(const double L, const double h) const
  {
    const Vector2 target(L, h);
    const auto    equations = [&](const Vector2 &x, Vector2 &residual, Eigen::Matrix2d &jacobian) {
      const SurfaceDerivatives surface = derivatives(x[0], x[1]);
      const Vector3           &X       = surface.point.position;
      const double             r       = std::hypot(X[0], X[1]);
      residual =
        Vector2(X[2] * cos_pitch_ + r * sin_pitch_, r * cos_pitch_ - X[2] * sin_pitch_) - target;
      const Vector3 *columns[2] = {&surface.position_t, &surface.position_phi};
      for (unsigned int j = 0; j < 2; ++j)
        {
          const Vector3 &dX = *columns[j];
          const double   dr = (X[0] * dX[0] + X[1] * dX[1]) / r;
          jacobian(0, j)    = dX[2] * cos_pitch_ + dr * sin_pitch_;
          jacobian(1, j)    = dr * cos_pitch_ - dX[2] * sin_pitch_;
        }
    };
    Vector2 x = start(L);
    if (!solve_newton<2>(equations, x))
      refuse(settings_.blade, "flank", L, "height over the pitch cone h [mm]", h);
    return evaluate(x[0], x[1]);
  }

  Flank::BlankFramePoint
  Flank::fillet_equations(const double t, const double phi, const double lambda) const
  {
    const double sigma = settings_.sigma(), S = settings_.radial_distance,
                 ratio = settings_.ratio_of_roll;
    const double Q     = settings_.cradle_angle + phi;
    const double sin_l = std::sin(lambda), cos_l = std::cos(lambda);
    const double radius = settings_.point_radius - sigma * settings_.edge_width() +
                          sigma * settings_.edge_radius * sin_l;
    const Vector3 axis(cos_root_, 0., -sin_root_);
    const Vector3 e(std::cos(t), std::sin(t), 0.), e_t(-e[1], e[0], 0.);
    const Vector3 center(S * std::cos(Q), S * std::sin(Q), 0.),
      center_phi(-center[1], center[0], 0.);

    Vector3 r = center + radius * e - apex_;
    r[2] += settings_.edge_radius * (1. - cos_l);
    Vector3 n       = sigma * sin_l * e;
    n[2]            = -cos_l;
    const Vector3 m = n.cross(axis), m_t = (sigma * sin_l * e_t).cross(axis);
    const double  cos_tQ = (e[0] * center[0] + e[1] * center[1]) / S;
    const double  sin_tQ = (e[1] * center[0] - e[0] * center[1]) / S;

    BlankFramePoint point;
    point.position     = into_blank_frame(r);
    point.position_t   = into_blank_frame(radius * e_t);
    point.position_phi = into_blank_frame(center_phi);
    point.normal       = into_blank_frame(n);
    point.meshing      = sigma * sin_l * S * sin_tQ + ratio * m.dot(r);
    point.meshing_t    = sigma * sin_l * S * cos_tQ + ratio * (m_t.dot(r) + m.dot(radius * e_t));
    point.meshing_phi  = -sigma * sin_l * S * cos_tQ + ratio * m.dot(center_phi);
    return point;
  }

  SurfacePoint Flank::fillet_at(const double L, const double lambda) const
  {
    const auto equations = [&](const Vector2 &x, Vector2 &residual, Eigen::Matrix2d &jacobian) {
      const BlankFramePoint point = fillet_equations(x[0], x[1], lambda);
      const Vector3        &X     = point.position;
      const double          r     = std::hypot(X[0], X[1]);
      const auto            dL    = [&](const Vector3 &dX) {
        return dX[2] * cos_pitch_ + (X[0] * dX[0] + X[1] * dX[1]) / r * sin_pitch_;
      };
      residual = Vector2(point.meshing, X[2] * cos_pitch_ + r * sin_pitch_ - L);
      jacobian << point.meshing_t, point.meshing_phi, dL(point.position_t), dL(point.position_phi);
    };
    Vector2 x = start(L);
    if (!solve_newton<2>(equations, x))
      refuse(settings_.blade, "fillet", L, "blade edge angle lambda [rad]", lambda);

    const BlankFramePoint point = fillet_equations(x[0], x[1], lambda);
    const double          c     = std::cos(settings_.ratio_of_roll * x[1]),
                 s              = std::sin(settings_.ratio_of_roll * x[1]);
    SurfacePoint result;
    result.position = rotate_about_z(c, s, point.position);
    result.normal   = rotate_about_z(c, s, point.normal);
    result.t        = x[0];
    result.phi      = x[1];
    result.s        = lambda;
    return result;
  }

  Vector2 Flank::principal_curvatures(const SurfacePoint &point) const
  {
    const SurfaceDerivatives    surface = derivatives(point.t, point.phi);
    Eigen::Matrix<double, 3, 2> X, N;
    X << surface.position_t, surface.position_phi;
    N << surface.normal_t, surface.normal_phi;
    // Weingarten: second derivatives times N are minus first derivatives times those of N
    const Eigen::Matrix2d shape  = -(X.transpose() * X).inverse() * (X.transpose() * N);
    const double          mean   = shape.trace() / 2;
    const double half_difference = std::sqrt(std::max(0., mean * mean - shape.determinant()));
    return {mean - half_difference, mean + half_difference};
  }

  Matrix3 Flank::curvature_tensor(const SurfacePoint &point) const
  {
    const SurfaceDerivatives    surface = derivatives(point.t, point.phi);
    Eigen::Matrix<double, 3, 2> X, N;
    X << surface.position_t, surface.position_phi;
    N << surface.normal_t, surface.normal_phi;
    const Eigen::Matrix<double, 3, 2> dual = X * (X.transpose() * X).inverse();
    const Matrix3                     K    = -dual * (X.transpose() * N) * dual.transpose();
    return (K + K.transpose()) / 2; // symmetric but for round-off
  }

  double Flank::spiral_angle(const SurfacePoint &point) const
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
    // f = n . (z x C) + Ra n . (a x (r - O)) = 0 solved for Ra; any ratio of roll serves to make
    // the frames
    MachineSettings trial = settings;
    trial.ratio_of_roll   = 1.;
    const Flank   flank(trial, pi / 4);
    const double  sigma = settings.sigma(), S = settings.radial_distance, q = settings.cradle_angle;
    const Vector3 e(std::cos(t), std::sin(t), 0.), axis(flank.cos_root_, 0., -flank.sin_root_);
    const Vector3 n = sigma * flank.cos_blade_ * e - flank.sin_blade_ * Vector3::UnitZ();
    const Vector3 r = S * Vector3(std::cos(q), std::sin(q), 0.) +
                      (settings.point_radius + sigma * s * flank.sin_blade_) * e +
                      s * flank.cos_blade_ * Vector3::UnitZ() - flank.apex_;
    return -sigma * flank.cos_blade_ * S * std::sin(t - q) / n.dot(axis.cross(r));
  }

  double Flank::straight_start() const
  {
    return settings_.edge_width();
  }
} // namespace vfife
