// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// The part of Flank that finds its point at given cone coordinates.
#include <vfife/base/errors.h>
#include <vfife/gear/newton.h>
#include <vfife/gear/spiral_bevel/flank.h>

#include <cmath>
#include <sstream>

namespace vfife
{
  /** A position of the cutter whose blade passes a circle about the blank's axis. */
  struct Flank::Passage
  {
    bool   exists = false;
    double t = 0, phi = 0;
    double approach = 0; ///< speed of the blade along its normal, relative to the blank [mm/rad]
  };

  void Flank::refuse(const char        *surface,
                     const double       L,
                     const char        *name,
                     const double       value,
                     const std::string &reason) const
  {
    std::ostringstream message;
    message << "the machine settings generate no "
            << (settings_.blade == Blade::outside ? "concave " : "convex ") << surface
            << " at cone distance L = " << L << " mm, " << name << " = " << value << reason;
    throw InputError(message.str());
  }

  double Flank::clearing(const SurfaceDerivatives &surface) const
  {
    // With the blade's normal n, the angle t and the distance s as coordinates of the blade and its
    // velocity v relative to the blank, tangential where f = n . v = 0, a point of the blank has
    // the distance D from the blade with
    //   D'' = -(f_phi + f_t t' + f_s s'),   v = -(r_t t' + r_s s')
    // The derivatives s_t and s_phi of f(t, s, phi) = 0 make of that, with N . (r_t x r_s) =
    // sigma rho, rho the blade's radius,
    //   D'' = N . (X_t x X_phi) f_s / (sigma rho),   f_s = sigma (z + psi' a) . (T e_t)
    const double t = surface.point.t, phi = surface.point.phi;
    const double radius = settings_.point_radius + settings_.sigma() * surface.point.s * sin_blade_;
    const double ratio  = settings_.roll_rate(phi);
    const Vector3 turning(ratio * cos_root_, 0., 1. - ratio * sin_root_);
    Vector3       across(-std::sin(t), std::cos(t), 0.);
    if (settings_.cutter_tilt != 0.)
      {
        // the direction of the tilt turns with the cradle
        const Vector3 direction =
          rotation_about(Vector3::UnitZ(), phi) * settings_.tilt_direction();
        across = rotation_about(direction, settings_.cutter_tilt) * across;
      }
    return surface.point.normal.dot(surface.position_t.cross(surface.position_phi)) *
           turning.dot(across) / radius;
  }

  bool Flank::is_left(const GeneratedPoint &point) const
  {
    return clearing(generate(point.t, point.phi)) > 0.;
  }

  Vector2 Flank::start(const double L) const
  {
    // from the cutter's centre S (cos q, sin q) to the point (L, 0) of the pitch generatrix
    const double S = settings_.radial_distance, q = settings_.cradle_angle;
    return {std::atan2(-S * std::sin(q), L - S * std::cos(q)), 0.};
  }

  Flank::Passage Flank::passage(const Vector2 &L_h, const double theta) const
  {
    // The circle's point in the machine, and the blade's radius at its height over the tip plane;
    // the tilt is left out.
    const double  r     = L_h[0] * sin_pitch_ + L_h[1] * cos_pitch_;
    const double  z     = L_h[0] * cos_pitch_ - L_h[1] * sin_pitch_;
    const double  sigma = settings_.sigma(), S = settings_.radial_distance;
    const Vector3 axis(cos_root_, 0., -sin_root_);
    const Vector3 arm    = z * axis + r * (std::cos(theta) * Vector3(sin_root_, 0., cos_root_) -
                                        std::sin(theta) * Vector3::UnitY());
    const Vector3 at     = apex_ + arm;
    const double  radius = settings_.point_radius + sigma * at[2] * sin_blade_ / cos_blade_;
    // The cutter's centre is S away from the machine's and radius away from the point.
    const double distance = std::hypot(at[0], at[1]);
    const double cosine   = (distance * distance + S * S - radius * radius) / (2. * distance * S);
    Passage      result;
    result.exists = radius > 0. && std::abs(cosine) < 1.;
    if (!result.exists)
      return result;
    const double turned =
      polar_angle(at) + std::copysign(std::acos(cosine), settings_.cradle_angle);
    result.phi = std::remainder(turned - settings_.cradle_angle, 2. * pi);
    result.t   = std::atan2(at[1] - S * std::sin(turned), at[0] - S * std::cos(turned));
    const Vector3 normal(sigma * cos_blade_ * std::cos(result.t),
                         sigma * cos_blade_ * std::sin(result.t),
                         -sin_blade_);
    result.approach =
      normal.dot(Vector3::UnitZ().cross(at) + settings_.roll_rate(result.phi) * axis.cross(arm));
    return result;
  }

  std::optional<Vector2> Flank::find_last_cut(const Vector2 &L_h) const
  {
    // Over the places theta of the circle (L, h) where blades pass, the blade goes first into the
    // metal and then out of it: there the approach falls through 0 with growing phi. (Where it
    // grows through 0 the blade returns: another sheet of the surface.)
    constexpr double       largest    = 1.2; // [rad], beyond the zone of generation of 5 teeth
    constexpr int          n          = 40;
    constexpr unsigned int n_halvings = 30;
    const auto             is_last    = [](const Passage &a, const Passage &b) {
      return a.exists && b.exists && a.approach * b.approach <= 0. &&
             (b.approach - a.approach) * (b.phi - a.phi) < 0.;
    };
    const auto halved = [&](double low, double high) -> Vector2 {
      Passage at_low = passage(L_h, low);
      for (unsigned int i = 0; i < n_halvings; ++i)
        {
          const double  middle    = (low + high) / 2.;
          const Passage at_middle = passage(L_h, middle);
          if (is_last(at_low, at_middle))
            high = middle;
          else
            {
              low    = middle;
              at_low = at_middle;
            }
        }
      return {at_low.t, at_low.phi};
    };
    const auto place = [&](const int i) { return largest * i / n; };
    // outward from the plane of the axes
    for (int i = 0; i < n; ++i)
      for (const int k : {i, -i - 1})
        {
          const Passage a = passage(L_h, place(k)), b = passage(L_h, place(k + 1));
          if (is_last(a, b))
            return halved(place(k), place(k + 1));
          // Next to the edge of the sheet both zeros may lie between two places: at the vertex of
          // the parabola through three the approach has the other sign.
          const Passage c     = passage(L_h, place(k - 1));
          const double  bend  = a.approach - (b.approach + c.approach) / 2.;
          const double  shift = (b.approach - c.approach) / (4. * bend);
          if (!a.exists || !b.exists || !c.exists || !(std::abs(shift) < 1.))
            continue;
          const double  at_vertex = place(k) + shift * largest / n;
          const Passage vertex    = passage(L_h, at_vertex);
          for (const int side : {-1, 1})
            {
              const Passage &end = side < 0 ? c : b;
              if (is_last(end, vertex))
                return side < 0 ? halved(place(k - 1), at_vertex) : halved(at_vertex, place(k + 1));
            }
        }
    return {};
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
      found = generate(x[0], x[1]);
      return clearing(found) > 0.;
    };
    Vector2 x = start(L);
    if (!is_found(x))
      {
        // Then from where the blade cuts last.
        const std::optional<Vector2> last = find_last_cut(target);
        if (last)
          x = *last;
        if (!last || !is_found(x))
          refuse("flank",
                 L,
                 "height over the pitch cone h [mm]",
                 h,
                 passage(target, 0.).exists ? ": the tooth is undercut there"
                                            : ": the cutter does not reach this point");
      }
    return deviation_ ? evaluate(x[0], x[1]) : found.point;
  }
} // namespace vfife
