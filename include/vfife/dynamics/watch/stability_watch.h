// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_dynamics_watch_stability_watch_h
#define vfife_dynamics_watch_stability_watch_h

#include <vfife/dynamics/watch/energy_watch.h>

#include <string>

namespace vfife
{
  /** Watches runs with a step beyond that of the worst element, which are stable where the bodies
   * are: it finds a motion that alternates from step to step and grows. */
  class StabilityWatch
  {
  public:
    /** Sets the step that is stable by the worst element [s]. */
    void set_safe_step(const double step)
    {
      safe_step_ = step;
    }

    /** Whether a step [s] may be too long for the bodies. */
    bool may_be_unstable(const double step) const
    {
      return step > safe_step_ * (1. + 1e-9);
    }

    /** Forgets the samples so far. */
    void reset();

    /** Takes MotionSums::alternating_energy of a sample [mJ]. */
    void observe(const double alternating_energy)
    {
      alternating_energy_ = alternating_energy;
    }

    /** Compares the last sample with its @p elastic energy and the @p round_off of the steps [mJ].
     * Throws NumericalError for an alternating energy that exceeds both and grows. @p instant: time
     * and step, in words. */
    void check(double elastic, double round_off, const std::string &instant);

    /** Alternating over elastic energy at the last check(): 1 and more where a mode grows. */
    double alternating_share() const
    {
      return share_;
    }

  private:
    double      safe_step_          = 0; ///< [s]
    double      alternating_energy_ = 0; ///< [mJ]
    double      share_              = 0;
    EnergyWatch growth_;
  };
} // namespace vfife

#endif
