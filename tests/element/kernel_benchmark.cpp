// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// Element-steps per second of the kernels on one core, beside what the core can do at that moment.
// Not a test (hence .cpp). Compile it with the library's element sources; see doc/element.md.
#include "samples.h"

#include <chrono>
#include <cstdio>
#include <functional>

using namespace vfife;

namespace
{
  constexpr unsigned int n_x = 25, n_y = 25, n_z = 20;

  /** Best of several repetitions [s]. */
  double seconds(const std::function<void()> &loop)
  {
    double best = 1e300;
    for (unsigned int repetition = 0; repetition < 7; ++repetition)
      {
        const auto start = std::chrono::steady_clock::now();
        loop();
        best =
          std::min(best,
                   std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
      }
    return best;
  }

  Vector3 grid_point(const unsigned int i, const unsigned int j, const unsigned int k)
  {
    return {10. + 0.4 * i + 0.05 * std::sin(1. * j), 0.5 * j + 0.05 * std::sin(2. * k), 0.6 * k};
  }

  /**
   * 100,000 elements: @p shared: eight rotated copies of a block, one a lane, node records of the
   * copies side by side and constants of each element of one block; else one block eight times as
   * long.
   */
  SamplePacks make_packs(const bool shared)
  {
    const unsigned int length = shared ? n_x : 8 * n_x;
    const std::size_t  n_grid = (length + 1) * (n_y + 1) * (n_z + 1);
    const Material     material;
    SamplePacks        packs;
    packs.resize(n_x * n_y * n_z, shared ? n_lanes * n_grid : n_grid);
    const auto node = [&](const unsigned int i, const unsigned int j, const unsigned int k) {
      return (i * (n_y + 1) + j) * (n_z + 1) + k;
    };
    const auto motion = [](const Vector3 &X, const double angle) -> Vector3 {
      return rotation_about(Vector3::UnitZ(), angle) *
             Vector3(X + 1e-3 * Vector3(X[1], X[0], -0.3 * X[2]));
    };
    std::size_t element = 0;
    for (unsigned int i = 0; i < length; ++i)
      for (unsigned int j = 0; j < n_y; ++j)
        for (unsigned int k = 0; k < n_z; ++k, ++element)
          {
            HexahedronNodes X;
            for (unsigned int a = 0; a < 8; ++a)
              {
                const unsigned int ia = i + (a & 1), ja = j + (a >> 1 & 1), ka = k + (a >> 2);
                X.col(a) = grid_point(ia, ja, ka);
                for (unsigned int lane = 0; lane < (shared ? n_lanes : 1); ++lane)
                  {
                    const std::size_t n =
                      shared ? n_lanes * node(ia, ja, ka) + lane : node(ia, ja, ka);
                    packs.set_position(n, motion(X.col(a), 1. + 0.25 * pi * lane));
                    if (shared)
                      packs.set_node(element, lane, a, n);
                    else
                      packs.set_node(element / n_lanes, element % n_lanes, a, n);
                  }
              }
            const ReducedStiffness reduced =
              compute_reduced_stiffness(X, material, StiffnessKind::incompatible_modes);
            if (shared)
              {
                packs.constants.resize((element + 1) * n_element_constants);
                write_constants(reduced, material, &packs.constants[element * n_element_constants]);
                packs.constants_row.push_back(element);
              }
            else
              packs.set_constants(element / n_lanes, element % n_lanes, reduced, material);
          }
    return packs;
  }
} // namespace

/** Bytes read per second by a sum over 256 MB [GB/s]; the target flags decide the width. */
__attribute__((target("avx2"))) double bandwidth()
{
  typedef double            Four __attribute__((vector_size(32)));
  const std::vector<double> memory(std::size_t(1) << 25, 1.);
  volatile double           keep = 0.;
  const double              time = seconds([&]() __attribute__((target("avx2"))) {
                 Four sum[8] = {};
                 for (std::size_t i = 0; i < memory.size(); i += 32)
      for (unsigned int u = 0; u < 8; ++u)
        {
                       Four value;
                       __builtin_memcpy(&value, &memory[i + 4 * u], sizeof(Four));
                       sum[u] += value;
        }
    for (unsigned int u = 0; u < 8; ++u)
      keep = keep + sum[u][0];
  });
  return 8e-9 * memory.size() / time;
}

/** Multiply-adds of 512-bit (256-bit) registers, two flops each [GFLOP/s]. */
__attribute__((target("avx512f"))) double flops_avx512()
{
  typedef double  Eight __attribute__((vector_size(64)));
  volatile double keep = 0.;
  const double    time = seconds([&]() __attribute__((target("avx512f"))) {
       const Eight factor = 0.999999 - Eight{};
       Eight       x[12]  = {};
       for (unsigned int i = 0; i < 1000000; ++i)
#pragma GCC unroll 12
      for (unsigned int u = 0; u < 12; ++u)
        x[u] = x[u] * factor + factor;
    for (unsigned int u = 0; u < 12; ++u)
      keep = keep + x[u][0];
  });
  return 1e-9 * 1e6 * 12 * 8 * 2 / time;
}

int main()
{
  const bool wide = is_available(InstructionSet::avx512);
  for (const bool shared : {true, false})
    {
      const SamplePacks   packs = make_packs(shared);
      std::vector<double> forces(packs.positions.size(), 0.), energies(packs.n_packs() * n_lanes);
      std::printf("%s constants, %zu elements\n", shared ? "shared" : "own", packs.n_packs() * 8);
      for (const InstructionSet set : {InstructionSet::generic,
                                       InstructionSet::sse2,
                                       InstructionSet::avx2,
                                       InstructionSet::avx512})
        for (const FrameKind frame : {FrameKind::polar, FrameKind::three_nodes})
          if (is_available(set))
            {
              const ElementKernels &kernels    = select_kernels(frame, set);
              const double          read       = bandwidth();
              const double          arithmetic = wide ? flops_avx512() : 0.;
              const double          plain      = seconds([&]() {
                kernels.add_internal_forces(
                  packs.view(), 0, packs.n_packs(), packs.positions.data(), forces.data());
              });
              const double          energetic  = seconds([&]() {
                kernels.add_internal_forces_and_energies(packs.view(),
                                                         0,
                                                         packs.n_packs(),
                                                         packs.positions.data(),
                                                         forces.data(),
                                                         energies.data());
              });
              const double          n          = 1e-6 * 8 * packs.n_packs();
              const double constants_gb = 8e-3 * n_element_constants * n * (shared ? 0.125 : 1.);
              std::printf("  %-8s %-12s %6.2f M/s, with energies %6.2f M/s; "
                          "read loop %.1f GB/s (constants use %2.0f %%), FMA loop %.0f GFLOP/s\n",
                          name_of(set),
                          frame == FrameKind::polar ? "polar" : "three nodes",
                          n / plain,
                          n / energetic,
                          read,
                          100. * constants_gb / plain / read,
                          arithmetic);
            }
    }
}
