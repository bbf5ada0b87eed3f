// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_gear_spiral_bevel_local_contact_h
#define vfife_gear_spiral_bevel_local_contact_h

#include <vfife/base/types.h>
#include <vfife/gear/spiral_bevel/blank.h>

namespace vfife
{
  /** Unit tangents of a flank: along the face to the heel at constant h, and normal to that towards
   * the tip. */
  struct LengthAndHeight
  {
    Vector3 lengthwise, upward;

    /** @p position, @p normal: in the body frame. */
    LengthAndHeight(const Blank &blank, const Vector3 &position, const Vector3 &normal);

    /** Angle of a tangent direction to the lengthwise one, in (-90, 90] deg, > 0 when it rises to
     * the tip at the heel [rad]. */
    double angle(const Vector3 &direction) const;
  };

  /**
   * A gear flank at a point that satisfies the equation of meshing, and the conjugate pinion flank
   * there: line contact (doc/theory/gear.md). Fixed frame; the pinion turns at rate 1.
   */
  struct LineContact
  {
    Vector3 position, normal;      ///< normal out of the gear, into the pinion
    Vector3 sliding;               ///< velocity of the pinion relative to the gear [mm/rad]
    Vector3 across;                ///< unit tangent normal to the line of contact
    double  curvature = 0;         ///< relative, along across [1/mm]
    double  speed     = 0;         ///< of the line along -across on the pinion [mm/rad]
    double  arm       = 0;         ///< of the normal about the gear's axis [mm]
    Matrix3 gear_curvature_tensor; ///< positive bends to the gear's metal

    LineContact(const Vector3 &position,
                const Vector3 &normal,
                const Matrix3 &gear_curvature_tensor,
                const Vector3 &pinion_axis,
                const Vector3 &gear_axis,
                double         speed_ratio);
  };

  /** What is asked of the contact at the mean point. */
  struct LocalContactDesign
  {
    double  lag_curvature = 0;   ///< lag = this/2 (pinion rotation)^2 [1/rad]
    Vector3 path;                ///< direction of the path on the gear flank
    double  small_curvature = 0; ///< smaller relative curvature [1/mm]
  };

  /**
   * Curvature tensor of the pinion flank (positive bends to the pinion's metal) that has the
   * contact asked for. Throws InputError when there is none.
   */
  Matrix3 pinion_curvature_tensor(const LineContact &contact, const LocalContactDesign &design);
} // namespace vfife

#endif
