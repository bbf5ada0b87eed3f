// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_fem_pair_pressed_bodies_h
#define vfife_fem_pair_pressed_bodies_h

#include <vfife/base/types.h>

#include <exception>
#include <vector>

namespace vfife
{
  /** What acts on a pressed pair at a trial state. */
  struct PressedForces
  {
    Eigen::VectorXd force;              ///< at the rows [N]
    double          contact_force  = 0; ///< norm of the contact's [N]
    double          contact_energy = 0; ///< [mJ]
    double contact_torque = 0; ///< of the contact, on the driven body about its axis [N mm]
    double driver_torque  = 0; ///< of the contact, on the driver about its axis [N mm]
    double energy         = 0; ///< of all that acts [mJ]
    double torque         = 0; ///< of all on the driven body [N mm]
  };

  /** Springs, beyond those of the contact, at the rows behind the nodes'. */
  struct PressedSprings
  {
    Eigen::MatrixXd stiffness;      ///< beyond that of the bodies' answers [N/mm]
    Eigen::VectorXd by_turn;        ///< change of minus their forces with the turn [N]
    double          turn_twice = 0; ///< change of minus their torque with the turn [N mm]
  };

  /**
   * What elastic bodies do at the rows of a PressedPair, three for each of its nodes and others
   * behind them, and what acts at those others.
   */
  class PressedBodies
  {
  public:
    virtual ~PressedBodies() = default;

    /** Displacements at all rows under forces at them. */
    virtual Eigen::VectorXd answer(const Eigen::VectorXd &force) = 0;
    /** Displacements at the @p rows under unit forces there, a column each. */
    virtual Eigen::MatrixXd flexibility(const std::vector<unsigned int> &rows) = 0;
    /** Adds what acts at the rows behind the nodes'. */
    virtual void add_forces(const Eigen::VectorXd &u, PressedForces &sum) const = 0;
    /** Their springs; @p turning: also with the turn of the driven body; without @p own, those that
     * the bodies' answers have. */
    virtual PressedSprings find_springs(const Eigen::VectorXd &u, bool turning, bool own) const = 0;
  };

  /** A contact acts on a node that has no rows. */
  class StrayContact : public std::exception
  {
  };
} // namespace vfife

#endif
