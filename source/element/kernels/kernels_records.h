// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_source_element_kernel_records_h
#define vfife_source_element_kernel_records_h

#include <vfife/base/simd.h>
#include <vfife/element/kernels/kernels.h>

/**
 * Between node records [x y z *] in memory and one vector a component, a lane an element:
 * transposing loads and adds. Included by the kernel files only (VFIFE_SIMD_NAMESPACE is set).
 */
namespace vfife
{
  inline namespace VFIFE_SIMD_NAMESPACE
  {
    using Record = Vec<double, 4>;

    /** The x, y, z of the nodes of N lanes. */
    template <unsigned int N>
    VFIFE_INLINE void
    load_records(const double *records, const std::uint32_t *nodes, Vec<double, N> (&xyz)[3])
    {
      const auto address = [&](const unsigned int lane) {
        return records + 4 * static_cast<std::size_t>(nodes[lane]);
      };
      if constexpr (N == 1)
        {
          for (unsigned int i = 0; i < 3; ++i)
            xyz[i] = address(0)[i];
        }
      else if constexpr (N == 2)
        {
          const auto first  = Vec<double, 2>::load(address(0)).v;
          const auto second = Vec<double, 2>::load(address(1)).v;
          xyz[0].v          = __builtin_shufflevector(first, second, 0, 2);
          xyz[1].v          = __builtin_shufflevector(first, second, 1, 3);
          xyz[2].v          = typename Vec<double, 2>::Storage{address(0)[2], address(1)[2]};
        }
      else if constexpr (N == 4)
        {
          // A 4 x 4 transpose without its last row: first pairs of lanes
          // [x x z z] and [y y * *], then halves.
          const auto row = [&](const unsigned int lane) { return Record::load(address(lane)).v; };
          const auto r0 = row(0), r1 = row(1), r2 = row(2), r3 = row(3);
          const auto xz01 = __builtin_shufflevector(r0, r1, 0, 4, 2, 6);
          const auto xz23 = __builtin_shufflevector(r2, r3, 0, 4, 2, 6);
          const auto y01  = __builtin_shufflevector(r0, r1, 1, 5, 3, 7);
          const auto y23  = __builtin_shufflevector(r2, r3, 1, 5, 3, 7);
          xyz[0].v        = __builtin_shufflevector(xz01, xz23, 0, 1, 4, 5);
          xyz[1].v        = __builtin_shufflevector(y01, y23, 0, 1, 4, 5);
          xyz[2].v        = __builtin_shufflevector(xz01, xz23, 2, 3, 6, 7);
        }
      else
        {
          static_assert(N == 8, "1, 2, 4 or 8 lanes");
          // Lanes l and l + 4 share a register, each half is transposed by itself.
          const auto pair = [&](const unsigned int lane) {
            return __builtin_shufflevector(Record::load(address(lane)).v,
                                           Record::load(address(lane + 4)).v,
                                           0,
                                           1,
                                           2,
                                           3,
                                           4,
                                           5,
                                           6,
                                           7);
          };
          const auto r0 = pair(0), r1 = pair(1), r2 = pair(2), r3 = pair(3);
          const auto xz01 = __builtin_shufflevector(r0, r1, 0, 8, 2, 10, 4, 12, 6, 14);
          const auto xz23 = __builtin_shufflevector(r2, r3, 0, 8, 2, 10, 4, 12, 6, 14);
          const auto y01  = __builtin_shufflevector(r0, r1, 1, 9, 3, 11, 5, 13, 7, 15);
          const auto y23  = __builtin_shufflevector(r2, r3, 1, 9, 3, 11, 5, 13, 7, 15);
          xyz[0].v        = __builtin_shufflevector(xz01, xz23, 0, 1, 8, 9, 4, 5, 12, 13);
          xyz[1].v        = __builtin_shufflevector(y01, y23, 0, 1, 8, 9, 4, 5, 12, 13);
          xyz[2].v        = __builtin_shufflevector(xz01, xz23, 2, 3, 10, 11, 6, 7, 14, 15);
        }
    }

    /** One lane after the other, since lanes may share a node. */
    template <unsigned int N>
    VFIFE_INLINE void subtract_from_records(double              *records,
                                            const std::uint32_t *nodes,
                                            const Vec<double, N> (&xyz)[3])
    {
      const auto subtract = [&](const unsigned int lane, const auto &row) {
        double *address = records + 4 * static_cast<std::size_t>(nodes[lane]);
        (Record::load(address) - Record::of(row)).store(address);
      };
      if constexpr (N <= 2)
        {
          double component[3][N];
          for (unsigned int i = 0; i < 3; ++i)
            xyz[i].store(component[i]);
          for (unsigned int lane = 0; lane < N; ++lane)
            for (unsigned int i = 0; i < 3; ++i)
              records[4 * static_cast<std::size_t>(nodes[lane]) + i] -= component[i][lane];
        }
      else if constexpr (N == 4)
        {
          // The transpose back; from the fourth number of a record zero is subtracted.
          const typename Vec<double, 4>::Storage zero{};
          const auto                             x = xyz[0].v, y = xyz[1].v, z = xyz[2].v;
          const auto                             xy02 = __builtin_shufflevector(x, y, 0, 4, 2, 6);
          const auto                             xy13 = __builtin_shufflevector(x, y, 1, 5, 3, 7);
          const auto                             z02 = __builtin_shufflevector(z, zero, 0, 4, 2, 6);
          const auto                             z13 = __builtin_shufflevector(z, zero, 1, 5, 3, 7);
          subtract(0, __builtin_shufflevector(xy02, z02, 0, 1, 4, 5));
          subtract(1, __builtin_shufflevector(xy13, z13, 0, 1, 4, 5));
          subtract(2, __builtin_shufflevector(xy02, z02, 2, 3, 6, 7));
          subtract(3, __builtin_shufflevector(xy13, z13, 2, 3, 6, 7));
        }
      else
        {
          const typename Vec<double, 8>::Storage zero{};
          const auto                             x = xyz[0].v, y = xyz[1].v, z = xyz[2].v;
          const auto xy02 = __builtin_shufflevector(x, y, 0, 8, 2, 10, 4, 12, 6, 14);
          const auto xy13 = __builtin_shufflevector(x, y, 1, 9, 3, 11, 5, 13, 7, 15);
          const auto z02  = __builtin_shufflevector(z, zero, 0, 8, 2, 10, 4, 12, 6, 14);
          const auto z13  = __builtin_shufflevector(z, zero, 1, 9, 3, 11, 5, 13, 7, 15);
          const auto r04  = __builtin_shufflevector(xy02, z02, 0, 1, 8, 9, 4, 5, 12, 13);
          const auto r15  = __builtin_shufflevector(xy13, z13, 0, 1, 8, 9, 4, 5, 12, 13);
          const auto r26  = __builtin_shufflevector(xy02, z02, 2, 3, 10, 11, 6, 7, 14, 15);
          const auto r37  = __builtin_shufflevector(xy13, z13, 2, 3, 10, 11, 6, 7, 14, 15);
          subtract(0, __builtin_shufflevector(r04, r04, 0, 1, 2, 3));
          subtract(1, __builtin_shufflevector(r15, r15, 0, 1, 2, 3));
          subtract(2, __builtin_shufflevector(r26, r26, 0, 1, 2, 3));
          subtract(3, __builtin_shufflevector(r37, r37, 0, 1, 2, 3));
          subtract(4, __builtin_shufflevector(r04, r04, 4, 5, 6, 7));
          subtract(5, __builtin_shufflevector(r15, r15, 4, 5, 6, 7));
          subtract(6, __builtin_shufflevector(r26, r26, 4, 5, 6, 7));
          subtract(7, __builtin_shufflevector(r37, r37, 4, 5, 6, 7));
        }
    }
  } // namespace VFIFE_SIMD_NAMESPACE
} // namespace vfife

#endif
