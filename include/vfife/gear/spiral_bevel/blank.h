// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_gear_spiral_bevel_blank_h
#define vfife_gear_spiral_bevel_blank_h

#include <vfife/base/parameters/parameters.h>
#include <vfife/gear/blank_outline.h>

#include <string>

namespace vfife
{
  class Findings;

  enum class Hand
  {
    automatic, ///< opposite to that of the mating member
    right,
    left
  };

  /** "right", "left". */
  const Choices<Hand> &hand_choices();

  /** "auto", "right" or "left". */
  std::string name_of(Hand hand);

  /** Of right and left. */
  Hand opposite(Hand hand);

  /** The turned blank of a spiral bevel gear: cones with a common apex, the origin of the body
   * frame.
   */
  struct Blank : BlankOutline
  {
    Hand   hand         = Hand::automatic;
    double spiral_angle = 0; ///< mean; 0: not given, the machine settings decide [rad]

    void declare(dealii::ParameterHandler &prm);
    /** Adds what is missing in the blank and where it contradicts itself (@p section: path of its
     * entries). */
    void examine(const std::string &section, Findings &findings) const;
    /** Throws InputError of the entry "tip chamfer" in @p section, that of the member, where the
     * flanks would not rise above the pitch cone. */
    void check_tip_chamfer(const std::string &section) const;
  };

  /** Pitch angle by the numbers of teeth: tan d = sin(shaft angle) / (other/own + cos(shaft angle))
   * [rad]. */
  double pitch_angle_of(double own_teeth, double other_teeth, double shaft_angle);

  /**
   * Ratio of the pair at 90 deg whose teeth are like those of the pair at @p shaft_angle: square
   * root of that of the virtual numbers of teeth, z / cos d. It grows without bound as the gear
   * becomes a crown gear; not a number beyond (pitch angle of 90 deg or more).
   */
  double equivalent_ratio(double pinion_teeth, double gear_teeth, double shaft_angle);

  /**
   * Why numbers of teeth and shaft angle do not go together: the gear would be a crown gear or an
   * internal one, or the ratio is larger than bevel gears have. Empty where they do. @p entry
   * becomes the name of the entry to change, within the section of the pair.
   */
  std::string find_ratio_fault(unsigned int pinion_teeth,
                               unsigned int gear_teeth,
                               double       shaft_angle,
                               std::string &entry);

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
