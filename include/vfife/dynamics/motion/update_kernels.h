// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_dynamics_motion_update_kernels_h
#define vfife_dynamics_motion_update_kernels_h

// Nothing else: see element/kernels/kernels.h. This header is read by files compiled for one
// instruction set each.
#include <vfife/element/kernels/kernels.h>

namespace vfife
{
  /** The numbers of one body in update_nodes() of nodal_update.h. */
  struct UpdateCoefficients
  {
    double old_velocity  = 1.; ///< (1 - a)/(1 + a)
    double acceleration  = 0.; ///< dt/(1 + a) [s]
    double rigid         = 0.; ///< 2 a/(1 + a)
    double dt            = 0.; ///< [s]
    double velocity[3]   = {}; ///< of the rigid motion at the origin [mm/s]
    double omega[3]      = {}; ///< of the rigid motion [rad/s]
    double slip[3]       = {}; ///< driven speed damping at the origin [mm/s^2]
    double slip_omega[3] = {}; ///< [rad/s^2]
    double direction[3]  = {}; ///< of the axis
    double lever[3]      = {}; ///< of the axis at the origin: minus direction x point [mm]
    bool   use_axis      = false;
    bool   measures      = false; ///< whether the sums of NodalMotion are made
  };

  /** Where each sum of UpdateSums stands in the results of an update kernel; damping sums lack the
   * factor zeta. */
  enum UpdateSum : unsigned int
  {
    sum_of_kinetic,
    sum_of_damping_power,
    sum_of_mesh_power,
    sum_of_damping_torque,
    sum_of_axial_momentum,
    sum_of_axial_inertia,
    sum_of_momentum         = 4,  ///< three; instead of the axial ones
    sum_of_first_moment     = 7,  ///< three
    sum_of_angular_momentum = 10, ///< three
    sum_of_second_moment    = 13, ///< six: xx yy zz xy yz zx
    n_update_sums           = 19,
    /** Those of NodalMotion, where they are asked for. */
    sum_of_old_momentum         = 19, ///< three
    sum_of_old_angular_momentum = 22, ///< three
    sum_of_speed                = 25,
    sum_of_turning_mass         = 26,
    sum_of_mass                 = 27,
    sum_of_change               = 28, ///< three
    sum_of_square_of_change     = 31,
    n_measured_sums             = 32
  };

  /** Records of the NodeFields of a State. New positions and velocities may go where the old ones
   * are, or elsewhere. */
  struct NodeRecords
  {
    const unsigned char *owned; ///< 1 where a node counts in the sums
    const double        *forces, *old_positions, *old_velocities;
    double              *positions, *velocities;
  };

  /** Updates nodes [@p first, @p last) and adds to @p sums. */
  using UpdateFunction = void(const UpdateCoefficients &coefficients,
                              std::size_t               first,
                              std::size_t               last,
                              NodeRecords               records,
                              double                   *sums);
  using UpdateKernel   = UpdateFunction *;
} // namespace vfife

#endif
