// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_dynamics_motion_nodal_update_h
#define vfife_dynamics_motion_nodal_update_h

#include <vfife/base/types.h>
#include <vfife/element/kernels/kernels.h>

#include <cstddef>
#include <vector>

namespace vfife
{
  class Communicator;

  /** Velocity field of a rigid motion, u(x) = velocity + omega x x (x from the fixed frame's
   * origin). */
  struct RigidVelocity
  {
    Vector3 velocity = Vector3::Zero(); ///< of the point at the origin [mm/s]
    Vector3 omega    = Vector3::Zero(); ///< [rad/s]

    Vector3 at(const Vector3 &x) const
    {
      return velocity + omega.cross(x);
    }
  };

  /** Damping of one body in one step: F = -zeta m (v - u(x)) - m slip(x). */
  struct BodyDamping
  {
    double        zeta = 0; ///< [1/s]
    RigidVelocity rigid;    ///< the motion that is not damped
    RigidVelocity
      mesh; ///< zeta_k (u_body - u_kinematic): zero where there is no mesh damping [mm/s^2]
  };

  /** Sums over the owned nodes of a body that one update makes, with v = (v_- + v_+)/2 at the old
   * positions. */
  struct UpdateSums
  {
    double kinetic        = 0; ///< sum m v_- . v_+ / 2 [mJ]
    double damping_power  = 0; ///< sum zeta m (v - u) . v, lost [mJ/s]
    double mesh_power     = 0; ///< sum m slip . v, lost [mJ/s]
    double damping_torque = 0; ///< about the axis: sum -zeta m e . (v - u), e = axis x r [N mm]
    /** Of the new state, for the next step's rigid rate. */
    double  axial_momentum   = 0;               ///< sum m e . v_+
    double  axial_inertia    = 0;               ///< sum m e . e
    Vector3 momentum         = Vector3::Zero(); ///< sum m v_+ (bodies without bearings)
    Vector3 first_moment     = Vector3::Zero(); ///< sum m x
    Vector3 angular_momentum = Vector3::Zero(); ///< sum m x x v_+, about the fixed origin
    Matrix3 second_moment    = Matrix3::Zero(); ///< sum m x x^T

    void operator+=(const UpdateSums &other);
  };

  /** The line through `point` in unit `direction`: turning bodies; use_axis false: all moments are
   * summed instead. */
  struct UpdateAxis
  {
    bool    use_axis = false;
    Vector3 point = Vector3::Zero(), direction = Vector3::UnitZ();
  };

  /**
   * Central differences for nodes [first, last):
   *   v_+ = ((1 - a) v_- + dt (f/m - slip) + 2 a u)/(1 + a),  a = zeta dt/2,  x += dt v_+,
   * which centres the damping force at the old time. Records of the NodeFields of a State; mass
   * and inverse mass of constrained nodes are zero there, so that they add nothing; whoever
   * constrains them sets them afterwards.
   * @p owned: 1 where a node counts in the sums. Instruction sets differ by round-off.
   */
  UpdateSums update_nodes(std::size_t          first,
                          std::size_t          last,
                          double               dt,
                          const BodyDamping   &damping,
                          const UpdateAxis    &axis,
                          const unsigned char *owned,
                          const double        *forces,
                          double              *positions,
                          double              *velocities,
                          InstructionSet       instruction_set = best_instruction_set());

  /** Adds the sums of the new state for one more node (constrained ones). */
  void add_node_moments(
    const UpdateAxis &axis, double mass, const Vector3 &x, const Vector3 &v, UpdateSums &sums);

  /** Replaces the sums, and the @p more numbers, by those over all ranks. Collective. */
  void sum_over_ranks(UpdateSums                  &sums,
                      const Communicator          &communicator,
                      const std::vector<double *> &more = {});

  /** Kinetic energy of the rigid motion of compute_momentum_rate() [mJ]. */
  double compute_rigid_kinetic_energy(const UpdateAxis &axis, double mass, const UpdateSums &sums);

  /** The rigid motion with the same momentum about the axis, or with the same momentum and angular
   * momentum. */
  RigidVelocity compute_momentum_rate(const UpdateAxis &axis, double mass, const UpdateSums &sums);
} // namespace vfife

#endif
