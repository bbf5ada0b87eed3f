// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_gear_errors_flank_deviation_h
#define vfife_gear_errors_flank_deviation_h

#include <vfife/gear/errors/bicubic_grid.h>
#include <vfife/gear/errors/flank_area.h>

#include <optional>

namespace vfife
{
  /**
   * Modifications of a whole flank by five numbers [mm], with s = 2 u - 1 from toe to heel and t =
   * 2 v - 1 from root to tip on its whole area (FlankArea without margins); > 0 is metal:
   *   pressure_angle t/2 + spiral_angle s/2 - profile_crowning t^2 - lengthwise_crowning s^2
   *   + bias s t/4
   */
  struct EaseOffTerms
  {
    double pressure_angle      = 0.; ///< tip over root: profile slope over the height of the flank
    double spiral_angle        = 0.; ///< heel over toe: slope over the face width
    double profile_crowning    = 0.; ///< relief of tip and root against the middle
    double lengthwise_crowning = 0.; ///< relief of toe and heel against the middle
    double bias = 0.; ///< spiral_angle at the tip less that at the root: twist of the flank

    double  value(const Vector2 &u_v) const;
    Vector2 gradient(const Vector2 &u_v) const; ///< by u and v
  };

  /** Measured deviations on a grid over an area of the flank [mm], > 0 is metal. */
  struct Topography
  {
    FlankArea   area;
    BicubicGrid grid;
  };

  /** The form of a flank against the generated one: what does not move with the body [mm]. */
  struct FlankForm
  {
    FlankArea                 area; ///< of the terms
    EaseOffTerms              terms;
    std::optional<Topography> topography;

    /** At cone coordinates (L, h), normal to the flank, > 0 is metal. */
    double value(const Vector2 &L_h) const;
    /** Its derivatives by L and h. */
    Vector2 slope(const Vector2 &L_h) const;
  };

  /** Small displacement of a flank as a rigid body: position X moves by translation + rotation x
   * X [mm, rad]. */
  struct FlankShift
  {
    Vector3 translation = Vector3::Zero();
    Vector3 rotation    = Vector3::Zero();

    Vector3 at(const Vector3 &position) const
    {
      return translation + rotation.cross(position);
    }
    /** The same shift seen from axes that are turned by @p angle about z [rad]. */
    FlankShift seen_turned(double angle) const;
  };

  /** How far a flank lies out of the metal from the generated one, along its normal. */
  struct FlankDeviation
  {
    FlankForm  form;
    FlankShift shift;

    /** At a point of the generated flank (normal into the metal) with its cone coordinates [mm]. */
    double value(const SurfacePoint &point, const Vector2 &L_h) const
    {
      return form.value(L_h) - point.normal.dot(shift.at(point.position));
    }
  };
} // namespace vfife

#endif
