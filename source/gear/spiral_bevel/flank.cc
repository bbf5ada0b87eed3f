// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/gear/newton.h>
#include <vfife/gear/spiral_bevel/cutter_passages.h>
#include <vfife/gear/spiral_bevel/flank.h>

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace vfife
{
  Flank::Flank(const MachineSettings &settings, const double pitch_angle)
    : surface_(settings)
    , cos_pitch_(std::cos(pitch_angle))
    , sin_pitch_(std::sin(pitch_angle))
  {
  }

  const MachineSettings &Flank::settings() const
  {
    return surface_.settings();
  }

  FlankSide Flank::side() const
  {
    return settings().blade == Blade::outside ? FlankSide::concave : FlankSide::convex;
  }

  Vector2 Flank::cone_coordinates(const Vector3 &position) const
  {
    const double r = std::hypot(position[0], position[1]), z = position[2];
    return {z * cos_pitch_ + r * sin_pitch_, r * cos_pitch_ - z * sin_pitch_};
  }

  Flank Flank::with_deviation(const FlankDeviation &deviation) const
  {
    Flank flank      = *this;
    flank.deviation_ = deviation;
    return flank;
  }

  GeneratedPoint Flank::evaluate(const double t, const double phi) const
  {
    return deviation_ ? displace(t, phi).point : surface_.generate(t, phi).point;
  }

  SurfaceDerivatives Flank::displace(const double t, const double phi) const
  {
    // X' = X - e N with e(X) = form(L, h) - N . d(X), e > 0 out of the metal and N into it. By t
    // and phi:
    //   e_i = form_L L_i + form_h h_i - N_i . d - N . (w x X_i),   X'_i = X_i - e_i N - e N_i
    SurfaceDerivatives result = surface_.generate(t, phi);
    const Vector3      X = result.point.position, N = result.point.normal;
    const Vector2      L_h   = cone_coordinates(X);
    const Vector2      slope = deviation_->form.slope(L_h);
    const FlankShift  &shift = deviation_->shift;
    const Vector3      d     = shift.at(X);
    const double       e = deviation_->value(result.point, L_h), r = std::hypot(X[0], X[1]);
    const Vector3      X_t = result.position_t, X_phi = result.position_phi;
    const auto         along = [&](const Vector3 &X_i, const Vector3 &N_i) -> Vector3 {
      const double dr  = (X[0] * X_i[0] + X[1] * X_i[1]) / r;
      const double e_i = slope.dot(Vector2(X_i[2] * cos_pitch_ + dr * sin_pitch_,
                                           dr * cos_pitch_ - X_i[2] * sin_pitch_)) -
                         N_i.dot(d) - N.dot(shift.rotation.cross(X_i));
      return X_i - e_i * N - e * N_i;
    };
    result.point.position = X - e * N;
    result.position_t     = along(X_t, result.normal_t);
    result.position_phi   = along(X_phi, result.normal_phi);
    // the normal of the moved surface, on the same side
    const Vector3 across = result.position_t.cross(result.position_phi);
    result.point.normal  = std::copysign(1., across.dot(N)) * across.normalized();
    return result;
  }

  SurfaceDerivatives Flank::derivatives(const double t, const double phi) const
  {
    if (!deviation_)
      return surface_.generate(t, phi);
    // Those of the normal would take second derivatives of the flank, which are not at hand:
    // central differences, exact to 1e-9.
    constexpr double   step   = 1e-5;
    SurfaceDerivatives result = displace(t, phi);
    result.normal_t =
      (displace(t + step, phi).point.normal - displace(t - step, phi).point.normal) / (2. * step);
    result.normal_phi =
      (displace(t, phi + step).point.normal - displace(t, phi - step).point.normal) / (2. * step);
    return result;
  }

  void Flank::refuse(const char        *surface,
                     const double       L,
                     const char        *name,
                     const double       value,
                     const std::string &reason) const
  {
    std::ostringstream message;
    message << "the machine settings generate no "
            << (settings().blade == Blade::outside ? "concave " : "convex ") << surface
            << " at cone distance L = " << L << " mm, " << name << " = " << value << reason;
    throw InputError(message.str());
  }

  Vector2 Flank::start(const double L) const
  {
    // from the cutter's centre S (cos q, sin q) to the point (L, 0) of the pitch generatrix
    const double S = settings().radial_distance, q = settings().cradle_angle;
    return {std::atan2(-S * std::sin(q), L - S * std::cos(q)), 0.};
  }

  bool Flank::is_left(const GeneratedPoint &point) const
  {
    return surface_.clearing(surface_.generate(point.t, point.phi)) > 0.;
  }

  GeneratedPoint Flank::fillet_at(const double L, const double lambda) const
  {
    // Two equations for (t, phi): the edge's point at lambda generates, f = 0, and stands at L.
    const auto equations = [&](const Vector2 &x, Vector2 &residual, Eigen::Matrix2d &jacobian) {
      const GeneratedSurface::EdgePoint point = surface_.edge_point(x[0], x[1], lambda);
      const Vector3                    &X     = point.position.value;
      const double                      r     = std::hypot(X[0], X[1]);
      const auto                        dL    = [&](const Vector3 &dX) {
        return dX[2] * cos_pitch_ + (X[0] * dX[0] + X[1] * dX[1]) / r * sin_pitch_;
      };
      residual = Vector2(point.meshing.value, X[2] * cos_pitch_ + r * sin_pitch_ - L);
      jacobian << point.meshing.t, point.meshing.phi, dL(point.position.t), dL(point.position.phi);
    };
    Vector2 x = start(L);
    if (!solve_newton<2>(equations, x))
      refuse("fillet", L, "blade edge angle lambda [rad]", lambda);

    const GeneratedSurface::EdgePoint point = surface_.edge_point(x[0], x[1], lambda);
    GeneratedPoint                    result;
    result.position = point.position.value;
    result.normal   = point.normal.value;
    result.t        = x[0];
    result.phi      = x[1];
    result.s        = lambda;
    return result;
  }

  GeneratedPoint Flank::point_at(const double L, const double h) const
  {
    // Two equations for (t, phi): the cone coordinates of the flank's point are (L, h). With
    // r = |(X, Y)|,  dr = (X dX + Y dY) / r:
    //   dL = dZ cos d + dr sin d,   dh = dr cos d - dZ sin d
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
    // A point that another position of the cutter takes away is none of the tooth's.
    SurfaceDerivatives found;
    const auto         is_found = [&](Vector2 &x) {
      if (!solve_newton<2>(equations, x))
        return false;
      found = surface_.generate(x[0], x[1]);
      return surface_.clearing(found) > 0.;
    };
    Vector2 x = start(L);
    if (!is_found(x))
      {
        // Then from where the blade cuts last.
        const CutterPassages         passages(settings(),
                                      {L * sin_pitch_ + h * cos_pitch_,
                                               L * cos_pitch_ - h * sin_pitch_});
        const std::optional<Vector2> last = passages.find_last();
        if (last)
          x = *last;
        if (!last || !is_found(x))
          refuse("flank",
                 L,
                 "height over the pitch cone h [mm]",
                 h,
                 passages.reach_root_plane() ? ": the tooth is undercut there"
                                             : ": the cutter does not reach this point");
      }
    return deviation_ ? evaluate(x[0], x[1]) : found.point;
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
    const Vector3 radial = Vector3(point.position[0], point.position[1], 0.).normalized();
    const Vector3 tangential(-radial[1], radial[0], 0.);
    const Vector3 generatrix = sin_pitch_ * radial + cos_pitch_ * Vector3::UnitZ();
    return std::atan2(std::abs(point.normal.dot(generatrix)),
                      std::abs(point.normal.dot(tangential)));
  }

  double Flank::straight_start() const
  {
    return settings().edge_width();
  }
} // namespace vfife
