// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_element_internal_force_h
#define vfife_element_internal_force_h

#include <vfife/element/frame.h>

namespace vfife
{
  /**
   * Strain energy 1/2 u^T K u [mJ] with u of compute_local_displacements(). The reference for the
   * kernels: dense and exact where they are short and use series.
   */
  double compute_strain_energy(const Matrix24        &K,
                               const HexahedronNodes &X,
                               const HexahedronNodes &x,
                               FrameKind              frame);

  /**
   * Restoring forces on the nodes [N], one column a node, with the stiffness @p K of reference @p
   * X.
   *
   * three_nodes: -R K u, as published; forces sum to zero, moments only to O(strain^2).
   * polar: exactly minus the derivative of compute_strain_energy(), -R (K u - t x b), where
   * t = (tr U I - U)^-1 sum_a y_a x (K u)_a with y = R^T x, the part that comes from the turning of
   * the frame. Forces and moments sum to zero, and energy is conserved.
   */
  HexahedronNodes compute_internal_forces(const Matrix24        &K,
                                          const HexahedronNodes &X,
                                          const HexahedronNodes &x,
                                          FrameKind              frame);
} // namespace vfife

#endif
