// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/process/communicator.h>
#include <vfife/dynamics/update_sums.h>
#include <vfife/model/body.h>

#include <Eigen/LU>

namespace vfife
{
  UpdateAxis UpdateAxis::of(const Body &body)
  {
    return {body.turns_on_axis && !body.floats, body.axis.point, body.axis.direction};
  }

  void add_node_moments(
    const UpdateAxis &axis, const double mass, const Vector3 &x, const Vector3 &v, UpdateSums &sums)
  {
    if (axis.use_axis)
      {
        // A body in bearings has one angular velocity. Moments of one that flies are about the
        // origin: where its centre is follows from the sums.
        const Vector3 e = axis.direction.cross(x - axis.point);
        sums.axial_momentum += mass * e.dot(v);
        sums.axial_inertia += mass * e.squaredNorm();
      }
    else
      {
        sums.momentum += mass * v;
        sums.first_moment += mass * x;
        sums.angular_momentum += mass * x.cross(v);
        sums.second_moment += mass * x * x.transpose();
      }
  }

  void append_numbers(BodySums &sums, std::vector<double *> &numbers)
  {
    // Every sum of a body is in the list: what is left out of it stays that of this rank.
    UpdateSums &update = sums.update;
    numbers.insert(numbers.end(),
                   {&update.kinetic,
                    &update.damping_power,
                    &update.mesh_power,
                    &update.damping_torque,
                    &update.axial_momentum,
                    &update.axial_inertia,
                    &sums.drive_power_before,
                    &sums.drive_power_after,
                    &sums.drive_torque});
    for (unsigned int i = 0; i < 3; ++i)
      numbers.insert(numbers.end(),
                     {&update.momentum[i], &update.first_moment[i], &update.angular_momentum[i]});
    for (unsigned int i = 0; i < 9; ++i)
      numbers.push_back(update.second_moment.data() + i);
  }

  void sum_over_ranks(const std::vector<double *> &numbers, const Communicator &communicator)
  {
    if (communicator.size() == 1)
      return;
    std::vector<double> values;
    for (const double *number : numbers)
      values.push_back(*number);
    communicator.sum(values);
    for (std::size_t i = 0; i < numbers.size(); ++i)
      *numbers[i] = values[i];
  }

  void sum_over_ranks(BodySums &sums, const Communicator &communicator)
  {
    std::vector<double *> numbers;
    append_numbers(sums, numbers);
    sum_over_ranks(numbers, communicator);
  }

  double compute_axial_inertia(const UpdateAxis &axis, const double mass, const UpdateSums &sums)
  {
    if (axis.use_axis)
      return sums.axial_inertia;
    // I = tr S - a S a of the second moments S = sum m (x - p) (x - p)^T about a point p of the
    // axis
    const Vector3 &p     = axis.point;
    const Matrix3  cross = p * sums.first_moment.transpose();
    const Matrix3  second =
      sums.second_moment - cross - cross.transpose() + mass * p * p.transpose();
    return second.trace() - axis.direction.dot(second * axis.direction);
  }

  double
  compute_rigid_kinetic_energy(const UpdateAxis &axis, const double mass, const UpdateSums &sums)
  {
    // L^2/(2 I) about the axis; else p^2/(2 m) + omega . L_c/2 with L_c = L - c x p about the
    // centre
    if (axis.use_axis)
      return 0.5 * sums.axial_momentum * sums.axial_momentum / sums.axial_inertia;
    const RigidVelocity rate   = compute_momentum_rate(axis, mass, sums);
    const Vector3       centre = sums.first_moment / mass;
    return 0.5 * sums.momentum.squaredNorm() / mass +
           0.5 * rate.omega.dot(sums.angular_momentum - centre.cross(sums.momentum));
  }

  RigidVelocity
  compute_momentum_rate(const UpdateAxis &axis, const double mass, const UpdateSums &sums)
  {
    // omega = sum m e . v / sum m e . e, e = axis x r: the damper exerts no torque about the axis.
    RigidVelocity rate;
    if (axis.use_axis)
      {
        rate.omega    = (sums.axial_momentum / sums.axial_inertia) * axis.direction;
        rate.velocity = -rate.omega.cross(axis.point);
        return rate;
      }
    // J omega = L - c x p about the centre c = sum m x / m, J = tr(S) I - S with the central second
    // moments S; the velocity is that of the point at the origin.
    const Vector3 centre  = sums.first_moment / mass;
    const Matrix3 second  = sums.second_moment - mass * centre * centre.transpose();
    const Matrix3 inertia = second.trace() * Matrix3::Identity() - second;
    rate.omega    = inertia.inverse() * (sums.angular_momentum - centre.cross(sums.momentum));
    rate.velocity = sums.momentum / mass - rate.omega.cross(centre);
    return rate;
  }
} // namespace vfife
