// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_gear_blank_h
#define vfife_gear_blank_h

#include <vfife/base/types.h>

#include <string>

namespace dealii
{
  class ParameterHandler;
}

namespace vfife
{
  class Findings;

  enum class Hand
  {
    right,
    left
  };

  /** "right" or "left". */
  const char *name_of(Hand hand);

  /**
   * The turned blank of a bevel gear: cones with a common apex. Points of a meridian plane are
   * given by (r, z) (distance from the axis, height along it from the apex) or by cone coordinates
   * (L, h): L = z cos d + r sin d along the pitch cone from the apex, h = r cos d - z sin d over it
   * (> 0 towards the tip), d the pitch angle.
   */
  struct Blank
  {
    unsigned int teeth               = 0;
    Hand         hand                = Hand::right;
    double       pitch_angle         = 0; ///< [rad]
    double       face_angle          = 0; ///< [rad]
    double       root_angle          = 0; ///< [rad]
    double       mean_cone_distance  = 0; ///< [mm]
    double       outer_cone_distance = 0; ///< [mm]
    double       face_width          = 0; ///< [mm]
    double       mean_addendum       = 0; ///< at the mean cone distance [mm]
    double       mean_dedendum       = 0; ///< at the mean cone distance [mm]
    double       spiral_angle        = 0; ///< mean; 0: not given, the machine settings decide [rad]

    void declare(dealii::ParameterHandler &prm);
    /** Adds what is missing in the blank and where it contradicts itself (@p section: path of its
     * entries). */
    void examine(const std::string &section, Findings &findings) const;

    double inner_cone_distance() const
    {
      return outer_cone_distance - face_width;
    }
    /** Addendum a(L) over the pitch cone [mm]. */
    double addendum(double cone_distance) const;
    /** Dedendum b(L) > 0 under the pitch cone [mm]. */
    double dedendum(double cone_distance) const;

    /** (L, h) of a point of the meridian plane (r, z). */
    Vector2 cone_coordinates(const Vector2 &r_z) const;
    /** (r, z) of cone coordinates (L, h). */
    Vector2 meridian_point(const Vector2 &L_h) const;
  };

  /** Pitch angle by the numbers of teeth: tan d = sin(shaft angle) / (other/own + cos(shaft angle))
   * [rad]. */
  double pitch_angle_of(double own_teeth, double other_teeth, double shaft_angle);

  /**
   * Sum of the dedendum angles with which slots cut by spread blades taper as the teeth do (duplex
   * taper) [rad]:
   *   (pi m / (2 A_m)) (1 - A_m sin b / r) / (tan al cos b),   m the transverse module at A_m
   */
  double duplex_dedendum_angles(const Blank &gear,
                                double       cutter_radius,
                                double       spiral_angle,
                                double       blade_angle);
} // namespace vfife

#endif
