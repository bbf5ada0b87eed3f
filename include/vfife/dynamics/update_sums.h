// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_dynamics_update_sums_h
#define vfife_dynamics_update_sums_h

#include <vfife/dynamics/rigid_velocity.h>

#include <vector>

namespace vfife
{
  class Body;
  class Communicator;

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
    Vector3 momentum         = Vector3::Zero(); ///< sum m v_+ (bodies without a fixed axis)
    Vector3 first_moment     = Vector3::Zero(); ///< sum m x
    Vector3 angular_momentum = Vector3::Zero(); ///< sum m x x v_+, about the fixed origin
    Matrix3 second_moment    = Matrix3::Zero(); ///< sum m x x^T
  };

  /** Sums of one body in one step; drive powers are done on the body, with v_- and with v_+. */
  struct BodySums
  {
    UpdateSums update;
    double     drive_power_before = 0, drive_power_after = 0; ///< [mJ/s]
    double     drive_torque = 0;                              ///< about the axis [N mm]
  };

  /** The line through `point` in unit `direction`: bodies that turn on a fixed axis; use_axis
   * false: all moments are summed instead. */
  struct UpdateAxis
  {
    bool    use_axis = false;
    Vector3 point = Vector3::Zero(), direction = Vector3::UnitZ();

    /** The one of a body of a model. */
    static UpdateAxis of(const Body &body);
  };

  /** Adds the sums of the new state for one more node (constrained ones). */
  void add_node_moments(
    const UpdateAxis &axis, double mass, const Vector3 &x, const Vector3 &v, UpdateSums &sums);

  /** Replaces the sums by those over all ranks. Collective. */
  void sum_over_ranks(BodySums &sums, const Communicator &communicator);

  /** The same for numbers wherever they stand, in one reduction for all. Collective. */
  void sum_over_ranks(const std::vector<double *> &numbers, const Communicator &communicator);

  /** Appends all numbers of the sums of a body. */
  void append_numbers(BodySums &sums, std::vector<double *> &numbers);

  /** Inertia about the axis, whether the body is held on it or not [t mm^2]. */
  double compute_axial_inertia(const UpdateAxis &axis, double mass, const UpdateSums &sums);

  /** Kinetic energy of the rigid motion of compute_momentum_rate() [mJ]. */
  double compute_rigid_kinetic_energy(const UpdateAxis &axis, double mass, const UpdateSums &sums);

  /** The rigid motion with the same momentum about the axis, or with the same momentum and angular
   * momentum. */
  RigidVelocity compute_momentum_rate(const UpdateAxis &axis, double mass, const UpdateSums &sums);
} // namespace vfife

#endif
