// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/dynamics/motion/nodal_update.h>

#include <cmath>

namespace vfife
{
  namespace generic
  {
    UpdateFunction update_kernel;
  }
#ifdef __x86_64__
  namespace avx2
  {
    UpdateFunction update_kernel;
  }
  namespace avx512
  {
    UpdateFunction update_kernel;
  }
#endif

  namespace
  {
    UpdateKernel select_update(const InstructionSet instruction_set)
    {
#ifdef __x86_64__
      if (instruction_set == InstructionSet::avx512)
        return &avx512::update_kernel;
      if (instruction_set == InstructionSet::avx2)
        return &avx2::update_kernel;
#endif
      // Two lanes would gain nothing over plain numbers: the loop waits for memory.
      (void)instruction_set;
      return &generic::update_kernel;
    }

    void copy(const Vector3 &vector, double (&out)[3])
    {
      Eigen::Map<Vector3>(out, 3) = vector;
    }

    /** @p found: the sums of a kernel. */
    void add_found(const double *found, NodalMotion &motion)
    {
      motion.momentum += Eigen::Map<const Vector3>(found + sum_of_old_momentum);
      motion.angular_momentum += Eigen::Map<const Vector3>(found + sum_of_old_angular_momentum);
      motion.speed += found[sum_of_speed];
      motion.turning_mass += found[sum_of_turning_mass];
      motion.mass += found[sum_of_mass];
      motion.change += Eigen::Map<const Vector3>(found + sum_of_change);
      motion.square_of_change += found[sum_of_square_of_change];
    }

    UpdateCoefficients
    make_coefficients(const double dt, const BodyDamping &damping, const UpdateAxis &axis)
    {
      // v+ = ((1 - a) v- + dt (f/m - slip) + 2 a u)/(1 + a): the factors of v-, f/m - slip and u
      const double       a = 0.5 * damping.zeta * dt, inverse = 1. / (1. + a);
      UpdateCoefficients result;
      result.old_velocity = inverse * (1. - a);
      result.acceleration = inverse * dt;
      result.rigid        = inverse * 2. * a;
      result.dt           = dt;
      result.use_axis     = axis.use_axis;
      // u, slip and the lever e = direction x (x - point) are each of the form a + b x x.
      copy(damping.rigid.velocity, result.velocity);
      copy(damping.rigid.omega, result.omega);
      copy(damping.mesh.velocity, result.slip);
      copy(damping.mesh.omega, result.slip_omega);
      copy(axis.direction, result.direction);
      copy(-axis.direction.cross(axis.point), result.lever);
      return result;
    }
  } // namespace

  void NodalMotion::add(const UpdateAxis &axis,
                        const double      node_mass,
                        const Vector3    &x,
                        const Vector3    &v,
                        const Vector3    &next)
  {
    momentum += node_mass * v;
    angular_momentum += node_mass * x.cross(v);
    const double square = axis.direction.cross(x - axis.point).squaredNorm();
    if (square > 0)
      {
        speed += node_mass * std::sqrt(v.squaredNorm() / square);
        turning_mass += node_mass;
      }
    mass += node_mass;
    change += node_mass * (next - v);
    square_of_change += node_mass * (next - v).squaredNorm();
  }

  UpdateSums update_nodes(const std::size_t    first,
                          const std::size_t    last,
                          const double         dt,
                          const BodyDamping   &damping,
                          const UpdateAxis    &axis,
                          const NodeRecords   &records,
                          NodalMotion         *motion,
                          const InstructionSet instruction_set)
  {
    double             found[n_measured_sums] = {};
    UpdateCoefficients coefficients           = make_coefficients(dt, damping, axis);
    coefficients.measures                     = motion != nullptr;
    select_update(instruction_set)(coefficients, first, last, records, found);
    if (motion != nullptr)
      add_found(found, *motion);
    // The kernel leaves zeta out of what the damper does.
    UpdateSums sums;
    sums.kinetic        = found[sum_of_kinetic];
    sums.damping_power  = damping.zeta * found[sum_of_damping_power];
    sums.mesh_power     = found[sum_of_mesh_power];
    sums.damping_torque = damping.zeta * found[sum_of_damping_torque];
    // Moments of the new state: about the axis, or all of them, the second ones as xx yy zz xy yz
    // zx.
    if (axis.use_axis)
      {
        sums.axial_momentum = found[sum_of_axial_momentum];
        sums.axial_inertia  = found[sum_of_axial_inertia];
        return sums;
      }
    sums.momentum         = Eigen::Map<const Vector3>(found + sum_of_momentum);
    sums.first_moment     = Eigen::Map<const Vector3>(found + sum_of_first_moment);
    sums.angular_momentum = Eigen::Map<const Vector3>(found + sum_of_angular_momentum);
    for (unsigned int i = 0; i < 3; ++i)
      {
        const unsigned int j     = (i + 1) % 3;
        sums.second_moment(i, i) = found[sum_of_second_moment + i];
        sums.second_moment(i, j) = sums.second_moment(j, i) = found[sum_of_second_moment + 3 + i];
      }
    return sums;
  }
} // namespace vfife
