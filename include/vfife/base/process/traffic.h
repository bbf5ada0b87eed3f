// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_base_process_traffic_h
#define vfife_base_process_traffic_h

#include <cstdint>

namespace vfife
{
  /** What one rank has given to others through a Communicator. */
  struct Traffic
  {
    std::uint64_t messages      = 0; ///< to single ranks
    std::uint64_t message_bytes = 0; ///< in these
    std::uint64_t reductions    = 0; ///< operations of all ranks: sums, maxima, gathers, broadcasts
    std::uint64_t reduction_bytes = 0; ///< that this rank has brought into these

    Traffic &operator+=(const Traffic &other)
    {
      messages += other.messages;
      message_bytes += other.message_bytes;
      reductions += other.reductions;
      reduction_bytes += other.reduction_bytes;
      return *this;
    }

    friend Traffic operator-(Traffic a, const Traffic &b)
    {
      a.messages -= b.messages;
      a.message_bytes -= b.message_bytes;
      a.reductions -= b.reductions;
      a.reduction_bytes -= b.reduction_bytes;
      return a;
    }
  };
} // namespace vfife

#endif
