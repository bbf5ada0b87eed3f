// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_source_element_kernel_frames_h
#define vfife_source_element_kernel_frames_h

#include <vfife/base/simd.h>

/**
 * The two frames of the kernels. Included by the kernel files only (VFIFE_SIMD_NAMESPACE is set).
 */
namespace vfife
{
  inline namespace VFIFE_SIMD_NAMESPACE
  {
    /** Rotation and strain of an element; symmetric matrices as xx yy zz xy yz zx. */
    template <unsigned int N>
    struct Frame
    {
      Vec<double, N> R[3][3];
      Vec<double, N> strain[6]; ///< sym(R^T F) - I
    };

    /** F = R U of one lane, row by row: R, and U - I as xx yy zz xy yz zx. Left as they are where
     * det F is not positive: an empty lane, or an element inside out. */
    inline __attribute__((noinline)) void
    compute_polar_lane(const double (&F)[9], double (&R)[9], double (&strain)[6])
    {
      double X[9], cofactor[9];
      for (unsigned int i = 0; i < 9; ++i)
        X[i] = F[i];
      // Newton's method for the orthogonal factor, X <- (X + X^-T)/2 (Higham 1986): quadratic from
      // any F with det F > 0; twenty steps are enough for stretches of 1e-4 to 1e4.
      for (unsigned int iteration = 0; iteration < 20; ++iteration)
        {
          for (unsigned int i = 0; i < 3; ++i)
            for (unsigned int j = 0; j < 3; ++j)
              cofactor[3 * i + j] =
                X[3 * ((i + 1) % 3) + (j + 1) % 3] * X[3 * ((i + 2) % 3) + (j + 2) % 3] -
                X[3 * ((i + 1) % 3) + (j + 2) % 3] * X[3 * ((i + 2) % 3) + (j + 1) % 3];
          const double determinant = X[0] * cofactor[0] + X[1] * cofactor[1] + X[2] * cofactor[2];
          if (!(determinant > 0.))
            return;
          double change = 0.;
          for (unsigned int i = 0; i < 9; ++i)
            {
              const double next = 0.5 * (X[i] + cofactor[i] / determinant);
              change += (next - X[i]) * (next - X[i]);
              X[i] = next;
            }
          if (change < 1e-20) // quadratic: the next change would be below 1e-20
            break;
        }
      for (unsigned int i = 0; i < 9; ++i)
        R[i] = X[i];
      for (unsigned int i = 0; i < 3; ++i)
        {
          const unsigned int next    = (i + 1) % 3;
          const auto         product = [&](const unsigned int a, const unsigned int b) {
            return X[a] * F[b] + X[3 + a] * F[3 + b] + X[6 + a] * F[6 + b];
          };
          strain[i]     = product(i, i) - 1.;
          strain[3 + i] = 0.5 * (product(i, next) + product(next, i));
        }
    }

    /** Replaces what the series gave by the exact rotation and strain, lane by lane. */
    template <unsigned int N>
    __attribute__((noinline)) void compute_exact_polar_frame(const Vec<double, N> (&F)[3][3],
                                                             Frame<N> &frame)
    {
      double F_lanes[9][N], R_lanes[9][N], strain_lanes[6][N];
      for (unsigned int i = 0; i < 9; ++i)
        {
          F[i / 3][i % 3].store(F_lanes[i]);
          frame.R[i / 3][i % 3].store(R_lanes[i]);
        }
      for (unsigned int i = 0; i < 6; ++i)
        frame.strain[i].store(strain_lanes[i]);
      for (unsigned int lane = 0; lane < N; ++lane)
        {
          double F_lane[9], R_lane[9], strain_lane[6];
          for (unsigned int i = 0; i < 9; ++i)
            {
              F_lane[i] = F_lanes[i][lane];
              R_lane[i] = R_lanes[i][lane];
            }
          for (unsigned int i = 0; i < 6; ++i)
            strain_lane[i] = strain_lanes[i][lane];
          compute_polar_lane(F_lane, R_lane, strain_lane);
          for (unsigned int i = 0; i < 9; ++i)
            R_lanes[i][lane] = R_lane[i];
          for (unsigned int i = 0; i < 6; ++i)
            strain_lanes[i][lane] = strain_lane[i];
        }
      for (unsigned int i = 0; i < 9; ++i)
        frame.R[i / 3][i % 3] = Vec<double, N>::load(R_lanes[i]);
      for (unsigned int i = 0; i < 6; ++i)
        frame.strain[i] = Vec<double, N>::load(strain_lanes[i]);
    }

    /**
     * F = R U with E = (F^T F - I) / 2: U^-1 = (I + 2 E)^-1/2 by its series to the eighth power.
     * Powers above the second are folded back by Cayley and Hamilton, E^3 = I1 E^2 - I2 E + I3, so
     * a power costs three multiplications and there is no division, square root or iteration. First
     * term left out: 95 E^9, below 3e-12 of the strain up to |E| = 1/50; beyond, the pack is
     * computed exactly.
     */
    template <unsigned int N>
    VFIFE_INLINE Frame<N> compute_polar_frame(const Vec<double, N> (&F)[3][3])
    {
      using V = Vec<double, N>;

      const auto product = [&F](const unsigned int i, const unsigned int j) {
        return F[0][i] * F[0][j] + F[1][i] * F[1][j] + F[2][i] * F[2][j];
      };
      const V xx = 0.5 * (product(0, 0) - 1.), yy = 0.5 * (product(1, 1) - 1.),
              zz = 0.5 * (product(2, 2) - 1.);
      const V xy = 0.5 * product(0, 1), yz = 0.5 * product(1, 2), zx = 0.5 * product(2, 0);
      const V E[6]  = {xx, yy, zz, xy, yz, zx};
      const V E2[6] = {xx * xx + xy * xy + zx * zx,
                       xy * xy + yy * yy + yz * yz,
                       zx * zx + yz * yz + zz * zz,
                       xx * xy + xy * yy + zx * yz,
                       xy * zx + yy * yz + yz * zz,
                       xx * zx + xy * yz + zx * zz};

      // I1, I2, I3: trace, sum of principal minors and determinant of E.
      const V minor_x = yy * zz - yz * yz, minor_xy = yz * zx - xy * zz,
              minor_zx = xy * yz - yy * zx;
      const V I1       = xx + yy + zz;
      const V I2       = minor_x + (xx * zz - zx * zx) + (xx * yy - xy * xy);
      const V I3       = xx * minor_x + xy * minor_xy + zx * minor_zx;

      // p = p0 + p1 E + p2 E^2, Horner's scheme for (I + 2 E)^-1/2 - I = sum_n c_n E^n: begins with
      // c_6, c_7, c_8, each further step is p <- E p + c_n.
      V          p0 = 231. / 16., p1 = -429. / 16., p2 = 6435. / 128.;
      const auto multiply_and_add = [&](const double coefficient) {
        const V q0 = p2 * I3 + coefficient;
        const V q1 = p0 - p2 * I2;
        const V q2 = p1 + p2 * I1;
        p0         = q0;
        p1         = q1;
        p2         = q2;
      };
      multiply_and_add(-63. / 8.);
      multiply_and_add(35. / 8.);
      multiply_and_add(-5. / 2.);
      multiply_and_add(3. / 2.);
      multiply_and_add(-1.);
      multiply_and_add(0.);

      // U - I = (I + 2 E)(I + p) - I without the difference of large numbers.
      const V s0 = p0 + 2. * (p2 * I3);
      const V s1 = p1 + 2. * (1. + p0 - p2 * I2);
      const V s2 = p2 + 2. * (p1 + p2 * I1);

      V        stretch_inverse[6];
      Frame<N> frame;
      for (unsigned int i = 0; i < 6; ++i)
        {
          stretch_inverse[i] = p1 * E[i] + p2 * E2[i];
          frame.strain[i]    = s1 * E[i] + s2 * E2[i];
        }
      for (unsigned int i = 0; i < 3; ++i)
        {
          stretch_inverse[i] += 1. + p0;
          frame.strain[i] += s0;
        }
      const V(&S)[6] = stretch_inverse;
      for (unsigned int i = 0; i < 3; ++i)
        {
          frame.R[i][0] = F[i][0] * S[0] + F[i][1] * S[3] + F[i][2] * S[5];
          frame.R[i][1] = F[i][0] * S[3] + F[i][1] * S[1] + F[i][2] * S[4];
          frame.R[i][2] = F[i][0] * S[5] + F[i][1] * S[4] + F[i][2] * S[2];
        }
      // Empty lanes have F = 0 and E = -I/2: they must not send their pack to the exact frame.
      constexpr double largest = 0.02;
      const V          size = E2[0] + E2[1] + E2[2], trace = 3. + 2. * I1; // of E^2 and F^T F
      if (__builtin_expect(any_above(size, V(largest * largest), trace, V(1e-12)), 0))
        compute_exact_polar_frame<N>(F, frame);
      return frame;
    }

    template <unsigned int N>
    VFIFE_INLINE Vec<double, N> inverse_square_root(const Vec<double, N> &value)
    {
      double lane[N];
      value.store(lane);
      // Empty lanes have sides of length zero: they get 0, not infinity.
      for (unsigned int l = 0; l < N; ++l)
        lane[l] = lane[l] > 0. ? 1. / __builtin_sqrt(lane[l]) : 0.;
      return Vec<double, N>::load(lane);
    }

    /**
     * Rotation between the triads of nodes a, b, d, given the sides a-b and a-d [mm] and the triad
     * of the reference (entry (i, j) by @p triad(i, j), columns are axes).
     */
    template <unsigned int N, typename Triad>
    VFIFE_INLINE Frame<N> compute_three_node_frame(const Vec<double, N> (&F)[3][3],
                                                   const Vec<double, N> (&ab)[3],
                                                   const Vec<double, N> (&ad)[3],
                                                   const Triad &triad)
    {
      using V = Vec<double, N>;

      // The present triad: e1 along a-b, e3 normal to a-b-d, e2 = e3 x e1.
      V axis[3][3]; // [axis][component]
      V normal[3];
      for (unsigned int i = 0; i < 3; ++i)
        normal[i] = ab[(i + 1) % 3] * ad[(i + 2) % 3] - ab[(i + 2) % 3] * ad[(i + 1) % 3];
      const V side_scale   = inverse_square_root<N>(ab[0] * ab[0] + ab[1] * ab[1] + ab[2] * ab[2]);
      const V normal_scale = inverse_square_root<N>(normal[0] * normal[0] + normal[1] * normal[1] +
                                                    normal[2] * normal[2]);
      for (unsigned int i = 0; i < 3; ++i)
        {
          axis[0][i] = ab[i] * side_scale;
          axis[2][i] = normal[i] * normal_scale;
        }
      for (unsigned int i = 0; i < 3; ++i)
        axis[1][i] =
          axis[2][(i + 1) % 3] * axis[0][(i + 2) % 3] - axis[2][(i + 2) % 3] * axis[0][(i + 1) % 3];

      // R = triad(x) triad(X)^T, then the strain sym(R^T F) - I.
      Frame<N> frame;
      for (unsigned int i = 0; i < 3; ++i)
        for (unsigned int j = 0; j < 3; ++j)
          frame.R[i][j] =
            axis[0][i] * triad(j, 0) + axis[1][i] * triad(j, 1) + axis[2][i] * triad(j, 2);

      const auto product = [&](const unsigned int i, const unsigned int j) {
        return frame.R[0][i] * F[0][j] + frame.R[1][i] * F[1][j] + frame.R[2][i] * F[2][j];
      };
      for (unsigned int i = 0; i < 3; ++i)
        {
          const unsigned int next = (i + 1) % 3;
          frame.strain[i]         = product(i, i) - 1.;
          frame.strain[3 + i]     = 0.5 * (product(i, next) + product(next, i));
        }
      return frame;
    }
  } // namespace VFIFE_SIMD_NAMESPACE
} // namespace vfife

#endif
