// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_gear_spiral_bevel_pair_proposal_h
#define vfife_gear_spiral_bevel_pair_proposal_h

#include <vfife/base/parameter_handler.h>
#include <vfife/base/types.h>
#include <vfife/gear/spiral_bevel/gear_member_options.h>

#include <string>

namespace vfife
{
  /**
   * Basic data from which blanks and machine settings are proposed: a spread-blade gear with duplex
   * taper, and pinion flanks by local synthesis (method: Litvin & Fuentes; derivation in
   * doc/theory/gear.md).
   */
  struct PairProposal
  {
    unsigned int pinion_teeth   = 0; ///< 0: nothing is proposed
    unsigned int gear_teeth     = 0;
    Hand         pinion_hand    = Hand::left;
    double       module         = 0;               ///< outer transverse [mm]
    double       face_width     = 0;               ///< 0: 0.3 of the outer cone distance [mm]
    double       spiral_angle   = 35. * pi / 180.; ///< mean [rad]
    double       pressure_angle = 20. * pi / 180.; ///< normal [rad]
    double       cutter_radius  = 0;               ///< 0: 0.82 of the mean cone distance [mm]
    double       lag            = 4. * arcsecond;  ///< of the gear, half a pitch off the mean [rad]
    double       path_angle     = 25. * pi / 180.; ///< on the gear flank, see LengthAndHeight [rad]
    double       ellipse_length = 0.35; ///< major axis over face width at 6.35 um separation [-]

    void declare(dealii::ParameterHandler &prm);

    bool is_given() const
    {
      return pinion_teeth > 0;
    }
  };

  /**
   * Fills in blanks and machine settings of both members for the shaft angle [rad].
   * Throws InputError when the data are incomplete or no settings exist.
   */
  void propose(const PairProposal &proposal,
               double              shaft_angle,
               GearMemberOptions  &pinion,
               GearMemberOptions  &gear);

  /** Throws InputError: no pair is found for these data, and @p reason. */
  [[noreturn]] void
  refuse_proposal(const PairProposal &proposal, double shaft_angle, const std::string &reason);
} // namespace vfife

#endif
