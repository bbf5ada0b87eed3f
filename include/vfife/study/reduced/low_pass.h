// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_study_reduced_low_pass_h
#define vfife_study_reduced_low_pass_h

#include <Eigen/Core>

#include <deque>
#include <optional>
#include <vector>

namespace vfife
{
  /**
   * Samples at equal times without what vibrates above a frequency, none of them later: a mean over
   * reach() samples on both sides with the weights of the ideal low pass under Hann's window
   * (Oppenheim and Schafer, Discrete-Time Signal Processing, 3rd ed., 7.5). Half of what has the
   * frequency is left, less than 1 % beyond 1.4 of it, and less than 1 % of what has 0.6 of it is
   * lost; straight lines pass as they are.
   */
  class LowPass
  {
  public:
    /** @p frequency: in periods of it a sample, above 0; all passes from 1/2 on. */
    explicit LowPass(double frequency);

    unsigned int reach() const
    {
      return weights_.size() - 1;
    }

    /** What is left of the sample reach() before @p sample, once there are so many before that. */
    std::optional<Eigen::VectorXd> add(Eigen::VectorXd sample);

  private:
    std::vector<double>         weights_; ///< by distance
    std::deque<Eigen::VectorXd> samples_;
  };
} // namespace vfife

#endif
