// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/text/column_names.h>
#include <vfife/output/measures/mounting.h>

#include <cmath>

namespace vfife
{
  Mounting Mounting::operator-(const Mounting &other) const
  {
    return {offset - other.offset,
            pinion_shift - other.pinion_shift,
            gear_shift - other.gear_shift,
            shaft_angle - other.shaft_angle};
  }

  std::array<MountingNumber, 4> list_numbers(const Mounting &m)
  {
    return {{{column::offset, "um", 1e3 * m.offset},
             {column::pinion_axial_shift, "um", 1e3 * m.pinion_shift},
             {column::gear_axial_shift, "um", 1e3 * m.gear_shift},
             {column::shaft_angle_error, "arcmin", m.shaft_angle / (60 * arcsecond)}}};
  }

  Mounting find_mounting(const MountedMember &pinion, const MountedMember &gear)
  {
    const Vector3 &p = pinion.direction, &g = gear.direction;
    const Vector3  normal = g.cross(p), between = pinion.apex - gear.apex;
    const double   sine2 = normal.squaredNorm(), cosine = p.dot(g);
    if (!(sine2 > 1e-12))
      throw NumericalError("the axes of the two members are parallel");
    // Feet of the common perpendicular: between + s p - t g is square to p and to g.
    const double s = (cosine * between.dot(g) - between.dot(p)) / sine2;
    const double t = between.dot(g) + s * cosine;
    return {between.dot(normal) / std::sqrt(sine2), -s, -t, std::atan2(std::sqrt(sine2), cosine)};
  }
} // namespace vfife
