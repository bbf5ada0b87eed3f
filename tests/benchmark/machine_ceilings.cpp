// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include "machine_ceilings.h"

#include <vfife/base/process/wall_clock.h>

#include <algorithm>
#include <cstddef>
#include <cstring>

#ifdef __x86_64__
#  define VFIFE_TARGET(set) __attribute__((target(set)))
#else
#  define VFIFE_TARGET(set)
#endif

namespace vfife
{
  namespace
  {
    constexpr std::size_t  triad_length   = std::size_t(1) << 23; // 64 MiB an array
    constexpr unsigned int n_rounds       = 400000;
    constexpr unsigned int n_chains       = 12; // more than latency times throughput of any core
    constexpr unsigned int n_measurements = 3;

    /** Processor time of the loop [s]. */
    template <typename Loop>
    double seconds(const Loop &loop)
    {
      const double start = processor_time();
      loop();
      return processor_time() - start;
    }

    /** What the loops leave behind, so that they are not optimized away. */
    volatile double kept = 0.;

    // x <- f x + f in independent chains; f just below 1 keeps the numbers between 0 and 1e6, so
    // none is slow for being denormal or infinite. The same loop for each register, as a macro:
    // target attributes are not inherited by templates that a function calls.
#define VFIFE_MULTIPLY_ADD_LOOP(name, lanes_attribute, target)                                     \
  target void name()                                                                               \
  {                                                                                                \
    typedef double Register lanes_attribute;                                                       \
    const Register          factor      = 0.999999 - Register{};                                   \
    Register                x[n_chains] = {};                                                      \
    for (unsigned int round = 0; round < n_rounds; ++round)                                        \
      _Pragma("GCC unroll 12") for (unsigned int u = 0; u < n_chains; ++u) x[u] =                  \
        x[u] * factor + factor;                                                                    \
    for (unsigned int u = 1; u < n_chains; ++u)                                                    \
      x[0] += x[u];                                                                                \
    double first;                                                                                  \
    std::memcpy(&first, &x[0], sizeof(first));                                                     \
    kept = first;                                                                                  \
  }

    VFIFE_MULTIPLY_ADD_LOOP(multiply_add_1, , )
    VFIFE_MULTIPLY_ADD_LOOP(multiply_add_2, __attribute__((vector_size(16))), )
    VFIFE_MULTIPLY_ADD_LOOP(multiply_add_4,
                            __attribute__((vector_size(32))),
                            VFIFE_TARGET("avx2,fma"))
    VFIFE_MULTIPLY_ADD_LOOP(multiply_add_8,
                            __attribute__((vector_size(64))),
                            VFIFE_TARGET("avx512f"))
#undef VFIFE_MULTIPLY_ADD_LOOP
  } // namespace

  MemoryTriad::MemoryTriad()
    : a_(triad_length, 0.)
    , b_(triad_length, 1.)
    , c_(triad_length, 2.)
  {
  }

  double MemoryTriad::measure()
  {
    const double time = seconds([this] {
      double *const __restrict a       = a_.data();
      const double *const __restrict b = b_.data(), *const __restrict c = c_.data();
      for (std::size_t i = 0; i < triad_length; ++i)
        a[i] = b[i] + 3. * c[i];
    });
    kept              = a_[triad_length / 2];
    // Bytes of two loads and a store of 8 bytes each, in GB/s; what a store reads before is not
    // counted.
    return 24e-9 * triad_length / time;
  }

  double measure_multiply_adds(const unsigned int lanes)
  {
    // A width that the machine lacks must not be asked for: its instructions would end the program.
    const auto loop = lanes == 8   ? &multiply_add_8
                      : lanes == 4 ? &multiply_add_4
                      : lanes == 2 ? &multiply_add_2
                                   : &multiply_add_1;
    // The best of some: other programs only ever make it slower.
    double time = seconds(loop);
    for (unsigned int i = 1; i < n_measurements; ++i)
      time = std::min(time, seconds(loop));
    // A multiplication and an addition each, in Gflop/s.
    return 2e-9 * n_rounds * n_chains * lanes / time;
  }
} // namespace vfife
