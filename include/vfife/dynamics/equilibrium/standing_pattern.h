// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_dynamics_equilibrium_standing_pattern_h
#define vfife_dynamics_equilibrium_standing_pattern_h

#include <vfife/base/process/communicator.h>
#include <vfife/model/model.h>
#include <vfife/model/state.h>

#include <vector>

namespace vfife
{
  /**
   * The motion of turning bodies whose deformation stands still in space, as that of a gear under a
   * tooth load which does not turn with it (doc/theory/equilibrium.md, Standing pattern).
   *
   * A body of n equal sectors takes the same shape again whenever it has turned by one of them, up
   * to which teeth touch. So the change of displacement along the circumference, between one
   * sector and the next, is that of a node in time. With u(phi), in axes that turn with the body,
   * and its rate Omega, nodes move at Omega u' relative to the turning body, and have the relative
   * and Coriolis accelerations Omega^2 u'' and 2 Omega^2 e x u'. Derivatives by central differences
   * of fourth order over the sectors. Bodies with one sector have no pattern.
   */
  class StandingPattern
  {
  public:
    StandingPattern(const Model &model, const Communicator &communicator);

    /** Takes the pattern from the positions of @p state at time zero. Collective. */
    void update(const State &state);

    /** Body @p b also turns about its axis beyond its rate, at @p rate [rad/s], and the moment @p
     * torque accelerates it so [N mm]: as a rigid body. Until the next update(). */
    void add_turn(const State &state, unsigned int b, double rate, double torque);

    /** Adds the force of inertia -m Omega^2 (u'' + 2 e x u') to @p forces [N]. */
    void add_forces(const std::vector<double> &masses, NodeField &forces) const;

    /** Adds Omega u' to @p velocities [mm/s]. */
    void add_velocities(NodeField &velocities) const;

  private:
    struct Node
    {
      std::uint32_t local;
      Vector3       velocity, acceleration; ///< relative to the turning body, Coriolis included
    };

    const Model        &model_;
    const Communicator &communicator_;
    std::vector<Node>   nodes_;
  };
} // namespace vfife

#endif
