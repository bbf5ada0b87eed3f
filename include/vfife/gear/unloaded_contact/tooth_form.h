// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_gear_unloaded_contact_tooth_form_h
#define vfife_gear_unloaded_contact_tooth_form_h

#include <vfife/base/text/table.h>
#include <vfife/gear/findings.h>
#include <vfife/gear/spiral_bevel/gear_pair.h>

#include <array>
#include <string>

namespace vfife
{
  /** The tooth of a member at one cone distance. */
  struct ToothSection
  {
    std::string place;               ///< "toe", "middle", "heel"
    double      cone_distance   = 0; ///< [mm]
    double      thickness       = 0; ///< transverse, on the pitch cone [mm]
    double      tip_land        = 0; ///< normal to the flanks [mm]
    double      root_clearance  = 0; ///< of the mating tip over the slot's bottom as cut [mm]
    double      fillet_distance = 0; ///< from the fillet's end up to where the mating tip touches
                                     ///< (gear: up from the mating tip) [mm]
    double regularity = 0; ///< of the flank at the fillet's end over that at the tip; undercut
                           ///< where it is not positive [-]
  };

  /** Three sections of each member; what cannot be cut or run is added to the findings. */
  struct ToothForms
  {
    std::array<ToothSection, 3> pinion, gear;
    double   play     = 0; ///< of the gear at the mean point; NaN where edges end it [rad]
    double   backlash = 0; ///< the same normal to the flanks [mm]
    Findings findings;     ///< without section "Gear pair" in front
  };

  /** NumericalError when the flanks touch nowhere at the reference rotation. */
  ToothForms measure_tooth_forms(const GearPair &pair);

  /** Where a point of the gear flank would touch a flank conjugate to it, and how far the pinion is
   * away. */
  struct EaseOffPoint
  {
    double  pitches = 0;     ///< pinion rotation from the mean contact, in pitches
    Vector2 pinion_L_h;      ///< cone coordinates on the pinion [mm]
    double  ease_off = 0;    ///< gap along the normal [mm], to first order of the normals' angle
    bool    exists   = true; ///< false where the gear point never satisfies the equation of meshing
  };

  /** Ease-off at a point (L, h) of the gear flank of a side. */
  EaseOffPoint measure_ease_off(const GearPair &pair, MeshSide side, const Vector2 &gear_L_h);

  /** Maps of both sides over the gear flank between fillet and tip: ease_off.csv. */
  Table ease_off_table(const GearPair &pair);
} // namespace vfife

#endif
