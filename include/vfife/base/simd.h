// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_base_simd_h
#define vfife_base_simd_h

/**
 * A file compiled for one instruction set names it before it includes this header, so that inline
 * code of two sets never shares a symbol (the linker would keep one of them, possibly one that this
 * processor cannot run).
 */
#ifndef VFIFE_SIMD_NAMESPACE
#  define VFIFE_SIMD_NAMESPACE simd_default
#endif

#define VFIFE_INLINE inline __attribute__((always_inline))

namespace vfife
{
  inline namespace VFIFE_SIMD_NAMESPACE
  {
    /** What holds N numbers side by side: a vector of the compiler, or the plain number for N = 1.
     */
    template <typename T, unsigned int N>
    struct VecStorage
    {
      typedef T type __attribute__((vector_size(N * sizeof(T))));
    };

    template <typename T>
    struct VecStorage<T, 1>
    {
      typedef T type;
    };

    /**
     * N numbers computed with at once. N must be 1 or fit a register of the instruction set
     * compiled for: wider ones work but are slower than plain numbers.
     */
    template <typename T, unsigned int N>
    struct Vec
    {
      using Storage                      = typename VecStorage<T, N>::type;
      static constexpr unsigned int size = N;

      Storage v;

      VFIFE_INLINE Vec() = default;

      VFIFE_INLINE Vec(const T scalar)
        : v(scalar - Storage{})
      {
      }

      VFIFE_INLINE static Vec of(const Storage &storage)
      {
        Vec result;
        result.v = storage;
        return result;
      }

      /** N numbers from memory of any alignment. */
      VFIFE_INLINE static Vec load(const T *memory)
      {
        Vec result;
        __builtin_memcpy(&result.v, memory, sizeof(Storage));
        return result;
      }

      VFIFE_INLINE void store(T *memory) const
      {
        __builtin_memcpy(memory, &v, sizeof(Storage));
      }

      VFIFE_INLINE Vec &operator+=(const Vec &other)
      {
        v += other.v;
        return *this;
      }

      VFIFE_INLINE Vec &operator-=(const Vec &other)
      {
        v -= other.v;
        return *this;
      }

      VFIFE_INLINE Vec &operator*=(const Vec &other)
      {
        v *= other.v;
        return *this;
      }

      // Friends, so that plain numbers on either side are spread over all lanes.
      VFIFE_INLINE friend Vec operator+(const Vec &a, const Vec &b)
      {
        return of(a.v + b.v);
      }

      VFIFE_INLINE friend Vec operator-(const Vec &a, const Vec &b)
      {
        return of(a.v - b.v);
      }

      VFIFE_INLINE friend Vec operator*(const Vec &a, const Vec &b)
      {
        return of(a.v * b.v);
      }

      VFIFE_INLINE friend Vec operator/(const Vec &a, const Vec &b)
      {
        return of(a.v / b.v);
      }

      VFIFE_INLINE friend Vec operator-(const Vec &a)
      {
        return of(-a.v);
      }

      /** The smaller one, lane by lane. */
      VFIFE_INLINE friend Vec min(const Vec &a, const Vec &b)
      {
        return of(a.v < b.v ? a.v : b.v);
      }

      /** Whether there is a lane with @p a above @p b and @p c above @p d. */
      VFIFE_INLINE friend bool any_above(const Vec &a, const Vec &b, const Vec &c, const Vec &d)
      {
        if constexpr (N == 1)
          return a.v > b.v && c.v > d.v;
        else
          {
            // Bytes of -1 and 0: all lanes fit one plain number.
            typedef signed char Bytes __attribute__((vector_size(N)));
            const Bytes         bytes = __builtin_convertvector((a.v > b.v) & (c.v > d.v), Bytes);
            unsigned long long  word  = 0;
            static_assert(sizeof(bytes) <= sizeof(word), "at most eight lanes");
            __builtin_memcpy(&word, &bytes, sizeof(bytes));
            return word != 0;
          }
      }
    };
  } // namespace VFIFE_SIMD_NAMESPACE
} // namespace vfife

#endif
