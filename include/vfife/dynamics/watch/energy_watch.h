// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_dynamics_watch_energy_watch_h
#define vfife_dynamics_watch_energy_watch_h

#include <cmath>

namespace vfife
{
  /**
   * Tells an energy error that lasts and grows from one that a start leaves: a load that is there
   * at once makes a residual of half its first step, large beside what little energy has moved
   * until then, but it does not grow.
   */
  class EnergyWatch
  {
  public:
    /** To be called at every sample: whether the error has been beyond @p limit at three samples
     * one after the other, has not fallen since the first of them, and the residual has grown by
     * half. */
    bool exceeds(const double error, const double residual, const double limit)
    {
      if (std::abs(error) < limit)
        samples_ = 0;
      else if (++samples_ == 1)
        {
          first_error_    = std::abs(error);
          first_residual_ = std::abs(residual);
        }
      return samples_ >= least_samples && std::abs(error) >= first_error_ &&
             std::abs(residual) > growth * first_residual_;
    }

  private:
    static constexpr unsigned int least_samples = 3;
    static constexpr double       growth        = 1.5;

    unsigned int samples_        = 0; ///< beyond the limit, without a break
    double       first_error_    = 0; ///< at the first of them [-]
    double       first_residual_ = 0; ///< at the first of them [mJ]
  };
} // namespace vfife

#endif
