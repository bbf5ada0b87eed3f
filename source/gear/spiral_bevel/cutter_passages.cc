// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/gear/spiral_bevel/cutter_passages.h>

#include <cmath>

namespace vfife
{
  CutterPassages::CutterPassages(const MachineSettings &settings, const Vector2 &r_z)
    : settings_(settings)
    , r_z_(r_z)
    , sin_blade_(std::sin(settings.blade_angle))
    , cos_blade_(std::cos(settings.blade_angle))
    , sin_root_(std::sin(settings.machine_root_angle))
    , cos_root_(std::cos(settings.machine_root_angle))
  {
  }

  CutterPassages::Passage CutterPassages::at(const double theta) const
  {
    // The circle's point in the machine, and the blade's radius at its height over the tip plane.
    const double  sigma = settings_.sigma(), S = settings_.radial_distance;
    const Vector3 axis(cos_root_, 0., -sin_root_);
    const Vector3 arm =
      r_z_[1] * axis + r_z_[0] * (std::cos(theta) * Vector3(sin_root_, 0., cos_root_) -
                                  std::sin(theta) * Vector3::UnitY());
    const Vector3 place  = settings_.apex() + arm;
    const double  radius = settings_.point_radius + sigma * place[2] * sin_blade_ / cos_blade_;
    // The cutter's centre is S away from the machine's and radius away from the point.
    const double distance = std::hypot(place[0], place[1]);
    const double cosine   = (distance * distance + S * S - radius * radius) / (2. * distance * S);
    Passage      result;
    result.exists = radius > 0. && std::abs(cosine) < 1.;
    if (!result.exists)
      return result;
    const double turned =
      polar_angle(place) + std::copysign(std::acos(cosine), settings_.cradle_angle);
    result.phi = std::remainder(turned - settings_.cradle_angle, 2. * pi);
    result.t   = std::atan2(place[1] - S * std::sin(turned), place[0] - S * std::cos(turned));
    const Vector3 normal(sigma * cos_blade_ * std::cos(result.t),
                         sigma * cos_blade_ * std::sin(result.t),
                         -sin_blade_);
    result.approach =
      normal.dot(Vector3::UnitZ().cross(place) + settings_.roll_rate(result.phi) * axis.cross(arm));
    return result;
  }

  bool CutterPassages::reach_root_plane() const
  {
    return at(0.).exists;
  }

  std::optional<Vector2> CutterPassages::find_last() const
  {
    // Over the places theta of the circle where blades pass, the blade goes first into the
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
      Passage at_low = at(low);
      for (unsigned int i = 0; i < n_halvings; ++i)
        {
          const double  middle    = (low + high) / 2.;
          const Passage at_middle = at(middle);
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
          const Passage a = at(place(k)), b = at(place(k + 1));
          if (is_last(a, b))
            return halved(place(k), place(k + 1));
          // Next to the edge of the sheet both zeros may lie between two places: at the vertex of
          // the parabola through three the approach has the other sign.
          const Passage c     = at(place(k - 1));
          const double  bend  = a.approach - (b.approach + c.approach) / 2.;
          const double  shift = (b.approach - c.approach) / (4. * bend);
          if (!a.exists || !b.exists || !c.exists || !(std::abs(shift) < 1.))
            continue;
          const double  at_vertex = place(k) + shift * largest / n;
          const Passage vertex    = at(at_vertex);
          for (const int side : {-1, 1})
            {
              const Passage &end = side < 0 ? c : b;
              if (is_last(end, vertex))
                return side < 0 ? halved(place(k - 1), at_vertex) : halved(at_vertex, place(k + 1));
            }
        }
    return {};
  }
} // namespace vfife
