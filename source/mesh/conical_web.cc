// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/mesh/conical_web.h>

#include <cmath>

namespace vfife
{
  namespace
  {
    /** Inward direction of the mid-surface's generatrix, (r, z). */
    Vector2 web_direction_of(const GearBodyOptions &options)
    {
      const double sign = options.web_direction == WebDirection::back ? 1. : -1.;
      return {-std::sin(options.web_angle), sign * std::cos(options.web_angle)};
    }
  } // namespace

  double ConicalWeb::turn_from_toe(const Blank &blank, const GearBodyOptions &options)
  {
    // The toe face's outward normal is -L, the underside lies at -h.
    const Vector2 L_h = blank.cone_coordinates(web_direction_of(options));
    return std::atan2(-L_h[1], -L_h[0]);
  }

  ConicalWeb::ConicalWeb(const Blank           &blank,
                         const GearBodyOptions &options,
                         const double           root_height)
    : direction_(web_direction_of(options))
    , slope_(std::tan(.5 * turn_from_toe(blank, options)))
    , middle_depth_(.5 * options.rim_thickness)
    , hub_radius_(options.hub_radius)
  {
    const Vector2 root = blank.meridian_point({blank.inner_cone_distance(), root_height});
    mitre_             = blank.meridian_point({slope_, -1.});
    centre_            = root + middle_depth_ * mitre_;
    normal_            = Vector2(-direction_[1], direction_[0]);
    if (normal_.dot(mitre_) < 0.)
      normal_ = -normal_;
  }

  double ConicalWeb::mitre_slope() const
  {
    return slope_;
  }

  double ConicalWeb::depth(const double n) const
  {
    return middle_depth_ + n / mitre_.dot(normal_);
  }

  double ConicalWeb::start(const double n) const
  {
    return n * mitre_.dot(direction_) / mitre_.dot(normal_);
  }

  double ConicalWeb::end(const double n) const
  {
    return (hub_radius_ - centre_[0] - n * normal_[0]) / direction_[0];
  }

  Vector2 ConicalWeb::point(const double u, const double n) const
  {
    return centre_ + n * normal_ + ((1. - u) * start(n) + u * end(n)) * direction_;
  }

  double ConicalWeb::length() const
  {
    return end(0.);
  }
} // namespace vfife
