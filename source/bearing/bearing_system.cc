// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/bearing/bearing_system.h>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include <cmath>
#include <string>
#include <utility>

namespace vfife
{
  namespace
  {
    constexpr unsigned int largest_iterations = 60, largest_halvings = 12;
    /** Of the decrease that a Newton step promises, over the energy. */
    constexpr double tolerance = 1e-22;
  } // namespace

  BearingSystem::BearingSystem(std::vector<Seat> seats)
    : seats_(std::move(seats))
    , reading_(Eigen::MatrixXd::Zero(5 * seats_.size(), 6 * seats_.size()))
  {
    for (std::size_t s = 0; s < seats_.size(); ++s)
      {
        reading_.block<3, 3>(5 * s, 6 * s)         = seats_[s].axes.transpose();
        reading_.block<2, 3>(5 * s + 3, 6 * s + 3) = seats_[s].axes.leftCols<2>().transpose();
      }
  }

  void BearingSystem::set_housing(const Eigen::MatrixXd &stiffness)
  {
    const auto n = static_cast<Eigen::Index>(6 * seats_.size());
    if (stiffness.rows() != n || stiffness.cols() != n)
      throw InputError("housing stiffness: expected " + std::to_string(n) + " x " +
                       std::to_string(n) + " entries for " + std::to_string(seats_.size()) +
                       " bearings, got " + std::to_string(stiffness.rows()) + " x " +
                       std::to_string(stiffness.cols()));
    // In units of its diagonal, as forces and moments have different ones.
    if (!(stiffness.diagonal().minCoeff() > 0))
      throw InputError("housing stiffness: all numbers on the diagonal must be positive");
    const Eigen::VectorXd scale = stiffness.diagonal().cwiseSqrt().cwiseInverse();
    const Eigen::MatrixXd pure  = scale.asDiagonal() * stiffness * scale.asDiagonal();
    if ((pure - pure.transpose()).cwiseAbs().maxCoeff() > 1e-6)
      throw InputError("the housing stiffness matrix is not symmetric");
    if (!(Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(.5 * (pure + pure.transpose()))
            .eigenvalues()
            .minCoeff() > 1e-9))
      throw InputError("the housing stiffness matrix must be positive definite. Fix the housing in "
                       "the model that gives the matrix");
    housing_ = .5 * (stiffness + stiffness.transpose());
  }

  std::vector<Vector5> BearingSystem::beside_housing(const std::vector<Vector5> &displacements,
                                                     const Eigen::VectorXd      &housing) const
  {
    const Eigen::VectorXd moved   = reading_ * housing;
    std::vector<Vector5>  between = displacements;
    for (std::size_t s = 0; s < seats_.size(); ++s)
      between[s] -= moved.segment<5>(5 * s);
    return between;
  }

  BearingSystem::Response BearingSystem::sum_laws(const std::vector<Vector5> &displacements,
                                                  const std::vector<double>  &turns) const
  {
    Response sum;
    sum.stiffness = Eigen::MatrixXd::Zero(5 * seats_.size(), 5 * seats_.size());
    for (std::size_t s = 0; s < seats_.size(); ++s)
      {
        const BearingResponse one = seats_[s].law->evaluate(displacements[s], turns[s]);
        sum.loads.push_back(one.load);
        sum.stiffness.block<5, 5>(5 * s, 5 * s) = one.stiffness;
        sum.energy += one.energy;
        sum.turn_slopes.push_back(one.turn_slope);
      }
    return sum;
  }

  BearingSystem::Response BearingSystem::evaluate(const std::vector<Vector5> &displacements,
                                                  const std::vector<double>  &turns) const
  {
    if (!has_housing())
      return sum_laws(displacements, turns);
    // E(h) = sum e(q - A h) + h . K h/2, slope A^T load + K h, by Newton's method from the housing
    // at rest: what it finds does not depend on what was asked before.
    Eigen::VectorXd h   = Eigen::VectorXd::Zero(housing_.rows());
    Response        now = sum_laws(beside_housing(displacements, h), turns);
    for (unsigned int i = 0; i < largest_iterations; ++i)
      {
        Eigen::VectorXd slope = housing_ * h;
        for (std::size_t s = 0; s < seats_.size(); ++s)
          slope += reading_.middleRows<5>(5 * s).transpose() * now.loads[s];
        const Eigen::MatrixXd              coupled = reading_.transpose() * now.stiffness;
        const Eigen::LDLT<Eigen::MatrixXd> hessian(housing_ + coupled * reading_);
        const Eigen::VectorXd              step    = -hessian.solve(slope);
        const double                       promise = -.5 * slope.dot(step);
        if (!std::isfinite(promise))
          break;
        const double energy = now.energy + .5 * h.dot(housing_ * h);
        if (std::abs(promise) <= tolerance * std::abs(energy) || slope.norm() == 0.)
          {
            // What is left of the bearings' stiffness when the housing follows.
            now.stiffness -= coupled.transpose() * hessian.solve(coupled);
            now.energy  = energy;
            now.housing = h;
            return now;
          }
        // Half the step until the energy falls, or is down to its round-off.
        double          part = 1;
        Eigen::VectorXd next;
        for (unsigned int k = 0;; ++k, part *= .5)
          {
            next = h + part * step;
            now  = sum_laws(beside_housing(displacements, next), turns);
            if (k == largest_halvings ||
                now.energy + .5 * next.dot(housing_ * next) <= energy + 1e-14 * std::abs(energy))
              break;
          }
        h = next;
      }
    throw NumericalError("the equilibrium of bearings and housing did not converge");
  }

  BearingSystem::Linear BearingSystem::linearized() const
  {
    const auto      n     = static_cast<Eigen::Index>(5 * seats_.size());
    Eigen::VectorXd loads = Eigen::VectorXd::Zero(n);
    Eigen::MatrixXd K     = Eigen::MatrixXd::Zero(n, n);
    for (std::size_t s = 0; s < seats_.size(); ++s)
      {
        const BearingResponse law   = seats_[s].law->linearized();
        loads.segment<5>(5 * s)     = law.load;
        K.block<5, 5>(5 * s, 5 * s) = law.stiffness;
      }
    if (has_housing())
      {
        // Of laws f - K (q - A h), K_H h + A^T (f - K (q - A h)) = 0.
        const Eigen::MatrixXd              coupled = reading_.transpose() * K;
        const Eigen::LDLT<Eigen::MatrixXd> hessian(housing_ + coupled * reading_);
        loads -= coupled.transpose() * hessian.solve(reading_.transpose() * loads);
        K -= coupled.transpose() * hessian.solve(coupled);
      }
    return {reading_.transpose() * loads,
            reading_.transpose() * (.5 * (K + K.transpose())) * reading_};
  }
} // namespace vfife
