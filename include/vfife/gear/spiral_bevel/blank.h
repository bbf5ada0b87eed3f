// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_gear_spiral_bevel_blank_h
#define vfife_gear_spiral_bevel_blank_h

#include <vfife/base/parameters/parameters.h>
#include <vfife/gear/blank_outline.h>

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

  /** "right", "left". */
  const Choices<Hand> &hand_choices();

  /** "right" or "left". */
  const char *name_of(Hand hand);

  /** The turned blank of a spiral bevel gear: cones with a common apex, the origin of the body
   * frame.
   */
  struct Blank : BlankOutline
  {
    Hand   hand         = Hand::right;
    double spiral_angle = 0; ///< mean; 0: not given, the machine settings decide [rad]

    void declare(dealii::ParameterHandler &prm);
    /** Adds what is missing in the blank and where it contradicts itself (@p section: path of its
     * entries). */
    void examine(const std::string &section, Findings &findings) const;
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
