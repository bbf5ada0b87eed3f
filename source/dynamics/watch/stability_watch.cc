// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/dynamics/watch/stability_watch.h>

namespace vfife
{
  void StabilityWatch::reset()
  {
    share_  = 0;
    growth_ = EnergyWatch();
  }

  void
  StabilityWatch::check(const double elastic, const double round_off, const std::string &instant)
  {
    // Where nothing moves, round-off alternates.
    share_ = alternating_energy_ > round_off ? alternating_energy_ / elastic : 0;
    if (growth_.exceeds(share_, alternating_energy_, 1.))
      throw NumericalError(
        "time step unstable " + instant +
        ": a motion that alternates from step to step grows. Reduce Dynamics/time step factor");
  }
} // namespace vfife
