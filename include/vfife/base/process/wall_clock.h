// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_base_process_wall_clock_h
#define vfife_base_process_wall_clock_h

#include <chrono>

namespace vfife
{
  /** Time that passes, whatever the processor does. */
  using WallClock = std::chrono::steady_clock;

  /** [s]. */
  inline double seconds_since(const WallClock::time_point start)
  {
    return std::chrono::duration<double>(WallClock::now() - start).count();
  }
} // namespace vfife

#endif
