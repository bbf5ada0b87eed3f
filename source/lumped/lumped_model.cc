// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/types.h>
#include <vfife/lumped/lumped_model.h>

#include <Eigen/Eigenvalues>

#include <cmath>

namespace vfife
{
  namespace
  {
    /** Positions over which the mean stiffness is taken. */
    constexpr unsigned int n_positions = 256;
  } // namespace

  LumpedModel::LumpedModel(LumpedPair pair)
    : pair_(std::move(pair))
  {
    const unsigned int n_rotations = pair_.driver_is_free ? 2 : 1;
    const unsigned int n           = n_rotations + pair_.supports.size();
    // Compression of the mesh s = h . q + u(x) [rad of the gear], h the levers: the gear's rotation
    // opens the mesh, -1, the pinion's closes it by the ratio i.
    // Order: the gear's rotation, the pinion's where it is free, then the supports. Loads Q =
    // (-T, i T, 0...).
    masses_ = levers_ = stiffness_ = damping_ = loads_ = Eigen::VectorXd::Zero(n);
    masses_[0]                                         = pair_.driven_inertia;
    levers_[0]                                         = -1;
    loads_[0]                                          = -pair_.torque;
    if (pair_.driver_is_free)
      {
        masses_[1] = pair_.driver_inertia;
        levers_[1] = pair_.ratio();
        loads_[1]  = pair_.ratio() * pair_.torque;
      }
    for (unsigned int j = 0; j < pair_.supports.size(); ++j)
      {
        const LumpedSupport &support = pair_.supports[j];
        masses_[n_rotations + j]     = support.inertia;
        levers_[n_rotations + j]     = support.lever;
        stiffness_[n_rotations + j]  = support.stiffness;
        damping_[n_rotations + j] =
          2 * support.damping_ratio * std::sqrt(support.stiffness * support.inertia);
      }
    // On the gear's rotation over the kinematic one: 1/s times its inertia.
    damping_[0] = pair_.speed_damping * pair_.driven_inertia;

    // Linear models use the tangent stiffness under the torque, in the mean over a mesh; the damper
    // of the mesh is 2 zeta sqrt(k J) with it.
    for (unsigned int i = 0; i < n_positions; ++i)
      {
        const double x = static_cast<double>(i) / n_positions;
        mesh_stiffness_ += pair_.law.slope(pair_.law.compression(pair_.torque, x), x) / n_positions;
      }
    mesh_damping_ = 2 * pair_.damping_ratio * std::sqrt(mesh_stiffness_ * swing_inertia());
  }

  double LumpedModel::swing_inertia() const
  {
    // 1/J = 1/J_g + i^2/J_p; a prescribed pinion is an infinite inertia.
    double sum = 1 / masses_[0];
    if (pair_.driver_is_free)
      sum += levers_[1] * levers_[1] / masses_[1];
    return 1 / sum;
  }

  double LumpedModel::swing_rate() const
  {
    return std::sqrt(mesh_stiffness_ / swing_inertia());
  }

  double LumpedModel::compression(const Eigen::VectorXd &q, const double x) const
  {
    return levers_.dot(q) + pair_.law.unloaded_error.value(x);
  }

  double LumpedModel::transmission_error(const Eigen::VectorXd &q) const
  {
    // q_g - i q_p: what both have on top of the kinematic motion.
    return q[0] - (pair_.driver_is_free ? pair_.ratio() * q[1] : 0.);
  }

  Eigen::VectorXd LumpedModel::find_equilibrium(const double x) const
  {
    Eigen::VectorXd q = Eigen::VectorXd::Zero(n());
    // Supports give way to h_j M with M = T; the gear's rotation (lever -1) then sets the
    // compression that carries T. The pinion's stays zero.
    for (unsigned int j = pair_.driver_is_free ? 2 : 1; j < n(); ++j)
      q[j] = -levers_[j] * pair_.torque / stiffness_[j];
    q[0] += compression(q, x) - pair_.law.compression(pair_.torque, x);
    return q;
  }

  LumpedModel::Rates LumpedModel::compute_rates(const Eigen::VectorXd &q,
                                                const Eigen::VectorXd &v,
                                                const double           x,
                                                const double           mesh_frequency) const
  {
    // s = h . q + u(x), s' = h . q' + u'(x) x'
    const MeshLaw &law        = pair_.law;
    const double   s          = compression(q, x);
    const double   error_rate = law.unloaded_error.slope(x) * mesh_frequency;
    const double   s_rate     = levers_.dot(v) + error_rate;
    const bool     touches    = s > 0 || s < -law.backlash;
    const double   damping    = touches || pair_.damping_without_contact ? mesh_damping_ : 0.;
    Rates          rates;
    rates.mesh_torque = law.torque(s, x) + damping * s_rate;
    // m q'' = Q - h (M + c s') - k q - c q'
    rates.acceleration =
      (loads_ - levers_ * rates.mesh_torque - stiffness_.cwiseProduct(q) - damping_.cwiseProduct(v))
        .cwiseQuotient(masses_);
    // The time derivative of the energy of compute_energy() is the difference of these two: what
    // torques and the change of u and of the law with x supply, less what dampers take.
    rates.supplied =
      loads_.dot(v) + rates.mesh_torque * error_rate + law.energy_slope(s, x) * mesh_frequency;
    rates.dissipated = damping * s_rate * s_rate + damping_.dot(v.cwiseAbs2());
    return rates;
  }

  double LumpedModel::compute_energy(const Eigen::VectorXd &q,
                                     const Eigen::VectorXd &v,
                                     const double           x) const
  {
    // T + sum k q^2/2 + U(s, x), of the motion on top of the kinematic one.
    return 0.5 * masses_.dot(v.cwiseAbs2()) + 0.5 * stiffness_.dot(q.cwiseAbs2()) +
           pair_.law.energy(compression(q, x), x);
  }

  std::vector<LumpedMode> LumpedModel::find_modes() const
  {
    // K = diag(k_j) + k h h^T, C = diag(c_j) + c h h^T
    Eigen::MatrixXd K = stiffness_.asDiagonal();
    K += mesh_stiffness_ * levers_ * levers_.transpose();
    Eigen::MatrixXd C = damping_.asDiagonal();
    C += mesh_damping_ * levers_ * levers_.transpose();
    const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> solver(
      K, Eigen::MatrixXd(masses_.asDiagonal()));
    std::vector<LumpedMode> modes;
    const double            largest = solver.eigenvalues().maxCoeff();
    for (unsigned int k = 0; k < n(); ++k)
      {
        LumpedMode   mode;
        const double value = solver.eigenvalues()[k];
        mode.shape         = solver.eigenvectors().col(k);
        // Round-off of the pair that turns as a whole.
        if (value > 1e-12 * largest)
          {
            mode.frequency = std::sqrt(value) / (2 * pi);
            // Modal damping, couplings by C left out.
            mode.damping_ratio = mode.shape.dot(C * mode.shape) / (2 * std::sqrt(value));
          }
        modes.push_back(mode);
      }
    return modes;
  }
} // namespace vfife
