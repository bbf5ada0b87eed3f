// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_tests_benchmark_plain_elements_h
#define vfife_tests_benchmark_plain_elements_h

#include <vfife/element/frame_kind.h>
#include <vfife/element/stiffness.h>
#include <vfife/model/body.h>

#include <array>
#include <cstdint>
#include <vector>

namespace vfife
{
  /**
   * What the operator is compared with: one element after the other, each with its dense 24 x 24
   * stiffness, -R K u with R from three nodes or the polar decomposition of the mean gradient.
   * Kept for the benchmark only.
   */
  class PlainElements
  {
  public:
    /** The first @p n_elements of @p body. */
    PlainElements(const Body &body, StiffnessKind stiffness, unsigned int n_elements);

    /** Adds restoring forces [N]; records of four numbers a node of the body, as the kernels'. */
    void add_internal_forces(FrameKind frame, const double *positions, double *forces) const;

    std::size_t size() const;

  private:
    struct Element
    {
      Matrix24                     stiffness;
      HexahedronNodes              reference;
      Eigen::Matrix<double, 3, 8>  gradients;
      Matrix3                      triad;
      std::array<std::uint32_t, 8> nodes;
    };

    std::vector<Element> elements_;
  };
} // namespace vfife

#endif
