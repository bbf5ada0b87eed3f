// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/gear/gear_geometry.h>

#include <cmath>

namespace vfife
{
  FlankSide GearGeometry::upper_side() const
  {
    return opposite(lower_side());
  }

  double GearGeometry::pitch() const
  {
    return blank().pitch();
  }

  bool GearGeometry::has_deviations() const
  {
    return false;
  }

  bool GearGeometry::has_equal_teeth() const
  {
    return true;
  }

  double GearGeometry::deviation(FlankSide, unsigned int, const SurfacePoint &) const
  {
    return 0.;
  }

  double GearGeometry::tooth_thickness(const double L, const double h) const
  {
    const Vector3 lower = flank_point(lower_side(), L, h).position;
    const Vector3 upper = flank_point(upper_side(), L, h).position;
    return std::hypot(lower[0], lower[1]) *
           std::remainder(polar_angle(upper) - polar_angle(lower), 2. * pi);
  }
} // namespace vfife
