// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_gear_errors_flank_area_h
#define vfife_gear_errors_flank_area_h

#include <vfife/base/parameter_handler.h>
#include <vfife/gear/gear_geometry.h>

namespace vfife
{
  /** What a grid of points leaves free of a flank. */
  struct FlankMargins
  {
    double lengthwise = 0.; ///< from toe and heel, part of the face width
    double profile    = 0.; ///< from tip and start of the flank, part of its height

    void declare(dealii::ParameterHandler &prm);
  };

  /**
   * The part of a flank that measurements and modifications refer to: in the meridian plane a
   * quadrilateral with two ends L = const, and straight lines from the toe to the heel end near
   * the start of the flank and near its tip. Coordinates on it: u from 0 at the toe end to 1 at the
   * heel end, v from 0 at the root line to 1 at the tip line.
   */
  class FlankArea
  {
  public:
    /** A unit interval on both axes: for values that are nowhere else. */
    FlankArea() = default;

    /**
     * The flank between toe and heel, from its start at the fillet to the tip, less margins.
     */
    FlankArea(const GearGeometry &gear, FlankSide side, const FlankMargins &margins = {});

    /** (u, v) of cone coordinates (L, h). */
    Vector2 place_of(const Vector2 &L_h) const;
    /** (L, h) of (u, v) [mm]. */
    Vector2 point_at(const Vector2 &u_v) const;
    /** Derivatives by (L, h) of a function whose derivatives by (u, v) at @p u_v are @p slope. */
    Vector2 slope_of(const Vector2 &u_v, const Vector2 &slope) const;

  private:
    double  toe_ = 0., length_ = 1.;
    Vector2 low_ = Vector2::Zero(), high_ = Vector2::Ones(); ///< heights at toe and heel end [mm]
  };
} // namespace vfife

#endif
