// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// The part of Flank that moves the generated surface by errors of manufacture.
#include <vfife/gear/spiral_bevel/flank.h>

#include <cmath>

namespace vfife
{
  Flank Flank::with_deviation(const FlankDeviation &deviation) const
  {
    Flank flank      = *this;
    flank.deviation_ = deviation;
    return flank;
  }

  GeneratedPoint Flank::evaluate(const double t, const double phi) const
  {
    return deviation_ ? displace(t, phi).point : generate(t, phi).point;
  }

  SurfaceDerivatives Flank::displace(const double t, const double phi) const
  {
    // X' = X - e N with e(X) = form(L, h) - N . d(X), e > 0 out of the metal and N into it. By t
    // and phi:
    //   e_i = form_L L_i + form_h h_i - N_i . d - N . (w x X_i),   X'_i = X_i - e_i N - e N_i
    SurfaceDerivatives result = generate(t, phi);
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
      return generate(t, phi);
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
} // namespace vfife
