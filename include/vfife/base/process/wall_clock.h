// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_base_process_wall_clock_h
#define vfife_base_process_wall_clock_h

#include <chrono>
#include <ctime>

namespace vfife
{
  /** Time that passes, whatever the processor does. */
  using WallClock = std::chrono::steady_clock;

  /** [s]. */
  inline double seconds_since(const WallClock::time_point start)
  {
    return std::chrono::duration<double>(WallClock::now() - start).count();
  }

  /** Processor time of this thread [s]. Unlike wall time it stops while other programs have the
   * core; their effect on caches and memory remains in it. */
  inline double processor_time()
  {
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return time.tv_sec + 1e-9 * time.tv_nsec;
  }
} // namespace vfife

#endif
