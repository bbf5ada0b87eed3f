// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include "residual_sum.h"

#include <vfife/base/process/communicator.h>
#include <vfife/base/types.h>

#include <algorithm>
#include <cmath>

namespace vfife
{
  namespace
  {
    /** Nodes whose flexibility is followed all around the body. */
    constexpr unsigned int largest_sample = 32;
  } // namespace

  ResidualSum::ResidualSum(const unsigned int n_sectors,
                           const unsigned int reach,
                           const unsigned int n_rows,
                           const unsigned int n_columns)
    : n_sectors_(n_sectors)
    , reach_(std::min(reach, n_sectors / 2))
    , near_(2 * reach_ + 1, Eigen::MatrixXd::Zero(n_rows, n_columns))
    , summed_(Eigen::MatrixXd::Zero(n_rows, n_columns))
  {
    const unsigned int n_nodes = n_columns / 3, n = std::min(n_nodes, largest_sample);
    for (unsigned int i = 0; i < n; ++i)
      for (unsigned int c = 0; c < 3; ++c)
        sample_.push_back(3 * (i * n_nodes / n) + c);
    if (2 * reach_ + 1 < n_sectors)
      far_.assign(n_sectors - 2 * reach_ - 1,
                  Eigen::MatrixXd::Zero(sample_.size(), sample_.size()));
  }

  void ResidualSum::add(const unsigned int      harmonic,
                        const Eigen::MatrixXcd &answers,
                        const Eigen::MatrixXcd &modes)
  {
    const bool             is_end = harmonic == 0 || 2 * harmonic == n_sectors_;
    const Eigen::MatrixXcd rest   = (is_end ? 1. : 2.) / n_sectors_ * answers - modes;
    const double           angle  = harmonic * 2. * pi / n_sectors_;
    // Re(z exp(i phi)) = a cos(phi) - b sin(phi)
    for (int d = -int(reach_); d <= int(reach_); ++d)
      // Half a turn away lies one sector in both senses.
      if (2 * d != -int(n_sectors_))
        near_[d + reach_] += std::cos(d * angle) * rest.real() - std::sin(d * angle) * rest.imag();
    if (harmonic == 0)
      summed_ = n_sectors_ * rest.real();
    if (far_.empty())
      return;
    Eigen::MatrixXcd part(sample_.size(), sample_.size());
    for (std::size_t i = 0; i < sample_.size(); ++i)
      for (std::size_t k = 0; k < sample_.size(); ++k)
        part(i, k) = rest(sample_[i], sample_[k]);
    for (std::size_t k = 0; k < far_.size(); ++k)
      {
        const double phase = (reach_ + 1. + k) * angle;
        far_[k] += std::cos(phase) * part.real() - std::sin(phase) * part.imag();
      }
  }

  void ResidualSum::sum(const Communicator &communicator)
  {
    for (auto *const matrices : {&near_, &far_})
      for (Eigen::MatrixXd &matrix : *matrices)
        communicator.sum(matrix.data(), matrix.size());
    communicator.sum(summed_.data(), summed_.size());
  }

  double ResidualSum::left() const
  {
    double within = 0, beyond = 0;
    for (const Eigen::MatrixXd &matrix : near_)
      for (const int i : sample_)
        for (const int k : sample_)
          within = std::max(within, std::abs(matrix(i, k)));
    for (const Eigen::MatrixXd &matrix : far_)
      beyond = std::max(beyond, matrix.cwiseAbs().maxCoeff());
    return within > 0 ? beyond / within : 0.;
  }
} // namespace vfife
