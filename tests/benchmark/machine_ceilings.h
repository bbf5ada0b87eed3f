// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_tests_benchmark_machine_ceilings_h
#define vfife_tests_benchmark_machine_ceilings_h

#include <vector>

namespace vfife
{
  /** Memory bandwidth of one core by the triad a = b + s c of the STREAM benchmark (McCalpin 1995)
   * on arrays that no cache holds. */
  class MemoryTriad
  {
  public:
    MemoryTriad();

    /** One pass: 24 bytes an entry, as STREAM counts [GB/s]. */
    double measure();

  private:
    std::vector<double> a_, b_, c_;
  };

  /**
   * Multiply-adds of one core in registers of @p lanes doubles, two flops each [GFLOP/s]: fused for
   * 4 (AVX2) and 8 (AVX-512), a product and a sum for 1 and 2. The processor must have the
   * registers.
   */
  double measure_multiply_adds(unsigned int lanes);
} // namespace vfife

#endif
