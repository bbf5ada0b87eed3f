// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_source_element_kernel_constants_h
#define vfife_source_element_kernel_constants_h

#include <vfife/base/simd.h>
#include <vfife/element/kernels/kernels.h>

/**
 * How the kernels read the constants of their elements. Included by the kernel files only
 * (VFIFE_SIMD_NAMESPACE and VFIFE_KERNEL_WIDTH are set).
 */
namespace vfife
{
  inline namespace VFIFE_SIMD_NAMESPACE
  {
    constexpr unsigned int width = VFIFE_KERNEL_WIDTH;
    using V                      = Vec<double, width>;

    /** Where each group of numbers starts in the constants (see n_element_constants). */
    constexpr unsigned int start_of_gradients = 0;
    constexpr unsigned int start_of_patterns  = 21;
    constexpr unsigned int start_of_moduli    = 33;
    constexpr unsigned int start_of_hourglass = start_of_hourglass_constants;
    constexpr unsigned int start_of_triad     = start_of_hourglass + n_hourglass_constants;
    static_assert(start_of_triad + 9 == n_element_constants, "layout of write_constants()");

    /** Constants that all lanes share. */
    struct SharedConstants
    {
      const double *memory;

      VFIFE_INLINE V operator[](const unsigned int i) const
      {
        return memory[i];
      }

      VFIFE_INLINE V hourglass(const unsigned int entry) const
      {
        return memory[start_of_hourglass + entry];
      }
    };

    /** Constants lane by lane; the memory starts at the first lane wanted. */
    struct OwnConstants
    {
      const double *memory;

      VFIFE_INLINE V operator[](const unsigned int i) const
      {
        // Hardware prefetching stops at pages, and a pack has two of them.
        if constexpr (width > 1)
          __builtin_prefetch(memory + n_lanes * (n_element_constants + i));
        return V::load(memory + n_lanes * i);
      }

      VFIFE_INLINE V hourglass(const unsigned int entry) const
      {
        return (*this)[start_of_hourglass + entry];
      }
    };

    /** N numbers in single precision as doubles. */
    template <unsigned int N>
    VFIFE_INLINE Vec<double, N> load_single(const float *memory)
    {
      if constexpr (N == 1)
        return static_cast<double>(*memory);
      else
        return Vec<double, N>::of(
          __builtin_convertvector(Vec<float, N>::load(memory).v, typename Vec<double, N>::Storage));
    }

    /** OwnConstants with H in single precision. */
    struct OwnConstantsSingle
    {
      static constexpr unsigned int n_kept = n_element_constants - n_hourglass_constants;
      const double                 *memory;
      const float                  *single;

      VFIFE_INLINE V operator[](const unsigned int i) const
      {
        const unsigned int kept = i < start_of_hourglass ? i : i - n_hourglass_constants;
        if constexpr (width > 1)
          __builtin_prefetch(memory + n_lanes * (n_kept + kept));
        return V::load(memory + n_lanes * kept);
      }

      VFIFE_INLINE V hourglass(const unsigned int entry) const
      {
        // A cache line holds two rows of eight.
        const float *const at = single + n_lanes * entry;
        if (width > 1 && entry % 2 == 0)
          __builtin_prefetch(at + n_lanes * n_hourglass_constants);
        return load_single<width>(at);
      }
    };

    /** b_j(a): mean derivative of the shape function of node a = 1..7 to X_j. */
    template <typename Constants>
    VFIFE_INLINE V gradient(const Constants &constants, const unsigned int a, const unsigned int j)
    {
      return constants[start_of_gradients + 3 * (a - 1) + j];
    }

    /** sum_a h_k(a) X_j(a): what the hourglass sum k = 0..3 owes to the linear field X_j. */
    template <typename Constants>
    VFIFE_INLINE V pattern(const Constants &constants, const unsigned int k, const unsigned int j)
    {
      return constants[start_of_patterns + 3 * k + j];
    }
  } // namespace VFIFE_SIMD_NAMESPACE
} // namespace vfife

#endif
