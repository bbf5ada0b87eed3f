// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_fem_pair_pressed_state_h
#define vfife_fem_pair_pressed_state_h

#include <vfife/fem/pair/pressed_bodies.h>

namespace vfife
{
  /** Torque on the driven body about its axis [N mm]: torque - stiffness (turn - rest). */
  struct TurnLoad
  {
    double torque    = 0; ///< [N mm]
    double stiffness = 0; ///< [N mm/rad]
    double rest      = 0; ///< [rad]

    double at(const double turn) const
    {
      return torque - stiffness * (turn - rest);
    }
    /** [mJ] */
    double potential(const double turn) const
    {
      return .5 * stiffness * (turn - rest) * (turn - rest) - torque * turn;
    }
  };

  /** Where the Newton method of a PressedPair is: forces taken for those that act, the bodies'
   * answer to them, the turn, and what then acts. */
  struct PressedState
  {
    Eigen::VectorXd force, deflection; ///< at the rows
    double          turn     = 0;      ///< of the driven body beyond its kinematic turn [rad]
    bool            touching = true;   ///< otherwise the turn is given and contact is left out
    /** Forces are compared with at least this [N]; 0: with those of the contact, which then must
     * not be lost. */
    double unit = 0;
    /** Where contact may be lost: iterations after which the best balance will do. */
    unsigned int  patience = 12;
    PressedForces acting;

    double potential(const TurnLoad &load) const;
    /** Forces that the bodies were bent by less those that then act, over the contact's, or what
     * the torque lacks, over the load's. */
    double residual(const TurnLoad &load, double arm) const;
    /** Whether something is pressed, where it has to. */
    bool presses() const;
  };
} // namespace vfife

#endif
