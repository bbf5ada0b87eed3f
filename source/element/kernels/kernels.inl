// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
/**
 * The element loop on vectors of VFIFE_KERNEL_WIDTH lanes, included once by each file compiled for
 * an instruction set, which defines that and VFIFE_SIMD_NAMESPACE. Derivation:
 * doc/theory/element.md.
 */
#include "kernels_constants.h"
#include "kernels_frames.h"
#include "kernels_records.h"

namespace vfife
{
  inline namespace VFIFE_SIMD_NAMESPACE
  {

    /** out += H q from the upper triangle. */
    template <unsigned int row, unsigned int column, unsigned int entry, typename Constants>
    VFIFE_INLINE void add_hourglass_product(const Constants &constants, const V *q, V *out)
    {
      const V h = constants.hourglass(entry);
      out[row] += h * q[column];
      if constexpr (row != column)
        out[column] += h * q[row];
      if constexpr (column < 11)
        add_hourglass_product<row, column + 1, entry + 1>(constants, q, out);
      else if constexpr (row < 11)
        add_hourglass_product<row + 1, row + 1, entry + 1>(constants, q, out);
    }

    /** Sums sum_a h_k(a) d(a) of one component of d over the nodes, k = 0..3. */
    VFIFE_INLINE void compute_hourglass_sums(const V (&d)[8][3], const unsigned int i, V *sums)
    {
      // Sums and differences along xi of the four edges (named by eta, zeta) serve all patterns.
      const V sum00 = d[0][i] + d[1][i], dif00 = d[1][i] - d[0][i];
      const V sum10 = d[2][i] + d[3][i], dif10 = d[3][i] - d[2][i];
      const V sum01 = d[4][i] + d[5][i], dif01 = d[5][i] - d[4][i];
      const V sum11 = d[6][i] + d[7][i], dif11 = d[7][i] - d[6][i];
      sums[0] = (sum00 - sum10) - (sum01 - sum11);
      sums[1] = (dif01 + dif11) - (dif00 + dif10);
      sums[2] = (dif10 - dif00) + (dif11 - dif01);
      sums[3] = (dif11 - dif01) - (dif10 - dif00);
    }

    /** out(a) = sum_k h_k(a) p_k of one component. */
    VFIFE_INLINE void spread_hourglass(const V &p0, const V &p1, const V &p2, const V &p3, V *out)
    {
      // At the edge (eta, zeta) the pattern p0 eta zeta is the same at both ends, that of the
      // others, xi (p1 zeta + p2 eta + p3 eta zeta), has both signs: odd.
      const V sum = p1 + p2, difference = p1 - p2;
      const V odd00 = p3 - sum, odd10 = -p3 - difference, odd01 = difference - p3, odd11 = sum + p3;
      out[0] = p0 - odd00;
      out[1] = p0 + odd00;
      out[2] = -p0 - odd10;
      out[3] = odd10 - p0;
      out[4] = -p0 - odd01;
      out[5] = odd01 - p0;
      out[6] = p0 - odd11;
      out[7] = p0 + odd11;
    }

    /**
     * Axial vector t of the stress that the turning of the polar frame adds, so that the force is
     * exactly the derivative of the energy: (tr U I - U) t = sum_k q_k x (H q)_k.
     */
    VFIFE_INLINE void
    compute_frame_moment(const V (&strain)[6], const V *q, const V *hourglass, V (&t)[3])
    {
      // sum_k q_k x (H q)_k
      V moment[3];
      for (unsigned int i = 0; i < 3; ++i)
        {
          const unsigned int j = (i + 1) % 3, k = (i + 2) % 3;
          moment[i] = q[j] * hourglass[k] - q[k] * hourglass[j];
          for (unsigned int pattern = 1; pattern < 4; ++pattern)
            moment[i] += q[3 * pattern + j] * hourglass[3 * pattern + k] -
                         q[3 * pattern + k] * hourglass[3 * pattern + j];
        }
      // tr U I - U with U = I + strain, inverted by its cofactors.
      const V xx = 2. + strain[1] + strain[2], yy = 2. + strain[2] + strain[0],
              zz = 2. + strain[0] + strain[1];
      const V xy = -strain[3], yz = -strain[4], zx = -strain[5];
      const V cxx = yy * zz - yz * yz, cyy = xx * zz - zx * zx, czz = xx * yy - xy * xy;
      const V cxy = yz * zx - xy * zz, cyz = xy * zx - xx * yz, czx = xy * yz - yy * zx;
      // The determinant is about 8, but zero in empty lanes, whose moment is zero.
      const V scale = 1. / (xx * cxx + xy * cxy + zx * czx + 1e-30);
      t[0]          = scale * (cxx * moment[0] + cxy * moment[1] + czx * moment[2]);
      t[1]          = scale * (cxy * moment[0] + cyy * moment[1] + cyz * moment[2]);
      t[2]          = scale * (czx * moment[0] + cyz * moment[1] + czz * moment[2]);
    }

    /** Least det(dx/dxi) of the corners: an eighth of the triple product of the edges there. */
    VFIFE_INLINE V compute_least_corner(const V (&d)[8][3])
    {
      V least = 1e300;
      for (unsigned int a = 0; a < 8; ++a)
        {
          V edge[3][3];
          for (unsigned int direction = 0; direction < 3; ++direction)
            for (unsigned int i = 0; i < 3; ++i)
              edge[direction][i] = d[a | (1u << direction)][i] - d[a & ~(1u << direction)][i];
          V triple = 0.;
          for (unsigned int i = 0; i < 3; ++i)
            {
              const unsigned int j = (i + 1) % 3, k = (i + 2) % 3;
              triple += edge[0][i] * (edge[1][j] * edge[2][k] - edge[1][k] * edge[2][j]);
            }
          least = min(least, triple);
        }
      return .125 * least;
    }

    /** Mean deformation gradient F from the positions @p d relative to node 0. */
    template <typename Constants>
    VFIFE_INLINE void
    compute_deformation_gradient(const Constants &constants, const V (&d)[8][3], V (&F)[3][3])
    {
      for (unsigned int j = 0; j < 3; ++j)
        {
          const V b1 = gradient(constants, 1, j);
          for (unsigned int i = 0; i < 3; ++i)
            F[i][j] = d[1][i] * b1;
        }
      for (unsigned int a = 2; a < 8; ++a)
        for (unsigned int j = 0; j < 3; ++j)
          {
            const V ba = gradient(constants, a, j);
            for (unsigned int i = 0; i < 3; ++i)
              F[i][j] += d[a][i] * ba;
          }
    }

    /** Hourglass amplitudes @p g in the axes of space: sum_a h_k(a) d(a) less their linear part. */
    template <typename Constants>
    VFIFE_INLINE void compute_hourglass_amplitudes(const Constants &constants,
                                                   const V (&d)[8][3],
                                                   const V (&F)[3][3],
                                                   V (&g)[12])
    {
      for (unsigned int i = 0; i < 3; ++i)
        {
          V sums[4];
          compute_hourglass_sums(d, i, sums);
          for (unsigned int k = 0; k < 4; ++k)
            g[3 * k + i] = sums[k] - pattern(constants, k, 0) * F[i][0] -
                           pattern(constants, k, 1) * F[i][1] - pattern(constants, k, 2) * F[i][2];
        }
    }

    /** Volume times the mean stress in the frame, xx, yy, zz, xy, yz, zx, from the strain there. */
    template <typename Constants>
    VFIFE_INLINE void
    compute_stress(const Constants &constants, const V (&strain)[6], V (&stress)[6])
    {
      const V two_mu   = constants[start_of_moduli + 1];
      const V pressure = constants[start_of_moduli] * (strain[0] + strain[1] + strain[2]);
      for (unsigned int i = 0; i < 6; ++i)
        stress[i] = two_mu * strain[i] + (i < 3 ? pressure : V(0.));
    }

    /**
     * Forces @p f of the nodes in the axes of space: p_k = R (H q)_k, and P = R local less what the
     * patterns owe to the gradients.
     */
    template <typename Constants>
    VFIFE_INLINE void compute_nodal_forces(const Constants &constants,
                                           const V (&R)[3][3],
                                           const V (&local)[3][3],
                                           const V (&hourglass)[12],
                                           V (&f)[8][3])
    {
      for (unsigned int i = 0; i < 3; ++i)
        {
          V p[4], P[3];
          for (unsigned int k = 0; k < 4; ++k)
            p[k] = R[i][0] * hourglass[3 * k] + R[i][1] * hourglass[3 * k + 1] +
                   R[i][2] * hourglass[3 * k + 2];
          for (unsigned int j = 0; j < 3; ++j)
            P[j] = (R[i][0] * local[0][j] + R[i][1] * local[1][j] + R[i][2] * local[2][j]) -
                   (p[0] * pattern(constants, 0, j) + p[1] * pattern(constants, 1, j)) -
                   (p[2] * pattern(constants, 2, j) + p[3] * pattern(constants, 3, j));
          V force[8];
          spread_hourglass(p[0], p[1], p[2], p[3], force);
          V sum = 0.;
          for (unsigned int a = 1; a < 8; ++a)
            {
              f[a][i] = force[a] + P[0] * gradient(constants, a, 0) +
                        P[1] * gradient(constants, a, 1) + P[2] * gradient(constants, a, 2);
              sum += f[a][i];
            }
          f[0][i] = -sum;
        }
    }

    /**
     * Forces f = dW/dx of the nodes (in place of the positions @p d relative to node 0), returns
     * twice the strain energy W.
     */
    template <FrameKind frame_kind, bool measures, typename Constants>
    VFIFE_INLINE V compute_element(const Constants &constants, V (&d)[8][3])
    {
      // F = sum_a d(a) b(a)^T and g_k = sum_a h_k(a) d(a) - F c_k, in the axes of space.
      V F[3][3], g[12];
      compute_deformation_gradient(constants, d, F);
      compute_hourglass_amplitudes(constants, d, F, g);

      // Only now the rotation: F gives it, and the strain e = sym(R^T F) - I in the frame.
      static_assert(frame_kind == FrameKind::polar || frame_kind == FrameKind::three_nodes,
                    "another frame has its rotation here and what it adds to the forces below");
      Frame<width> frame;
      if constexpr (frame_kind == FrameKind::polar)
        frame = compute_polar_frame<width>(F);
      else
        frame = compute_three_node_frame<width>(F,
                                                d[1],
                                                d[2],
                                                [&](const unsigned int i, const unsigned int j) {
                                                  return constants[start_of_triad + 3 * i + j];
                                                });
      const V(&R)[3][3]   = frame.R;
      const V(&strain)[6] = frame.strain;

      // q_k = R^T g_k and H q, the forces of the patterns in the frame.
      V q[12], hourglass[12];
      for (unsigned int k = 0; k < 4; ++k)
        for (unsigned int i = 0; i < 3; ++i)
          {
            q[3 * k + i] = R[0][i] * g[3 * k] + R[1][i] * g[3 * k + 1] + R[2][i] * g[3 * k + 2];
            hourglass[3 * k + i] = 0.;
          }
      add_hourglass_product<0, 0, 0>(constants, q, hourglass);

      // S = V (lambda tr e I + 2 mu e)
      V stress[6];
      compute_stress(constants, strain, stress);

      // 2 W = S : e + q . H q; shears of a symmetric matrix count twice.
      V twice_energy = 0.;
      if constexpr (measures)
        {
          for (unsigned int i = 0; i < 3; ++i)
            twice_energy += stress[i] * strain[i] + 2. * (stress[3 + i] * strain[3 + i]);
          for (unsigned int m = 0; m < 12; ++m)
            twice_energy += q[m] * hourglass[m];
        }

      // Nodal forces follow from R S; in the polar frame from R (S - [t]), what
      // turns with the nodes included.
      V local[3][3] = {{stress[0], stress[3], stress[5]},
                       {stress[3], stress[1], stress[4]},
                       {stress[5], stress[4], stress[2]}};
      if constexpr (frame_kind == FrameKind::polar)
        {
          V t[3];
          compute_frame_moment(strain, q, hourglass, t);
          local[0][1] += t[2];
          local[1][0] -= t[2];
          local[1][2] += t[0];
          local[2][1] -= t[0];
          local[2][0] += t[1];
          local[0][2] -= t[1];
        }

      compute_nodal_forces(constants, R, local, hourglass, d);
      return twice_energy;
    }

    template <FrameKind frame_kind, bool measures, typename Constants>
    VFIFE_INLINE void add_lanes(const Constants     &constants,
                                const std::uint32_t *nodes,
                                const double        *positions,
                                double              *forces,
                                double              *energies,
                                double              *jacobians)
    {
      // d(a) = x(a) - x(0): differences before products, so that nothing
      // depends on the place in space.
      V d[8][3];
      for (unsigned int a = 0; a < 8; ++a)
        load_records<width>(positions, nodes + n_lanes * a, d[a]);
      for (unsigned int a = 1; a < 8; ++a)
        for (unsigned int i = 0; i < 3; ++i)
          d[a][i] -= d[0][i];
      for (unsigned int i = 0; i < 3; ++i)
        d[0][i] = 0.;

      // The least Jacobian first, for the forces take the place of d.
      if constexpr (measures)
        compute_least_corner(d).store(jacobians);
      const V twice_energy = compute_element<frame_kind, measures>(constants, d);
      for (unsigned int a = 0; a < 8; ++a)
        subtract_from_records<width>(forces, nodes + n_lanes * a, d[a]);
      if constexpr (measures)
        (0.5 * twice_energy).store(energies);
    }

    template <FrameKind frame_kind, bool measures>
    VFIFE_INLINE void add_packs(const ElementPacks &packs,
                                const std::size_t   first,
                                const std::size_t   last,
                                const double       *positions,
                                double             *forces,
                                double             *energies,
                                double             *jacobians)
    {
      // A pack is worked on in 8 / width turns. Which constants it has is asked once
      // a turn, outside all arithmetic.
      for (std::size_t pack = first; pack < last; ++pack)
        for (unsigned int lane = 0; lane < n_lanes; lane += width)
          {
            const std::uint32_t *nodes = packs.nodes + 8 * n_lanes * pack + lane;
            const std::size_t    slot  = measures ? n_lanes * pack + lane : 0;
            const auto           add   = [&](const auto &constants) {
              add_lanes<frame_kind, measures>(
                constants, nodes, positions, forces, energies + slot, jacobians + slot);
            };
            if (packs.constants_row != nullptr)
              add(SharedConstants{packs.constants +
                                  n_element_constants * std::size_t(packs.constants_row[pack])});
            else if (packs.hourglass != nullptr)
              add(OwnConstantsSingle{
                packs.constants + OwnConstantsSingle::n_kept * n_lanes * pack + lane,
                packs.hourglass + n_hourglass_constants * n_lanes * pack + lane});
            else
              add(OwnConstants{packs.constants + n_element_constants * n_lanes * pack + lane});
          }
    }

    template <FrameKind frame_kind>
    void add_internal_forces(const ElementPacks &packs,
                             const std::size_t   first,
                             const std::size_t   last,
                             const double       *positions,
                             double             *forces)
    {
      add_packs<frame_kind, false>(packs, first, last, positions, forces, nullptr, nullptr);
    }

    template <FrameKind frame_kind>
    void measure_internal_forces(const ElementPacks &packs,
                                 const std::size_t   first,
                                 const std::size_t   last,
                                 const double       *positions,
                                 double             *forces,
                                 double             *energies,
                                 double             *jacobians)
    {
      add_packs<frame_kind, true>(packs, first, last, positions, forces, energies, jacobians);
    }

    /** In the order of FrameKind. */
    extern const ElementKernels element_kernels[n_frame_kinds];
    const ElementKernels        element_kernels[n_frame_kinds] = {
             {VFIFE_INSTRUCTION_SET_TEXT,
              &add_internal_forces<FrameKind::polar>,
              &measure_internal_forces<FrameKind::polar>},
             {VFIFE_INSTRUCTION_SET_TEXT,
              &add_internal_forces<FrameKind::three_nodes>,
              &measure_internal_forces<FrameKind::three_nodes>}};
  } // namespace VFIFE_SIMD_NAMESPACE
} // namespace vfife
