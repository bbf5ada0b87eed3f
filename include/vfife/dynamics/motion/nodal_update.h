// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_dynamics_motion_nodal_update_h
#define vfife_dynamics_motion_nodal_update_h

#include <vfife/dynamics/motion/update_kernels.h>
#include <vfife/dynamics/rigid_velocity.h>
#include <vfife/dynamics/update_sums.h>

#include <cstddef>

namespace vfife
{
  /** Damping of one body in one step: F = -zeta m (v - u(x)) - m slip(x). */
  struct BodyDamping
  {
    double        zeta = 0; ///< [1/s]
    RigidVelocity rigid;    ///< the motion that is not damped
    RigidVelocity
      mesh; ///< zeta_k (u_body - u_kinematic): zero where there is no driven speed damping [mm/s^2]
  };

  /**
   * Sums over nodes of a body at an instant: x, the velocities v_- half a step before it and v_+
   * half a step after.
   */
  struct NodalMotion
  {
    Vector3 momentum         = Vector3::Zero(); ///< sum m v_- [N s]
    Vector3 angular_momentum = Vector3::Zero(); ///< sum m x x v_-, about the fixed origin [N mm s]
    double  speed            = 0;               ///< sum m |v_-|/r, r from the axis [t rad/s]
    double  turning_mass     = 0;               ///< sum m of the nodes off the axis [t]
    double  mass             = 0;               ///< sum m [t]
    Vector3 change           = Vector3::Zero(); ///< sum m (v_+ - v_-) [N s]
    double  square_of_change = 0;               ///< sum m |v_+ - v_-|^2 [mJ]

    /** One more node, and the line about which its body turns. */
    void add(const UpdateAxis &axis,
             double            node_mass,
             const Vector3    &x,
             const Vector3    &v,
             const Vector3    &next);
  };

  /**
   * Central differences for nodes [first, last):
   *   v_+ = ((1 - a) v_- + dt (f/m - slip) + 2 a u)/(1 + a),  a = zeta dt/2,  x += dt v_+,
   * which centres the damping force at the old time. Mass and inverse mass of constrained nodes are
   * zero in the records, so that they add nothing; whoever constrains them sets them afterwards.
   * Instruction sets differ by round-off. @p motion, unless it is nullptr, gets the sums of the
   * nodes that count added: each node is at hand here.
   */
  UpdateSums update_nodes(std::size_t        first,
                          std::size_t        last,
                          double             dt,
                          const BodyDamping &damping,
                          const UpdateAxis  &axis,
                          const NodeRecords &records,
                          NodalMotion       *motion          = nullptr,
                          InstructionSet     instruction_set = best_instruction_set());
} // namespace vfife

#endif
