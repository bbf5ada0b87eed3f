// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
/**
 * Central differences on vectors of VFIFE_KERNEL_WIDTH nodes, included once by each file compiled
 * for an instruction set. Formulas: nodal_update.h.
 */
#include <vfife/base/simd.h>
#include <vfife/dynamics/motion/update_kernels.h>

namespace vfife
{
  inline namespace VFIFE_SIMD_NAMESPACE
  {
    /**
     * Records of N nodes, one vector a component. Eight nodes stand in the order of
     * update_lane_node(). For four:
     *
     *   r0 = x0 y0 z0 w0             x0 x1 x2 x3 = c[0]
     *   r1 = x1 y1 z1 w1   becomes   y0 y1 y2 y3 = c[1]
     *   r2 = x2 y2 z2 w2             z0 z1 z2 z3 = c[2]
     *   r3 = x3 y3 z3 w3             w0 w1 w2 w3 = c[3]
     *
     * by two rounds of shuffles; for eight a row r holds two nodes, and whole halves are moved.
     */
    template <unsigned int N>
    VFIFE_INLINE void load_nodes(const double *records, Vec<double, N> (&c)[4])
    {
      if constexpr (N == 1)
        for (unsigned int i = 0; i < 4; ++i)
          c[i] = records[i];
      else
        {
          using Row     = Vec<double, N>;
          const auto r0 = Row::load(records).v, r1 = Row::load(records + N).v,
                     r2 = Row::load(records + 2 * N).v, r3 = Row::load(records + 3 * N).v;
          if constexpr (N == 4)
            {
              const auto xz01 = __builtin_shufflevector(r0, r1, 0, 4, 2, 6);
              const auto xz23 = __builtin_shufflevector(r2, r3, 0, 4, 2, 6);
              const auto yw01 = __builtin_shufflevector(r0, r1, 1, 5, 3, 7);
              const auto yw23 = __builtin_shufflevector(r2, r3, 1, 5, 3, 7);
              c[0].v          = __builtin_shufflevector(xz01, xz23, 0, 1, 4, 5);
              c[1].v          = __builtin_shufflevector(yw01, yw23, 0, 1, 4, 5);
              c[2].v          = __builtin_shufflevector(xz01, xz23, 2, 3, 6, 7);
              c[3].v          = __builtin_shufflevector(yw01, yw23, 2, 3, 6, 7);
            }
          else
            {
              static_assert(N == 8, "1, 4 or 8 nodes");
              const auto xy03 = __builtin_shufflevector(r0, r1, 0, 8, 4, 12, 1, 9, 5, 13);
              const auto zw03 = __builtin_shufflevector(r0, r1, 2, 10, 6, 14, 3, 11, 7, 15);
              const auto xy47 = __builtin_shufflevector(r2, r3, 0, 8, 4, 12, 1, 9, 5, 13);
              const auto zw47 = __builtin_shufflevector(r2, r3, 2, 10, 6, 14, 3, 11, 7, 15);
              c[0].v          = __builtin_shufflevector(xy03, xy47, 0, 1, 2, 3, 8, 9, 10, 11);
              c[1].v          = __builtin_shufflevector(xy03, xy47, 4, 5, 6, 7, 12, 13, 14, 15);
              c[2].v          = __builtin_shufflevector(zw03, zw47, 0, 1, 2, 3, 8, 9, 10, 11);
              c[3].v          = __builtin_shufflevector(zw03, zw47, 4, 5, 6, 7, 12, 13, 14, 15);
            }
        }
    }

    /** The node that stands in a lane after load_nodes(). */
    template <unsigned int N>
    constexpr unsigned int update_lane_node(const unsigned int lane)
    {
      return N == 8 ? (lane & 4) + 2 * (lane & 1) + (lane >> 1 & 1) : lane;
    }

    /** The inverse of load_nodes(). */
    template <unsigned int N>
    VFIFE_INLINE void store_nodes(const Vec<double, N> (&c)[4], double *records)
    {
      if constexpr (N == 1)
        for (unsigned int i = 0; i < 4; ++i)
          records[i] = c[i].v;
      else
        {
          using Row                    = Vec<double, N>;
          typename Row::Storage row[4] = {};
          if constexpr (N == 4)
            {
              const auto xy02 = __builtin_shufflevector(c[0].v, c[1].v, 0, 4, 2, 6);
              const auto xy13 = __builtin_shufflevector(c[0].v, c[1].v, 1, 5, 3, 7);
              const auto zw02 = __builtin_shufflevector(c[2].v, c[3].v, 0, 4, 2, 6);
              const auto zw13 = __builtin_shufflevector(c[2].v, c[3].v, 1, 5, 3, 7);
              row[0]          = __builtin_shufflevector(xy02, zw02, 0, 1, 4, 5);
              row[1]          = __builtin_shufflevector(xy13, zw13, 0, 1, 4, 5);
              row[2]          = __builtin_shufflevector(xy02, zw02, 2, 3, 6, 7);
              row[3]          = __builtin_shufflevector(xy13, zw13, 2, 3, 6, 7);
            }
          else
            {
              const auto xy03 = __builtin_shufflevector(c[0].v, c[1].v, 0, 1, 2, 3, 8, 9, 10, 11);
              const auto zw03 = __builtin_shufflevector(c[2].v, c[3].v, 0, 1, 2, 3, 8, 9, 10, 11);
              const auto xy47 = __builtin_shufflevector(c[0].v, c[1].v, 4, 5, 6, 7, 12, 13, 14, 15);
              const auto zw47 = __builtin_shufflevector(c[2].v, c[3].v, 4, 5, 6, 7, 12, 13, 14, 15);
              row[0]          = __builtin_shufflevector(xy03, zw03, 0, 4, 8, 12, 2, 6, 10, 14);
              row[1]          = __builtin_shufflevector(xy03, zw03, 1, 5, 9, 13, 3, 7, 11, 15);
              row[2]          = __builtin_shufflevector(xy47, zw47, 0, 4, 8, 12, 2, 6, 10, 14);
              row[3]          = __builtin_shufflevector(xy47, zw47, 1, 5, 9, 13, 3, 7, 11, 15);
            }
          for (unsigned int i = 0; i < 4; ++i)
            Row::of(row[i]).store(records + N * i);
        }
    }

    /** offset + omega x x. */
    template <unsigned int N>
    VFIFE_INLINE void rigid_field(const double *offset,
                                  const double *omega,
                                  const Vec<double, N> (&x)[4],
                                  Vec<double, N> (&u)[3])
    {
      for (unsigned int i = 0; i < 3; ++i)
        {
          const unsigned int j = (i + 1) % 3, k = (i + 2) % 3;
          u[i] = offset[i] + (omega[j] * x[k] - omega[k] * x[j]);
        }
    }

    template <unsigned int N>
    VFIFE_INLINE Vec<double, N> product(const Vec<double, N> *a, const Vec<double, N> *b)
    {
      return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    }

    /** Sums of the new state; x and v new, m zero where the node does not count. */
    template <unsigned int N, bool use_axis>
    VFIFE_INLINE void add_moments(const UpdateCoefficients &coefficients,
                                  const Vec<double, N>     &m,
                                  const Vec<double, N> (&x)[4],
                                  const Vec<double, N> (&v)[4],
                                  Vec<double, N> (&sums)[n_measured_sums])
    {
      using V = Vec<double, N>;
      if constexpr (use_axis)
        {
          V e[3];
          rigid_field<N>(coefficients.lever, coefficients.direction, x, e);
          sums[sum_of_axial_momentum] += m * product<N>(e, v);
          sums[sum_of_axial_inertia] += m * product<N>(e, e);
        }
      else
        for (unsigned int i = 0; i < 3; ++i)
          {
            const unsigned int j = (i + 1) % 3, k = (i + 2) % 3;
            sums[sum_of_momentum + i] += m * v[i];
            sums[sum_of_first_moment + i] += m * x[i];
            sums[sum_of_angular_momentum + i] += m * (x[j] * v[k] - x[k] * v[j]);
            sums[sum_of_second_moment + i] += m * x[i] * x[i];
            sums[sum_of_second_moment + 3 + i] += m * x[i] * x[j];
          }
    }

    /** What NodalMotion sums: x and v before the update, v after it, e = direction x (x - point).
     */
    template <unsigned int N>
    VFIFE_INLINE void add_motion(const Vec<double, N> &m,
                                 const Vec<double, N> (&x)[4],
                                 const Vec<double, N> (&v)[4],
                                 const Vec<double, N> (&v_new)[4],
                                 const Vec<double, N> (&e)[3],
                                 Vec<double, N> (&sums)[n_measured_sums])
    {
      using V = Vec<double, N>;
      V change[3];
      for (unsigned int i = 0; i < 3; ++i)
        {
          const unsigned int j = (i + 1) % 3, k = (i + 2) % 3;
          sums[sum_of_old_momentum + i] += m * v[i];
          sums[sum_of_old_angular_momentum + i] += m * (x[j] * v[k] - x[k] * v[j]);
          change[i] = v_new[i] - v[i];
          sums[sum_of_change + i] += m * change[i];
        }
      sums[sum_of_mass] += m;
      sums[sum_of_square_of_change] += m * product<N>(change, change);

      // |v|/r, and 1 where there is one: not on the axis.
      double speed[N], square[N], turns[N];
      product<N>(v, v).store(speed);
      product<N>(e, e).store(square);
      for (unsigned int lane = 0; lane < N; ++lane)
        {
          turns[lane] = square[lane] > 0. ? 1. : 0.;
          speed[lane] = square[lane] > 0. ? __builtin_sqrt(speed[lane] / square[lane]) : 0.;
        }
      sums[sum_of_speed] += m * V::load(speed);
      sums[sum_of_turning_mass] += m * V::load(turns);
    }

    /** One step of N nodes from @p node on: update, store, and what the sums want of both states.
     */
    template <unsigned int N, bool use_axis, bool measures>
    VFIFE_INLINE void update_block(const UpdateCoefficients &coefficients,
                                   const NodeRecords         records,
                                   const std::size_t         node,
                                   Vec<double, N> (&sums)[n_measured_sums])
    {
      // 1. Positions (and 1/m), velocities (and m), forces.
      using V = Vec<double, N>;
      V x[4], v[4], f[4];
      load_nodes<N>(records.old_positions + 4 * node, x);
      load_nodes<N>(records.old_velocities + 4 * node, v);
      load_nodes<N>(records.forces + 4 * node, f);

      // 2. The mass that counts in sums: zero where another rank owns the node.
      double counts[N];
      for (unsigned int lane = 0; lane < N; ++lane)
        counts[lane] = records.owned[node + update_lane_node<N>(lane)];
      const V m = v[3] * V::load(counts);

      // 3. Central differences with centred damping; constrained nodes have 1/m = 0.
      //    v+ = ((1 - a) v- + dt (f/m - slip) + 2 a u)/(1 + a),  x += dt v+
      V u[3], slip[3], mean[3], relative[3], x_new[4], v_new[4];
      rigid_field<N>(coefficients.velocity, coefficients.omega, x, u);
      rigid_field<N>(coefficients.slip, coefficients.slip_omega, x, slip);
      for (unsigned int i = 0; i < 3; ++i)
        {
          v_new[i] = coefficients.old_velocity * v[i] +
                     coefficients.acceleration * (x[3] * f[i] - slip[i]) +
                     coefficients.rigid * u[i];
          x_new[i]    = x[i] + coefficients.dt * v_new[i];
          mean[i]     = 0.5 * (v[i] + v_new[i]);
          relative[i] = mean[i] - u[i];
        }
      v_new[3] = v[3];
      x_new[3] = x[3];
      store_nodes<N>(x_new, records.positions + 4 * node);
      store_nodes<N>(v_new, records.velocities + 4 * node);

      // 4. T = m v- . v+/2, the powers of both dampers with v = (v- + v+)/2 at the old place, and
      // the
      //    moments of the new state, from which the next rate of the body follows.
      sums[sum_of_kinetic] += 0.5 * m * product<N>(v, v_new);
      sums[sum_of_damping_power] += m * product<N>(relative, mean);
      sums[sum_of_mesh_power] += m * product<N>(slip, mean);
      V e[3];
      if constexpr (use_axis || measures)
        rigid_field<N>(coefficients.lever, coefficients.direction, x, e);
      if constexpr (use_axis)
        sums[sum_of_damping_torque] -= m * product<N>(e, relative);
      if constexpr (measures)
        add_motion<N>(m, x, v, v_new, e, sums);
      add_moments<N, use_axis>(coefficients, m, x_new, v_new, sums);
    }

    /** As many blocks of N nodes as there are; returns the first node left over. */
    template <unsigned int N, bool use_axis, bool measures>
    VFIFE_INLINE std::size_t update_blocks(const UpdateCoefficients &coefficients,
                                           const std::size_t         first,
                                           const std::size_t         last,
                                           const NodeRecords         records,
                                           double                   *sums)
    {
      Vec<double, N> block_sums[n_measured_sums];
      for (auto &sum : block_sums)
        sum = 0.;
      std::size_t node = first;
      for (; node + N <= last; node += N)
        update_block<N, use_axis, measures>(coefficients, records, node, block_sums);
      for (unsigned int s = 0; s < (measures ? n_measured_sums : n_update_sums); ++s)
        {
          double lanes[N];
          block_sums[s].store(lanes);
          for (unsigned int lane = 0; lane < N; ++lane)
            sums[s] += lanes[lane];
        }
      return node;
    }

    /** Blocks as wide as the registers, then the nodes left over one by one. */
    template <bool use_axis, bool measures>
    VFIFE_INLINE void update_all(const UpdateCoefficients &coefficients,
                                 const std::size_t         first,
                                 const std::size_t         last,
                                 const NodeRecords         records,
                                 double                   *sums)
    {
      const std::size_t rest = update_blocks<VFIFE_KERNEL_WIDTH, use_axis, measures>(
        coefficients, first, last, records, sums);
      update_blocks<1, use_axis, measures>(coefficients, rest, last, records, sums);
    }

    /** update_all() with the sums that are asked for. */
    template <bool use_axis, typename... Arguments>
    VFIFE_INLINE void update_for(const UpdateCoefficients &coefficients, Arguments... arguments)
    {
      if (coefficients.measures)
        update_all<use_axis, true>(coefficients, arguments...);
      else
        update_all<use_axis, false>(coefficients, arguments...);
    }

    UpdateFunction update_kernel;

    void update_kernel(const UpdateCoefficients &coefficients,
                       const std::size_t         first,
                       const std::size_t         last,
                       const NodeRecords         records,
                       double                   *sums)
    {
      if (coefficients.use_axis)
        update_for<true>(coefficients, first, last, records, sums);
      else
        update_for<false>(coefficients, first, last, records, sums);
    }
  } // namespace VFIFE_SIMD_NAMESPACE
} // namespace vfife
