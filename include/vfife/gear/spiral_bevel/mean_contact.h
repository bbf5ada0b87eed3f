// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_gear_spiral_bevel_mean_contact_h
#define vfife_gear_spiral_bevel_mean_contact_h

#include <vfife/gear/driving.h>
#include <vfife/gear/spiral_bevel/flank_contact.h>
#include <vfife/gear/spiral_bevel/gear_pair_options.h>

namespace vfife
{
  /**
   * Where the unloaded flanks touch with the exact speed ratio, members mounted without errors.
   * Points are those of the *generated* flanks, in the body frames (the pinion's lower flank before
   * it is turned by thickness_turn()).
   */
  struct MeanContact
  {
    double         rot1 = 0, rot2 = 0; ///< rotations at which the generated flanks touch [rad]
    GeneratedPoint pinion, gear;
    Vector2        pinion_L_h, gear_L_h; ///< cone coordinates (L, h) [mm]
    Vector3        position, normal;     ///< fixed frame; normal out of the gear, into the pinion
    double         arm           = 0;    ///< |(P x n)_z| about the gear axis [mm]
    double         ratio_of_roll = 0;    ///< of the pinion flank

    /** The contact as solution of the equations of FlankContact. */
    FlankContact::Unknowns unknowns() const;

    /**
     * Lag of the gear against the exact ratio, counted from this contact of @p side, where the
     * generated flanks touch at the rotations @p rotation1 and @p rotation2 [rad].
     */
    double lag(MeshSide side, double speed_ratio, double rotation1, double rotation2) const;
  };

  /**
   * Finds the mean contact of @p pinion_side and @p gear_side, which touch on @p side, for
   * completed options; where these give no ratio of roll of the pinion flank it is the one with
   * which the flanks touch conjugately. Throws InputError where they do not touch, or outside their
   * teeth.
   */
  MeanContact find_mean_contact(const GearPairOptions &options,
                                MeshSide               side,
                                FlankSide              pinion_side,
                                FlankSide              gear_side);
} // namespace vfife

#endif
