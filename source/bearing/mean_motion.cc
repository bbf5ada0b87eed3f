// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/bearing/mean_motion.h>

#include <Eigen/LU>
#include <Eigen/SVD>

#include <numeric>

namespace vfife
{
  namespace
  {
    /** Sums over the set's nodes: A x, A x r^T, A v, A v r^T. */
    enum Sum
    {
      places     = 0,
      moments    = 3,
      velocities = 12,
      rates      = 15,
      n_sums     = 24
    };
  } // namespace

  MeanMotion::MeanMotion(std::vector<double>         shares,
                         const std::vector<Vector3> &places,
                         const std::string          &owner)
    : shares_(std::move(shares))
    , centre_(Vector3::Zero())
    , owner_(owner)
  {
    const double sum = std::accumulate(shares_.begin(), shares_.end(), 0.);
    for (double &share : shares_)
      share /= sum;
    for (std::size_t i = 0; i < places.size(); ++i)
      centre_ += shares_[i] * places[i];
    for (const Vector3 &place : places)
      arms_.push_back(place - centre_);
    try
      {
        at_rest();
      }
    catch (const NumericalError &)
      {
        throw InputError(owner_ +
                         ": the selected nodes are collinear. Select nodes around the shaft");
      }
  }

  std::vector<double> MeanMotion::make_sums()
  {
    return std::vector<double>(n_sums, 0.);
  }

  void MeanMotion::add(const std::size_t    i,
                       const Vector3       &place,
                       const Vector3       &velocity,
                       std::vector<double> &sums) const
  {
    // Moments need no present centre: sum A r = 0.
    Eigen::Map<Vector3>(sums.data() + places) += shares_[i] * place;
    Eigen::Map<Matrix3>(sums.data() + moments) += shares_[i] * place * arms_[i].transpose();
    Eigen::Map<Vector3>(sums.data() + velocities) += shares_[i] * velocity;
    Eigen::Map<Matrix3>(sums.data() + rates) += shares_[i] * velocity * arms_[i].transpose();
  }

  MeanMotion::Motion MeanMotion::solve(const std::vector<double> &sums) const
  {
    Motion motion;
    // 1. Mean rotation. Nodes of a plane leave the third singular value at zero; its direction is
    // chosen so that R does not mirror.
    const Eigen::Map<const Matrix3> second(sums.data() + moments);
    const Eigen::JacobiSVD<Matrix3> svd(second, Eigen::ComputeFullU | Eigen::ComputeFullV);
    Matrix3                         U = svd.matrixU();
    if ((U * svd.matrixV().transpose()).determinant() < 0)
      U.col(2) *= -1;
    motion.rotation     = U * svd.matrixV().transpose();
    motion.displacement = Eigen::Map<const Vector3>(sums.data() + places) - centre_;

    // 2. The inertia of the set's shares about its centre.
    const Matrix3                   S       = second * motion.rotation.transpose();
    const Matrix3                   inertia = S.trace() * Matrix3::Identity() - S;
    const Eigen::FullPivLU<Matrix3> factors(inertia);
    if (!factors.isInvertible())
      throw NumericalError(
        owner_ + ": its nodes have become collinear, so that they cannot transmit a moment");
    motion.inverse_inertia = factors.inverse();

    // 3. J w = sum A (R r) x v: the axial vector of sum A v (R r)^T less its transpose.
    const Matrix3 rate =
      Eigen::Map<const Matrix3>(sums.data() + rates) * motion.rotation.transpose();
    motion.velocity = Eigen::Map<const Vector3>(sums.data() + velocities);
    motion.spin =
      motion.inverse_inertia *
      Vector3(rate(2, 1) - rate(1, 2), rate(0, 2) - rate(2, 0), rate(1, 0) - rate(0, 1));
    return motion;
  }

  MeanMotion::Motion MeanMotion::at_rest() const
  {
    std::vector<double> sums = make_sums();
    for (std::size_t i = 0; i < arms_.size(); ++i)
      add(i, centre_ + arms_[i], Vector3::Zero(), sums);
    return solve(sums);
  }

  Eigen::Matrix<double, 6, 3> MeanMotion::derivative(const std::size_t i,
                                                     const Motion     &at_rest) const
  {
    Eigen::Matrix<double, 6, 3> derivative;
    derivative.topRows<3>() = shares_[i] * Matrix3::Identity();
    for (unsigned int d = 0; d < 3; ++d)
      derivative.col(d).tail<3>() =
        shares_[i] * at_rest.inverse_inertia * arms_[i].cross(Vector3::Unit(d));
    return derivative;
  }
} // namespace vfife
