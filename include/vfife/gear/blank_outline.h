// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_gear_blank_outline_h
#define vfife_gear_blank_outline_h

#include <vfife/base/types.h>

namespace vfife
{
  /**
   * Outline of a gear's teeth in the meridian plane, plain data: straight lines of tip and root
   * about the pitch line, between the ends toe and heel normal to it. Points are given by (r, z)
   * (distance from the axis, height along it) or by pitch coordinates (L, h): L along the pitch
   * line from its origin, h over it, > 0 towards the tip.
   *
   * @verbatim
   *   r ^             _.\  heel
   *     |    tip   _-'   \_.
   *     |       _-'   _.-'\     L along the pitch line, h normal to it;
   *     |  toe \   _.-'   _\    d, the pitch angle, is that of the pitch line to the axis
   *     |       \.-'  _.-'
   *     |   _.-' \_.-'  root
   *     |_.-'
   *   O +-----------------------> z
   * @endverbatim
   *
   * Bevel gear: the origin O of the pitch line is the apex, L the cone distance. Cylindrical gear:
   * d = 0, the origin is (pitch radius, 0), L is z. Hypoid gear: the origin is its own pitch apex.
   * The words are those of bevel gears, of which a cylindrical gear is the limit.
   */
  struct BlankOutline
  {
    unsigned int teeth               = 0;
    Vector2      origin              = Vector2::Zero(); ///< (r, z) of L = 0 [mm]
    double       pitch_angle         = 0;               ///< [rad]
    double       face_angle          = 0;               ///< of the tip line to the axis [rad]
    double       root_angle          = 0;               ///< of the root line to the axis [rad]
    double       mean_cone_distance  = 0;               ///< L of the middle of the teeth [mm]
    double       outer_cone_distance = 0;               ///< L of the heel [mm]
    double       face_width          = 0;               ///< along the pitch line [mm]
    double       mean_addendum       = 0;               ///< at the mean cone distance [mm]
    double       mean_dedendum       = 0;               ///< at the mean cone distance [mm]
    double       tip_chamfer         = 0;               ///< legs c of the tips' chamfers [mm]

    /** L of the toe [mm]. */
    double inner_cone_distance() const
    {
      return outer_cone_distance - face_width;
    }
    /** Height a(L) of the tip over the pitch line [mm]. */
    double addendum(double cone_distance) const;
    /**
     * Height over the pitch line at which flanks end [mm]: a(L) - c. From there, in the section, a
     * flat chamfer leads to the top land at a(L). Its legs start at the edge that flank and top
     * land have without it: c in height, and the arc c along the top land.
     */
    double flank_tip(double cone_distance) const;
    /** Depth b(L) > 0 of the root under the pitch line [mm]. */
    double dedendum(double cone_distance) const;

    /** Angle between teeth, 2 pi / z [rad]. */
    double pitch() const;
    /** Arc between teeth on the pitch circle at L [mm]. */
    double circular_pitch(double cone_distance) const;
    /** Transverse module in the middle: diameter of the pitch circle over the number of teeth [mm].
     */
    double mean_module() const;
    /** The same at the heel. */
    double outer_module() const;

    /** (L, h) of a point of the meridian plane (r, z). */
    Vector2 cone_coordinates(const Vector2 &r_z) const;
    /** (L, h) of a position in the body frame. */
    Vector2 coordinates_of(const Vector3 &position) const;
    /** (r, z) of a point (L, h). */
    Vector2 meridian_point(const Vector2 &L_h) const;

    /** The same for directions: change of (L, h) with a change of (r, z), and the reverse. */
    Vector2 cone_direction(const Vector2 &dr_dz) const;
    Vector2 meridian_direction(const Vector2 &dL_dh) const;
  };
} // namespace vfife

#endif
