// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/mesh/gear/conical_web.h>

#include <algorithm>
#include <cmath>

namespace vfife
{
  namespace
  {
    /** Inward direction of the mid-surface's generatrix, (r, z). */
    Vector2 web_direction_of(const WebShape &shape)
    {
      const double sign = shape.web_direction == WebDirection::back ? 1. : -1.;
      return {-std::sin(shape.web_angle), sign * std::cos(shape.web_angle)};
    }
  } // namespace

  bool MeridianArc::contains(const Vector3 &x) const
  {
    constexpr double tolerance = 1e-6; ///< over the radius
    const Vector2    r_z(std::hypot(x[0], x[1]), x[2]);
    return radius > 0. && std::abs((r_z - centre).norm() - radius) < tolerance * radius;
  }

  // Where wall and web meet at the angle a, the arc touches both at R / tan(a / 2) from their
  // corner; its centre lies on the bisector, R / sin(a / 2) from it.
  double ConicalWeb::Fillet::tangent() const
  {
    const double angle = std::acos(std::max(-1., std::min(1., along_wall.dot(along_web))));
    return radius / std::tan(angle / 2.);
  }

  double ConicalWeb::Fillet::half_angle() const
  {
    return std::acos((along_wall + along_web).normalized().dot(along_wall));
  }

  MeridianArc ConicalWeb::Fillet::arc() const
  {
    return {corner + radius / std::sin(half_angle()) * (along_wall + along_web).normalized(),
            radius};
  }

  Vector2 ConicalWeb::Fillet::point(const double part) const
  {
    if (radius == 0.)
      return corner;
    const Vector2 on_wall = corner + tangent() * along_wall,
                  on_web = corner + tangent() * along_web, centre = arc().centre;
    // between the radii to both ends, which are pi - 2 half apart
    const double whole = pi - 2. * half_angle();
    return centre + (std::sin((1. - part) * whole) * (on_wall - centre) +
                     std::sin(part * whole) * (on_web - centre)) /
                      std::sin(whole);
  }

  double ConicalWeb::turn_from_wall(const BlankOutline &blank, const WebShape &shape)
  {
    // The toe face's outward normal is -L, that of the underside nearly -h.
    const Vector2 L_h = blank.cone_direction(web_direction_of(shape));
    return shape.web_attachment == WebAttachment::toe ? std::atan2(-L_h[1], -L_h[0])
                                                      : std::atan2(L_h[0], -L_h[1]);
  }

  bool ConicalWeb::leaves_wall(const BlankOutline &blank, const WebShape &shape)
  {
    // An angle just at the limit may miss it by round-off.
    return std::abs(turn_from_wall(blank, shape)) <= 75. * degree + 1e-9;
  }

  ConicalWeb::ConicalWeb(const BlankOutline &blank, const WebShape &shape)
    : ConicalWeb(blank,
                 shape,
                 -blank.dedendum(blank.inner_cone_distance()),
                 -blank.dedendum(blank.outer_cone_distance))
  {
  }

  ConicalWeb::ConicalWeb(const BlankOutline &blank,
                         const WebShape     &shape,
                         const double        toe_root_height,
                         const double        heel_root_height)
    : direction_(web_direction_of(shape))
    , normal_(-direction_[1], direction_[0])
    , hub_radius_(shape.hub_radius)
  {
    // 1. The wall: at the toe the mitre, which halves the turn from the toe's end to the web;
    // otherwise the underside of the rim, a line at the rim's thickness under the roots.
    const double inner = blank.inner_cone_distance(), outer = blank.outer_cone_distance;
    const bool   at_toe = shape.web_attachment == WebAttachment::toe;
    if (at_toe)
      {
        // halving the turn: the place counts depth along -h, and L grows by tan(turn / 2) with it
        slope_  = std::tan(.5 * turn_from_wall(blank, shape));
        origin_ = blank.meridian_point({inner, toe_root_height});
        wall_   = blank.meridian_direction({slope_, -1.});
      }
    else
      {
        const double rise = (heel_root_height - toe_root_height) / (outer - inner);
        // the place counts L; the line rises as the roots do
        wall_   = blank.meridian_direction({1., rise});
        origin_ = blank.meridian_point({0., toe_root_height - shape.rim_thickness - rise * inner});
      }
    if (normal_.dot(wall_) < 0.)
      normal_ = -normal_;

    // 2. Shape of both ends about the mid-surface's foot, which is not placed yet.
    centre_ = Vector2::Zero();
    for (const unsigned int face : {0, 1})
      {
        const double sign = face == 0 ? -1. : 1., n = sign * shape.web_thickness / 2;
        const double foot  = n / wall_.dot(normal_);
        rim_fillets_[face] = {foot * wall_,
                              sign * wall_.normalized(),
                              direction_,
                              shape.rim_fillet_radius};
        wall_places_[face] = foot + sign * rim_fillets_[face].tangent() / wall_.norm();
      }
    // 3. The foot: in the middle of the rim's depth, of the underside, or at the heel's end.
    const double middle = shape.web_attachment == WebAttachment::toe ? .5 * shape.rim_thickness
                          : shape.web_attachment == WebAttachment::middle
                            ? .5 * (inner + outer) - .5 * (wall_places_[0] + wall_places_[1])
                            : outer - wall_places_[1];
    centre_             = wall_point(middle);
    for (const unsigned int face : {0, 1})
      {
        const double sign = face == 0 ? -1. : 1., n = sign * shape.web_thickness / 2;
        rim_fillets_[face].corner += centre_;
        wall_places_[face] += middle;
        hub_fillets_[face] = {centre_ + n * normal_ + end(n) * direction_,
                              {0., sign},
                              -direction_,
                              shape.hub_fillet_radius};
      }
  }

  double ConicalWeb::mitre_slope() const
  {
    return slope_;
  }

  double ConicalWeb::wall_place(const double x) const
  {
    return (1. - x) * wall_places_[0] + x * wall_places_[1];
  }

  Vector2 ConicalWeb::wall_point(const double place) const
  {
    return origin_ + place * wall_;
  }

  double ConicalWeb::end(const double n) const
  {
    return (hub_radius_ - centre_[0] - n * normal_[0]) / direction_[0];
  }

  double ConicalWeb::straight_start() const
  {
    return .5 * (rim_fillets_[0].tangent() + rim_fillets_[1].tangent()) / length();
  }

  double ConicalWeb::straight_end() const
  {
    return 1. - .5 * (hub_fillets_[0].tangent() + hub_fillets_[1].tangent()) / length();
  }

  Vector2 ConicalWeb::face_point(const Fillet &at_rim, const Fillet &at_hub, const double u) const
  {
    // arc, straight part, arc
    const double start = straight_start(), stop = straight_end();
    if (u < start)
      return at_rim.point(u / start);
    if (u > stop)
      return at_hub.point((1. - u) / (1. - stop));
    const double part = (u - start) / (stop - start);
    return (1. - part) * at_rim.point(1.) + part * at_hub.point(1.);
  }

  Vector2 ConicalWeb::point(const double u, const double x) const
  {
    return (1. - x) * face_point(rim_fillets_[0], hub_fillets_[0], u) +
           x * face_point(rim_fillets_[1], hub_fillets_[1], u);
  }

  double ConicalWeb::length() const
  {
    return end(0.);
  }

  double ConicalWeb::foot_on_hub() const
  {
    return point(1., 1.)[1] - point(1., 0.)[1];
  }
} // namespace vfife
