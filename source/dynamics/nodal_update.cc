// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/communicator.h>
#include <vfife/dynamics/nodal_update.h>

#include <Eigen/LU>

namespace vfife
{
  void UpdateSums::operator+=(const UpdateSums &other)
  {
    kinetic += other.kinetic;
    damping_power += other.damping_power;
    mesh_power += other.mesh_power;
    damping_torque += other.damping_torque;
    axial_momentum += other.axial_momentum;
    axial_inertia += other.axial_inertia;
    momentum += other.momentum;
    first_moment += other.first_moment;
    angular_momentum += other.angular_momentum;
    second_moment += other.second_moment;
  }

  namespace
  {
    template <bool use_axis>
    UpdateSums update(const std::size_t    first,
                      const std::size_t    last,
                      const double         dt,
                      const BodyDamping   &damping,
                      const UpdateAxis    &axis,
                      const unsigned char *owned,
                      const double        *forces,
                      double              *positions,
                      double              *velocities)
    {
      const double  a = 0.5 * damping.zeta * dt, inverse = 1. / (1. + a);
      const Vector3 e_0   = -axis.direction.cross(axis.point);
      const bool    slips = !damping.mesh.omega.isZero(0.) || !damping.mesh.velocity.isZero(0.);
      UpdateSums    sums;
      for (std::size_t i = 4 * first; i < 4 * last; i += 4)
        {
          const Vector3 x(positions[i], positions[i + 1], positions[i + 2]);
          const Vector3 f(forces[i], forces[i + 1], forces[i + 2]);
          const Vector3 v_old(velocities[i], velocities[i + 1], velocities[i + 2]);
          const Vector3 u    = damping.rigid.at(x);
          const Vector3 slip = slips ? damping.mesh.at(x) : Vector3(Vector3::Zero());

          const Vector3 v_new =
            inverse * ((1. - a) * v_old + dt * (positions[i + 3] * f - slip) + (2. * a) * u);
          const Vector3 x_new = x + dt * v_new;

          const double  m        = owned[i / 4] ? velocities[i + 3] : 0.;
          const Vector3 v        = 0.5 * (v_old + v_new);
          const Vector3 relative = v - u;
          sums.kinetic += 0.5 * m * v_old.dot(v_new);
          sums.damping_power += m * relative.dot(v);
          sums.mesh_power += m * slip.dot(v);
          if (use_axis)
            {
              const Vector3 e     = e_0 + axis.direction.cross(x);
              const Vector3 e_new = e_0 + axis.direction.cross(x_new);
              sums.damping_torque -= m * e.dot(relative);
              sums.axial_momentum += m * e_new.dot(v_new);
              sums.axial_inertia += m * e_new.squaredNorm();
            }
          else
            {
              sums.momentum += m * v_new;
              sums.first_moment += m * x_new;
              sums.angular_momentum += m * x_new.cross(v_new);
              sums.second_moment += m * x_new * x_new.transpose();
            }
          for (int c = 0; c < 3; ++c)
            {
              positions[i + c]  = x_new[c];
              velocities[i + c] = v_new[c];
            }
        }
      sums.damping_power *= damping.zeta;
      sums.damping_torque *= damping.zeta;
      return sums;
    }
  } // namespace

  UpdateSums update_nodes(const std::size_t    first,
                          const std::size_t    last,
                          const double         dt,
                          const BodyDamping   &damping,
                          const UpdateAxis    &axis,
                          const unsigned char *owned,
                          const double        *forces,
                          double              *positions,
                          double              *velocities)
  {
    return axis.use_axis
             ? update<true>(first, last, dt, damping, axis, owned, forces, positions, velocities)
             : update<false>(first, last, dt, damping, axis, owned, forces, positions, velocities);
  }

  void add_node_moments(
    const UpdateAxis &axis, const double mass, const Vector3 &x, const Vector3 &v, UpdateSums &sums)
  {
    if (axis.use_axis)
      {
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

  void sum_over_ranks(UpdateSums                  &sums,
                      const Communicator          &communicator,
                      const std::vector<double *> &more)
  {
    std::vector<double *> numbers = {&sums.kinetic,
                                     &sums.damping_power,
                                     &sums.mesh_power,
                                     &sums.damping_torque,
                                     &sums.axial_momentum,
                                     &sums.axial_inertia};
    for (unsigned int i = 0; i < 3; ++i)
      numbers.insert(numbers.end(),
                     {&sums.momentum[i], &sums.first_moment[i], &sums.angular_momentum[i]});
    for (unsigned int i = 0; i < 9; ++i)
      numbers.push_back(sums.second_moment.data() + i);
    numbers.insert(numbers.end(), more.begin(), more.end());

    std::vector<double> values;
    for (const double *number : numbers)
      values.push_back(*number);
    communicator.sum(values);
    for (std::size_t i = 0; i < numbers.size(); ++i)
      *numbers[i] = values[i];
  }

  double
  compute_rigid_kinetic_energy(const UpdateAxis &axis, const double mass, const UpdateSums &sums)
  {
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
    RigidVelocity rate;
    if (axis.use_axis)
      {
        rate.omega    = (sums.axial_momentum / sums.axial_inertia) * axis.direction;
        rate.velocity = -rate.omega.cross(axis.point);
        return rate;
      }
    const Vector3 centre  = sums.first_moment / mass;
    const Matrix3 second  = sums.second_moment - mass * centre * centre.transpose();
    const Matrix3 inertia = second.trace() * Matrix3::Identity() - second;
    rate.omega    = inertia.inverse() * (sums.angular_momentum - centre.cross(sums.momentum));
    rate.velocity = sums.momentum / mass - rate.omega.cross(centre);
    return rate;
  }
} // namespace vfife
