// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_gear_spiral_bevel_gear_pair_options_h
#define vfife_gear_spiral_bevel_gear_pair_options_h

#include <vfife/gear/errors/member_error_options.h>
#include <vfife/gear/findings.h>
#include <vfife/gear/spiral_bevel/gear_member_options.h>
#include <vfife/gear/spiral_bevel/pair_proposal.h>

#include <string>

namespace vfife
{
  /** What the user gives of a pair: content of "Gear pair" without the bodies and meshes. */
  struct GearPairOptions
  {
    PairProposal      proposal; ///< where given, blanks and settings follow from it
    GearMemberOptions pinion, gear;
    double            shaft_angle = pi / 2; ///< [rad]
    double            backlash    = 0.12;   ///< normal to the flanks at the mean point [mm]

    /** Mounting errors: they move the members after the pair has been designed without them. */
    double pinion_axial_shift = 0; ///< > 0 away from the apex [mm]
    double gear_axial_shift   = 0; ///< > 0 away from the apex [mm]
    double offset             = 0; ///< of the pinion axis along +y of the fixed frame [mm]
    double shaft_angle_error  = 0; ///< > 0 opens the shaft angle [rad]

    /** Errors of manufacture: they move the flanks of the designed teeth. */
    MemberErrorOptions pinion_errors, gear_errors;

    /** Declares Pinion and Gear {Blank, Concave flank, Convex flank}, Mounting and Errors in the
     * present section. */
    void declare(dealii::ParameterHandler &prm);

    /** With what follows from the rest: pitch angles, one point radius of a spread-blade gear, its
     * ratio of roll. */
    GearPairOptions completed() const;

    /** What is missing, impossible or contradictory, after completing; all of it, causes first. */
    Findings examine(const std::string &section = "Gear pair") const;

    /** Throws InputError for all findings that stop the program, for tip chamfers as high as the
     * addendum, and for errors of manufacture that cannot be read. */
    void check(const std::string &section = "Gear pair") const;
  };
} // namespace vfife

#endif
