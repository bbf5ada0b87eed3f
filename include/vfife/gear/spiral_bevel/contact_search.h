// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_gear_spiral_bevel_contact_search_h
#define vfife_gear_spiral_bevel_contact_search_h

#include <vfife/gear/spiral_bevel/flank_contact.h>
#include <vfife/gear/spiral_bevel/gear_pair_options.h>

#include <optional>

namespace vfife
{
  /** Where two flanks touch at the ratio of the teeth, mounted without errors. */
  struct ContactSearchResult
  {
    FlankContact           contact; ///< the equations of the two flanks
    FlankContact::Unknowns unknowns;
    double                 ratio_of_roll = 0; ///< of the pinion flank
  };

  /**
   * Finds the contact of a pinion flank of @p settings and @p gear_flank for completed options.
   * Without a ratio of roll of the pinion flank it is found too. With one there may be several
   * contacts: the result is the one for which local synthesis made the settings, or the one nearest
   * to the middle of the teeth, on the teeth if one is there. None where the flanks touch nowhere.
   * Throws InputError where they do not reach the middle of the teeth.
   */
  std::optional<ContactSearchResult> search_contact(const MachineSettings &settings,
                                                    const GearPairOptions &options,
                                                    const Flank           &gear_flank);

  /** Whether cone coordinates (L, h) are between toe and heel, root and tip. */
  bool is_on_tooth(const Blank &blank, const Vector2 &L_h);
} // namespace vfife

#endif
