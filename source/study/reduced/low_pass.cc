// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/types.h>
#include <vfife/study/reduced/low_pass.h>

#include <cmath>
#include <utility>

namespace vfife
{
  namespace
  {
    /** Periods of the frequency on each side. */
    constexpr double n_periods = 3;
  } // namespace

  LowPass::LowPass(const double frequency)
    : weights_{1}
  {
    if (frequency >= .5)
      return;
    const auto reach = static_cast<unsigned int>(std::ceil(n_periods / frequency));
    weights_.front() = 2. * frequency;
    double sum       = weights_.front();
    for (unsigned int k = 1; k <= reach; ++k)
      {
        const double window = .5 * (1. + std::cos(pi * k / (reach + 1.)));
        weights_.push_back(window * std::sin(2. * pi * frequency * k) / (pi * k));
        sum += 2. * weights_.back();
      }
    for (double &weight : weights_)
      weight /= sum;
  }

  std::optional<Eigen::VectorXd> LowPass::add(Eigen::VectorXd sample)
  {
    samples_.push_back(std::move(sample));
    if (samples_.size() < 2 * reach() + 1)
      return std::nullopt;
    Eigen::VectorXd left = weights_[0] * samples_[reach()];
    for (unsigned int k = 1; k <= reach(); ++k)
      left += weights_[k] * (samples_[reach() - k] + samples_[reach() + k]);
    samples_.pop_front();
    return left;
  }
} // namespace vfife
