// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_element_reduced_stiffness_h
#define vfife_element_reduced_stiffness_h

#include <vfife/element/kernels/kernels.h>
#include <vfife/element/stiffness.h>

namespace vfife
{
  /**
   * The exact short form of the stiffness of an 8-node hexahedron (doc/theory/element.md):
   * K = V B^T D B + G^T H G, B the strain of the volume-averaged gradients b, G u the four
   * hourglass amplitudes q_k = sum_a gamma_k(a) u_a with the patterns
   * gamma_k = h_k - sum_j c_kj b_j, c_kj = sum_a h_k(a) X_j(a), and h_k(a) = hourglass_sign(k, a).
   * Holds for every stiffness that passes the patch test with the mean gradients: all members of
   * StiffnessKind.
   */
  struct ReducedStiffness
  {
    double gradient[8][3];            ///< b_j(a) [1/mm]
    double pattern_coefficient[4][3]; ///< c_kj [mm]
    double volume;                    ///< V [mm^3]
    /** H [N/mm], row 3 * pattern + component, upper triangle row by row. */
    double hourglass_stiffness[78];
    double triad[3][3]; ///< compute_triad(X), rows are components
  };

  /** Throws NumericalError when det J <= 0 at a Gauss point. */
  ReducedStiffness
  compute_reduced_stiffness(const HexahedronNodes &X, const Material &material, StiffnessKind kind);

  /** The 24 x 24 matrix that the short form stands for [N/mm]. */
  Matrix24 expand(const ReducedStiffness &reduced, const Material &material);

  /** Writes the @p n_element_constants numbers of kernels.h, one after the other. */
  void write_constants(const ReducedStiffness &reduced, const Material &material, double *out);
} // namespace vfife

#endif
